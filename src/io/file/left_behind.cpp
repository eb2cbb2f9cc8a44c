#include "io/file/left_behind.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

namespace changeover {
namespace {

namespace fs = std::filesystem;

// The process in ".NAME.PROCESS-NUMBER.tmp".
std::optional<pid_t> process_in(std::string_view file, const std::string& name) {
  const std::string front = "." + name + ".";
  constexpr std::string_view back = ".tmp";
  if (!file.starts_with(front) || !file.ends_with(back) ||
      file.size() < front.size() + back.size()) {
    return std::nullopt;
  }
  file.remove_prefix(front.size());
  file.remove_suffix(back.size());
  const char* const end = file.data() + file.size();
  pid_t process = 0;
  unsigned number = 0;
  const auto [dash, no_process] = std::from_chars(file.data(), end, process);
  if (no_process != std::errc() || process <= 0 || dash == end || *dash != '-') {
    return std::nullopt;
  }
  const auto [rest, no_number] = std::from_chars(dash + 1, end, number);
  return no_number == std::errc() && rest == end ? std::optional(process) : std::nullopt;
}

void remove_if_nobodys(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) {
    return;
  }
  struct stat status = {};
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) &&
      ::flock(file, LOCK_EX | LOCK_NB) == 0) {
    ::unlink(path.c_str());
  }
  ::close(file);
}

}  // namespace

bool claim_temporary(int descriptor, const std::string& path) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    return errno != EWOULDBLOCK;
  }
  struct stat own = {};
  struct stat named = {};
  return ::fstat(descriptor, &own) == 0 && ::stat(path.c_str(), &named) == 0 &&
         own.st_ino == named.st_ino && own.st_dev == named.st_dev;
}

void remove_left_behind(const fs::path& folder, const std::string& name) {
  static std::mutex mutex;
  static std::set<std::string> done;
  constexpr std::size_t most_names =
      1000;  // A process that writes many files would otherwise read the folder for each of them.
  {
    const std::scoped_lock lock(mutex);
    if (done.size() >= most_names || !done.insert((folder / name).string()).second) {
      return;
    }
  }
  std::error_code fault;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, fault), end; !fault && at != end;
       at.increment(fault)) {
    const auto process = process_in(at->path().filename().string(), name);
    // Another process may have our number, as process 1 of each container has. Our own files are
    // locked.
    if (process && (*process == ::getpid() || (::kill(*process, 0) != 0 && errno == ESRCH))) {
      remove_if_nobodys(at->path());
    }
  }
}

}  // namespace changeover
