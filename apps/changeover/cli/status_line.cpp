#include "cli/status_line.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>

#include "cli/terminal.hpp"

namespace changeover::cli {
namespace {

// All of it, or as much as there is room for.
void write_to_stderr(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(STDERR_FILENO, bytes.data(), bytes.size());
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return;
    }
  }
}

}  // namespace

StatusLine::StatusLine() : on_terminal_(is_clever_terminal(STDERR_FILENO)) {}

std::size_t StatusLine::width() const {
  constexpr std::size_t usual = 100;
  constexpr std::size_t least = 20;
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return std::max(least, known ? std::size_t{size.ws_col} : usual) - 1;
}

void StatusLine::show(std::string_view line, std::chrono::duration<double> elapsed) {
  const std::scoped_lock lock(mutex_);
  if (ended_) {
    return;
  }
  if (!on_terminal_) {
    constexpr std::chrono::duration<double> interval{10};
    if (elapsed >= last_log_ + interval) {
      last_log_ = elapsed;
      write_to_stderr("changeover: " + std::string(line) + "\n");
    }
    return;
  }
  std::string text(line.substr(0, width()));
  const std::size_t columns = text.size();
  text.resize(std::max(columns, shown_), ' ');
  shown_ = columns;
  write_to_stderr("\r" + text);
}

void StatusLine::clear() {
  const std::scoped_lock lock(mutex_);
  clear_locked();
}

void StatusLine::clear_locked() {
  if (shown_ > 0) {
    write_to_stderr("\r" + std::string(shown_, ' ') + "\r");
    shown_ = 0;
  }
}

void StatusLine::end() {
  const std::scoped_lock lock(mutex_);
  clear_locked();
  ended_ = on_terminal_;
}

void StatusLine::say(std::string_view line) {
  const std::scoped_lock lock(mutex_);
  clear_locked();
  write_to_stderr(std::string(line) + "\n");
}

StatusLine& status_line() {
  static StatusLine line;
  return line;
}

}  // namespace changeover::cli
