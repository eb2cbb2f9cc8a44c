// The bytes of a text as words, line ends and comments.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "changeover/io/input.hpp"
#include "io/scan/place.hpp"
#include "io/scan/token_table.hpp"

namespace changeover {

/// Scans an input through one buffer. A word never straddles the buffer's end: when one begins,
/// either more bytes than a word may have are there, or the input has ended. A NUL follows the last
/// byte, so inner loops need no bounds.
class TextScanner {
 public:
  enum class Item : std::uint8_t { word, line_end, comment, end };

  explicit TextScanner(Input& input);

  /// Starts over: the input was rewound.
  void restart();

  /// The input's first 256 KiB, or all of it, before anything was taken.
  [[nodiscard]] std::string_view beginning() const {
    return {p_, static_cast<std::size_t>(end_ - p_)};
  }

  /// Takes the next item. After a comment's `#`, use one of the comment functions.
  /// @throws BadInput for control bytes and for words of more than max_token_bytes.
  Item next();

  /// Of the last word.
  [[nodiscard]] std::string_view word() const { return {start_, length_}; }
  /// Its value if it is a plain number below TokenTable::not_small, else not_small.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] Place word_place() const { return place_of_byte(start_); }

  /// Of the last line end.
  [[nodiscard]] Place line_end_place() const { return line_end_; }

  /// The place of the next byte.
  [[nodiscard]] Place here() const { return place_of_byte(p_); }

  /// The next word of the comment, cut to `longest` bytes, with its true length; false at its end.
  struct CommentWord {
    std::string text;
    std::size_t length = 0;
    Place place;
  };
  bool comment_word(CommentWord& word, std::size_t longest = max_token_bytes);

  /// Takes the rest of the comment. @throws BadInput if it exceeds `longest` bytes.
  std::string rest_of_comment(std::size_t longest);
  void skip_comment();

  [[noreturn]] void fail(Place place, std::string_view what) const {
    changeover::fail(input_->name(), place, what);
  }

 private:
  static constexpr std::size_t buffer_bytes = std::size_t{1} << 18;
  static constexpr std::ptrdiff_t ahead = 512;

  Place place_of_byte(const char* byte) const {
    const auto offset = base_ + static_cast<std::uint64_t>(byte - buffer_.get());
    return {line_, offset - line_start_ + 1};
  }
  static bool ends_word(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '#' || c == '\0';
  }
  void refill();
  Item next_slowly();
  bool comment_goes_on();
  void check_byte();

  Input* input_;
  std::unique_ptr<char[]> buffer_;  // NOLINT(modernize-avoid-c-arrays): not to be cleared first
  char* p_ = nullptr;               // the next byte
  char* end_ = nullptr;             // holds a NUL
  bool at_end_ = false;             // nothing follows `end_`
  std::uint64_t base_ = 0;          // offset of the buffer's first byte in the input
  std::uint64_t line_ = 1;
  std::uint64_t line_start_ = 0;  // offset of the line's first byte
  Place line_end_;
  const char* start_ = nullptr;
  std::size_t length_ = 0;
  std::uint32_t number_ = TokenTable::not_small;
};

inline TextScanner::Item TextScanner::next() {
  for (;;) {
    while (*p_ == ' ' || *p_ == '\t') {
      ++p_;
    }
    if (end_ - p_ >= ahead || at_end_) {
      break;
    }
    refill();
  }
  const char* q = p_;
  std::uint32_t value = 0;
  for (unsigned digit = 0; (digit = static_cast<unsigned char>(*q) - unsigned{'0'}) <= 9; ++q) {
    value = value * 10 + digit;
  }
  const std::ptrdiff_t digits = q - p_;
  if (digits == 0 || digits > 5 || (*p_ == '0' && digits > 1) || !ends_word(*q) ||
      value >= TokenTable::not_small || (*q == '\0' && q != end_)) [[unlikely]] {
    return next_slowly();
  }
  start_ = p_;
  length_ = static_cast<std::size_t>(digits);
  number_ = value;
  p_ += digits;
  return Item::word;
}

}  // namespace changeover
