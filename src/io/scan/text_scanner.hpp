// The bytes of a text as words, line ends and comments.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/input.hpp"
#include "io/scan/place.hpp"

namespace changeover {

// The words of blocks and the elements that they stand for.

inline constexpr std::size_t max_token_bytes = 255;

/// The value of a plain decimal: digits without a needless leading zero, at most 19 of them; longer
/// ones give the largest value. nullopt for any other word.
[[nodiscard]] std::optional<std::uint64_t> plain_number(std::string_view word);

/// Why an element of a file cannot have this name: label_defect(), or it is too long.
[[nodiscard]] std::optional<std::string> word_defect(std::string_view label);

/// Numbers each new word as it comes: 0, 1, 2, … Small plain numbers are found by one array access.
class TokenTable {
 public:
  static constexpr Element none = 0xFFFFFFFF;
  /// not a small number: number() does not take it
  static constexpr std::uint32_t not_small = 65'535;

  /// The element that the plain number n ≤ not_small stands for.
  [[nodiscard]] Element number(std::uint32_t n) const {
    return n < by_number_.size() ? by_number_[n] : none;
  }

  /// The element that `word` stands for, or none.
  [[nodiscard]] Element find(std::string_view word) const;

  /// Gives a new word the next element.
  Element add(std::string_view word);

  /// Lets 0, …, v−1 stand for themselves.
  void add_numbers(std::uint64_t v);

  /// The words given to add(), in that order.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  [[nodiscard]] std::size_t size() const { return words_.size(); }

  /// Lets what stood for i stand for elements[i] from now on. words() keeps its order.
  void renumber(std::span<const Element> elements);

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };
  std::vector<Element> by_number_;  // as long as the largest number needs
  std::unordered_map<std::string, Element, Hash, std::equal_to<>> by_word_;
  std::vector<std::string> words_;
};

/// The element set that words make if it is not declared.
struct ElementSet {
  std::vector<Element> element_of;  ///< by position among the words
  std::vector<std::string> labels;  ///< empty if the words are exactly 0, …, n−1
};

/// Makes it from distinct words: in increasing order if all are numbers, otherwise in their order.
[[nodiscard]] ElementSet element_set(std::span<const std::string> words);

/// Completes labels to v of them, with numbers from v upwards.
void fill_labels(std::vector<std::string>& labels, std::uint64_t v);

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

  /// The last word.
  [[nodiscard]] std::string_view word() const { return {start_, length_}; }
  /// Its value if it is a plain number below TokenTable::not_small, else not_small.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  [[nodiscard]] Place word_place() const { return place_of_byte(start_); }

  /// The place of the last line end.
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
