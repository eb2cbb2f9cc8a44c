#include "io/file/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "changeover/core/error.hpp"
#include "io/file/left_behind.hpp"
#include "io/file/unfinished.hpp"

namespace changeover {
namespace {

constexpr std::string_view lock_words = "changeover: a process works with the file beside this\n";

std::string content_of(int descriptor) {
  std::string content(lock_words.size() + 1, '\0');
  const ssize_t length = ::pread(descriptor, content.data(), content.size(), 0);
  content.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return content;
}

// On a full disk our words may be there only in part.
bool has_our_words(const std::string& content) {
  return !content.empty() && lock_words.starts_with(content);
}

// While a lock is made or given up, this thread puts off the signals that would end the process: a
// lock that is not noted as unfinished would stay.
class SignalsPutOff {
 public:
  SignalsPutOff() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
      ::sigaddset(&signals, each);
    }
    ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
  }
  ~SignalsPutOff() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsPutOff(const SignalsPutOff&) = delete;
  SignalsPutOff& operator=(const SignalsPutOff&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

// All names of a file have the same lock.
FileLock::FileLock(const std::string& path) {
  const auto target = behind_links(path);
  if (!target) {
    throw MissingResource(path + ": symbolic links lead in a circle; correct them");
  }
  lock_path_ = target->string() + ".lock";
  const SignalsPutOff put_off;
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
    if (made) {
      // At once: another process can have the lock before us, and then it removes our file.
      (void)!::pwrite(descriptor_, lock_words.data(), lock_words.size(), 0);
    } else if (errno == EEXIST) {
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
  // A file of another kind that happens to have this name is left alone. A lock that a killed
  // process left has our words in it; an empty one may have an owner who has yet to write them.
  const std::string content = content_of(descriptor_);
  if (made || has_our_words(content)) {
    removes_ = true;
    slot_ = note_unfinished(lock_path_);
  } else if (!content.empty()) {
    ::close(descriptor_);
    throw BadInput(
        fmt::format("{}: not a lock file; move it away, or name another file than the one it "
                    "would lock",
                    lock_path_));
  }
}

FileLock::~FileLock() {
  // Forgotten first: what has this name once it is removed is the lock of another process.
  const SignalsPutOff put_off;
  forget_unfinished(slot_);
  if (removes_ || has_our_words(content_of(descriptor_))) {
    ::unlink(lock_path_.c_str());
  }
  ::close(descriptor_);
}

}  // namespace changeover
