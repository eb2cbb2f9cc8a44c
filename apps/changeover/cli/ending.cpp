#include "cli/ending.hpp"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "changeover/io/output.hpp"
#include "cli/terminal.hpp"

namespace changeover::cli {
namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler needs it
std::atomic_flag end_has_begun = ATOMIC_FLAG_INIT;
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler needs it
std::atomic<bool> clears_the_line = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler reads it");

std::string_view name_of_signal(int signal) {
  switch (signal) {
    case SIGINT:
      return "Ctrl-C";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    case SIGQUIT:
      return "SIGQUIT";
    default:
      return "a signal";
  }
}

// A failure could be told to nothing. A full pipe without a reader would block.
void put_on_stderr(std::string_view bytes) noexcept {
  pollfd out{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
  if (::poll(&out, 1, 0) != 1 || (out.revents & POLLOUT) == 0) {
    return;
  }
  static_cast<void>(!::write(STDERR_FILENO, bytes.data(), bytes.size()));
}

}  // namespace

void end_by_signal(int signal) noexcept {
  if (end_has_begun.test_and_set()) {
    return;  // a second one, perhaps to another thread, while the files are removed
  }
  remove_unfinished_outputs();
  if (clears_the_line) {  // of progress, and of what the terminal shows for the key
    put_on_stderr("\r\x1b[K");
  }
  put_on_stderr("changeover: stopped by ");
  put_on_stderr(name_of_signal(signal));
  put_on_stderr(" before the end\n");
  ::signal(signal, SIG_DFL);
  ::raise(signal);  // once the handler ends
}

void end_on_signals() {
  clears_the_line = is_clever_terminal(STDERR_FILENO);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction old = {};
    if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler != SIG_DFL) {
      continue;
    }
    struct sigaction action = {};
    action.sa_handler = end_by_signal;
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace changeover::cli
