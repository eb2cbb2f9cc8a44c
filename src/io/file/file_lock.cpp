#include "io/file/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "changeover/core/error.hpp"
#include "io/file/left_behind.hpp"

namespace changeover {
namespace {

constexpr std::string_view lock_words = "changeover: a process works with the file beside this\n";

}  // namespace

// All names of a file have the same lock.
FileLock::FileLock(const std::string& path) {
  const auto target = behind_links(path);
  if (!target) {
    throw MissingResource(path + ": symbolic links lead in a circle; correct them");
  }
  lock_path_ = target->string() + ".lock";
  acquire(path);
}

// The last owner of the lock removes its file: a process that locked a removed file tries again
// with the new one.
void FileLock::acquire(const std::string& path) {
  bool made = false;
  while (true) {
    constexpr int flags = O_RDWR | O_CLOEXEC | O_NOFOLLOW;
    descriptor_ = ::open(lock_path_.c_str(), flags | O_CREAT | O_EXCL, 0666);
    made = descriptor_ >= 0;
    if (!made && errno == EEXIST) {
      descriptor_ = ::open(lock_path_.c_str(), flags);
      if (descriptor_ < 0 && errno == ENOENT) {
        continue;  // It has just been removed.
      }
    }
    if (descriptor_ < 0) {
      throw MissingResource(
          fmt::format("{}: cannot write {}: {}; allow writing there, or write elsewhere", path,
                      lock_path_, std::strerror(errno)));
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int error = errno;
      ::close(descriptor_);
      if (error == EINTR) {
        continue;
      }
      throw MissingResource(
          error == EWOULDBLOCK
              ? fmt::format("{}: another process is using it; wait until it finishes, or name "
                            "another file",
                            path)
              : fmt::format("{}: cannot lock {}: {}; write elsewhere", path, lock_path_,
                            std::strerror(error)));
    }
    struct stat mine {};
    struct stat there {};
    if (::fstat(descriptor_, &mine) == 0 && ::lstat(lock_path_.c_str(), &there) == 0 &&
        mine.st_dev == there.st_dev && mine.st_ino == there.st_ino) {
      break;
    }
    ::close(descriptor_);
  }
  // A file of another kind that happens to have this name is left alone. An empty one is used as
  // the lock but not removed, because its owner is unknown. A lock that a killed search left has
  // our words in it.
  std::array<char, lock_words.size() + 1> content{};
  const ssize_t length = ::pread(descriptor_, content.data(), content.size(), 0);
  if (length == 0 && made) {
    is_ours_ = ::pwrite(descriptor_, lock_words.data(), lock_words.size(), 0) ==
               static_cast<ssize_t>(lock_words.size());
  } else if (length == static_cast<ssize_t>(lock_words.size()) &&
             std::string_view(content.data(), lock_words.size()) == lock_words) {
    is_ours_ = true;
  } else if (length != 0) {
    ::close(descriptor_);
    throw BadInput(
        fmt::format("{}: not a lock file; move it away, or name another file than the one it "
                    "would lock",
                    lock_path_));
  }
}

FileLock::~FileLock() {
  if (is_ours_) {
    ::unlink(lock_path_.c_str());
  }
  ::close(descriptor_);
}

}  // namespace changeover
