// The one line on stderr that says what is going on, and lines that stay there.
//
//     status_line().show("annealing 40 blocks; best 41; 3 s", seconds);
//     status_line().clear();                          // before an answer or a fault is written
//
// Nothing here ever fails: a stderr that is closed, full or a terminal that is gone is no reason to
// lose work.
#pragma once

#include <chrono>
#include <mutex>
#include <string_view>

namespace changeover::cli {

class StatusLine {
 public:
  /// Whether stderr is a terminal that can overwrite a line.
  [[nodiscard]] bool on_terminal() const { return on_terminal_; }

  /// Columns that a line may have, so that it never wraps, which would leave its halves behind.
  [[nodiscard]] std::size_t width() const;

  /// Replaces the line on a terminal. Elsewhere, in a log, a new line every ten seconds of
  /// `elapsed`.
  void show(std::string_view line, std::chrono::duration<double> elapsed);

  /// Removes the line from the terminal.
  void clear();

  /// No line is shown any more: an answer is being written to the same terminal.
  void end();

  /// A line that stays, with its line feed added.
  void say(std::string_view line);

 private:
  friend StatusLine& status_line();
  StatusLine();

  void clear_locked();

  std::mutex mutex_;
  bool on_terminal_;
  bool ended_ = false;
  std::size_t shown_ = 0;  // columns of the line that is on the terminal
  std::chrono::duration<double> last_log_{0};
};

/// The only one.
[[nodiscard]] StatusLine& status_line();

}  // namespace changeover::cli
