// The lines of an input of any length, one after another: one line and one piece are in memory.
//
//     InputLines lines(input, 65'536);
//     while (lines.next() == InputLines::Next::line) {
//       lines.line();                               // without line end and byte order mark
//       lines.number();                             // from 1
//     }
//
// For texts in memory see core/lines.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "changeover/io/input.hpp"

namespace changeover {

class InputLines {
 public:
  enum class Next : std::uint8_t { line, end, too_long };

  /// The input must outlive this.
  InputLines(Input& input, std::size_t longest) : input_(&input), longest_(longest) {}

  /// Goes to the next line. If it is too long, line() is the part that was read, and reading cannot
  /// go on. @throws MissingResource if reading fails; Stopped if the scope of this thread wants to
  /// stop.
  [[nodiscard]] Next next();

  /// The line, valid until the next call of next().
  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::uint64_t number() const { return number_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }  ///< that were read so far
  [[nodiscard]] const std::string& name() const { return input_->name(); }

 private:
  Next found(std::size_t stop);

  Input* input_;
  std::size_t longest_;
  std::string buffer_;  // bytes that were read, from begin_ on not yet of a line
  std::size_t begin_ = 0;
  std::string_view line_;
  std::uint64_t number_ = 0;
  std::uint64_t bytes_ = 0;
  bool ended_ = false;
};

}  // namespace changeover
