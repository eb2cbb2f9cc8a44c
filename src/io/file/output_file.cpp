#include "changeover/io/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "changeover/core/error.hpp"
#include "io/file/left_behind.hpp"
#include "io/file/remedies.hpp"
#include "io/file/unfinished.hpp"

namespace changeover {
namespace {

[[noreturn]] void cannot_write(const std::string& path, int error) {
  const std::string line =
      fmt::format("{}: cannot write: {}; {}", path, std::strerror(error), how_to_write(error));
  if (error == EPIPE || error == ECONNRESET) {
    throw ReaderGone(line);
  }
  throw MissingResource(line);
}

}  // namespace

struct OutputFile::State {
  std::string name;       // for messages
  std::string target;     // what a regular file becomes by commit(); empty if written directly
  std::string temporary;  // its path until then
  int slot = -1;
  int descriptor = -1;
  int lock = -1;          // another descriptor of the same file, which holds its lock
  bool owned = false;     // the descriptor is ours to close
  bool standard = false;  // standard output, whose number another file can have if it was closed
  int failure = 0;        // the first error of the system; from then on the bytes are not whole
  std::vector<char> buffer;

  static constexpr std::size_t buffer_bytes = std::size_t{1} << 16;

  [[noreturn]] void fail(int error) {
    failure = failure != 0 ? failure : error;
    cannot_write(name, failure);
  }

  // A caller that continues after a fault must not end with a file that has a hole in it.
  void require_whole() {
    if (failure != 0) {
      fail(failure);
    }
  }

  void write_through(std::string_view bytes) {
    require_whole();
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
      if (count >= 0) {
        bytes.remove_prefix(static_cast<std::size_t>(count));
      } else if (errno == EAGAIN) {  // a stream shared with a program that made it non-blocking
        pollfd ready{.fd = descriptor, .events = POLLOUT, .revents = 0};
        ::poll(&ready, 1, -1);
      } else if (errno != EINTR) {
        fail(errno);
      }
    }
  }

  void flush() {
    const std::string_view bytes(buffer.data(), buffer.size());
    write_through(bytes);
    buffer.clear();
  }

  void close() {
    if (owned && descriptor >= 0) {
      const int result = ::close(descriptor);
      descriptor = -1;
      if (result != 0 && errno != EINTR) {
        fail(errno);
      }
    }
  }

  // Makes the new name as durable as the bytes. A failure is ignored: the file is in place by then,
  // and some file systems cannot do this.
  void sync_folder() const {
    const std::size_t slash = target.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : target.substr(0, slash + 1);
    const int directory = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory >= 0) {
      ::fsync(directory);
      ::close(directory);
    }
  }

  // Creates the temporary beside the target, with the permissions that the target will have.
  void create_temporary(const std::filesystem::path& path, const struct stat* old) {
    static std::atomic<unsigned> counter = 0;
    const std::filesystem::path folder = path.parent_path();
    // The name of a file can be as long as NAME_MAX; ours must not be longer.
    const std::string stem = path.filename().string().substr(0, 200);
    remove_left_behind(folder, stem);
    for (int attempt = 0; attempt < 100; ++attempt) {
      temporary = (folder / fmt::format(".{}.{}-{}.tmp", stem, ::getpid(), counter++)).string();
      slot = note_unfinished(temporary);
      descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor >= 0 && claim_temporary(descriptor, temporary)) {
        break;
      }
      const int error = descriptor >= 0 ? EEXIST : errno;
      forget_unfinished(slot);
      if (descriptor >= 0) {
        ::close(descriptor);
        descriptor = -1;
      }
      if (error != EEXIST) {
        cannot_write(name, error);
      }
    }
    if (descriptor < 0) {
      cannot_write(name, EEXIST);
    }
    owned = true;
    if (old != nullptr) {
      // Only root can change owners; for others the new file is theirs, as with any replaced file.
      if (::fchown(descriptor, old->st_uid, old->st_gid) != 0) {
        errno = 0;
      }
      ::fchmod(descriptor, old->st_mode & 07777);
    }
  }

  void release() noexcept {
    if (lock >= 0) {
      ::close(lock);
      lock = -1;
    }
  }

  void discard() noexcept {
    if (owned && descriptor >= 0) {
      ::close(descriptor);
      descriptor = -1;
    }
    if (!temporary.empty()) {
      ::unlink(temporary.c_str());
      forget_unfinished(slot);
      temporary.clear();
    }
    release();
  }
};

OutputFile::OutputFile(const std::string& path) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.buffer.reserve(State::buffer_bytes);
  if (path.empty() || path == "-") {
    s.name = "<stdout>";
    s.descriptor = STDOUT_FILENO;
    s.standard = true;
    return;
  }
  s.name = path;
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) {
    cannot_write(path, errno);
  }
  if ((exists && S_ISDIR(status.st_mode)) || path.back() == '/') {
    cannot_write(path, exists ? EISDIR : ENOENT);
  }
  if (exists && !S_ISREG(status.st_mode)) {
    s.descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (s.descriptor < 0) {
      cannot_write(path, errno);
    }
    s.owned = true;
    return;
  }
  // Renaming would replace a file that is write-protected.
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    cannot_write(path, errno);
  }
  const auto target = behind_links(path);
  if (!target) {
    cannot_write(path, ELOOP);
  }
  s.target = target->string();
  s.create_temporary(*target, exists ? &status : nullptr);
}

OutputFile::~OutputFile() {
  if (state_) {
    state_->discard();
  }
}

void OutputFile::write(std::string_view bytes) {
  State& s = *state_;
  const bool large = bytes.size() >= State::buffer_bytes;
  if (large || s.buffer.size() + bytes.size() > State::buffer_bytes) {
    s.flush();
  }
  s.require_whole();
  if (large) {  // a caller with this much has its own buffer
    s.write_through(bytes);
  } else {
    s.buffer.insert(s.buffer.end(), bytes.begin(), bytes.end());
  }
}

void OutputFile::flush() { state_->flush(); }

void OutputFile::commit() {
  State& s = *state_;
  s.flush();
  if (s.target.empty()) {
    s.close();
    return;
  }
  if (::fsync(s.descriptor) != 0 && errno != EINVAL && errno != ENOSYS) {
    s.fail(errno);
  }
  // close() would report errors, but it would also drop the lock while the file still has the name
  // of a temporary.
  s.lock = ::fcntl(s.descriptor, F_DUPFD_CLOEXEC, 0);
  s.close();
  if (::rename(s.temporary.c_str(), s.target.c_str()) != 0) {
    s.fail(errno);
  }
  s.release();
  forget_unfinished(s.slot);
  s.temporary.clear();
  s.sync_folder();
}

std::string OutputFile::path_until_commit() const {
  if (is_standard_output()) {
    return {};
  }
  return state_->temporary.empty() ? state_->name : state_->temporary;
}

bool OutputFile::is_standard_output() const { return state_->standard; }

}  // namespace changeover
