// The lines of a text in memory, one after another.
//
//     for (Lines lines("a\nb"); lines.next();) {
//       lines.line();                               // "a", "b"
//       lines.number();                             // 1, 2
//     }
//
// A line ends at a line feed, which is not part of it, or where the text ends.
// io/scan/input_lines.hpp reads inputs that may have no end; text, JSON and CSV have scanners of
// their own, because a line is not their unit.
#pragma once

#include <cstdint>
#include <string_view>

namespace changeover {

class Lines {
 public:
  /// The text must outlive this.
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Moves to the next line, the first at the first call; false at the end.
  [[nodiscard]] bool next() {
    if (rest_.empty()) {
      return false;
    }
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return true;
  }

  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::uint64_t number() const { return number_; }  ///< from 1

 private:
  std::string_view rest_;
  std::string_view line_;
  std::uint64_t number_ = 0;
};

}  // namespace changeover
