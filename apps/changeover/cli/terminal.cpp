#include "cli/terminal.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <cstdlib>
#include <string_view>

namespace changeover::cli {

bool is_clever_terminal(int descriptor) {
  const char* name = std::getenv("TERM");
  return ::isatty(descriptor) == 1 && (name == nullptr || std::string_view(name) != "dumb");
}

bool may_colour(const OutputFile& out) {
  const char* no_colour = std::getenv("NO_COLOR");
  return out.is_standard_output() && is_clever_terminal(STDOUT_FILENO) &&
         (no_colour == nullptr || *no_colour == '\0');
}

std::size_t terminal_width(const OutputFile& out) {
  constexpr std::size_t fallback = 100;
  if (const char* columns = std::getenv("COLUMNS")) {
    std::size_t width = 0;
    const std::string_view text(columns);
    if (std::from_chars(text.data(), text.data() + text.size(), width).ec == std::errc() &&
        width > 0) {
      return width;
    }
  }
  winsize size{};
  if (out.is_standard_output() && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 &&
      size.ws_col > 0) {
    return size.ws_col;
  }
  return fallback;
}

namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): set once, first thing.
bool pipes_were_ignored = false;

}  // namespace

void prepare_process() {
  // In this order: each gets the lowest number that is free.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) {
      // Reading what is open for writing fails with EBADF, as the closed stream would, and the
      // reverse.
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    }
  }
  pipes_were_ignored = std::signal(SIGPIPE, SIG_IGN) == SIG_IGN;
  std::signal(SIGXFSZ, SIG_IGN);
}

void leave_with_the_reader() {
  if (!pipes_were_ignored) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
}

}  // namespace changeover::cli
