#include "io/scan/text_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <unordered_set>

#include "changeover/core/design.hpp"
#include "core/printable.hpp"
#include "io/scan/place.hpp"

namespace changeover {

TextScanner::TextScanner(Input& input)
    : input_(&input), buffer_(std::make_unique_for_overwrite<char[]>(buffer_bytes + 1)) {
  restart();
}

void TextScanner::restart() {
  p_ = end_ = buffer_.get();
  *end_ = '\0';
  at_end_ = false;
  base_ = line_start_ = 0;
  line_ = 1;
  start_ = p_;
  length_ = 0;
  refill();
  if (beginning().starts_with("\xEF\xBB\xBF")) {  // byte order mark
    p_ += 3;
    line_start_ = 3;
  }
}

void TextScanner::refill() {
  const auto kept = static_cast<std::size_t>(end_ - p_);
  base_ += static_cast<std::uint64_t>(p_ - buffer_.get());
  std::memmove(buffer_.get(), p_, kept);
  p_ = buffer_.get();
  end_ = p_ + kept;
  char* const full = buffer_.get() + buffer_bytes;
  while (end_ != full && !at_end_) {
    const std::size_t count = input_->read({end_, full});
    end_ += count;
    at_end_ = count == 0;
  }
  *end_ = '\0';
}

void TextScanner::check_byte() {
  const auto byte = static_cast<unsigned char>(*p_);
  if ((byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7f) {
    if (byte == 0x1b) {
      fail(here(),
           "this looks like a coloured table for people; write it with --format text or --json");
    }
    fail(here(), control_byte_defect(*p_));
  }
}

TextScanner::Item TextScanner::next_slowly() {
  if (p_ == end_) {
    return Item::end;
  }
  if (*p_ == '\r') {
    if (p_[1] != '\n' && p_ + 1 != end_) {
      fail(here(), lone_carriage_return);
    }
    ++p_;
    if (p_ == end_) {
      return Item::end;
    }
  }
  if (*p_ == '\n') {
    line_end_ = here();
    ++p_;
    ++line_;
    line_start_ = base_ + static_cast<std::uint64_t>(p_ - buffer_.get());
    return Item::line_end;
  }
  if (*p_ == '#') {
    ++p_;
    return Item::comment;
  }
  start_ = p_;
  number_ = TokenTable::not_small;
  while (!ends_word(*p_)) {
    check_byte();
    if (p_ - start_ == static_cast<std::ptrdiff_t>(max_token_bytes)) {
      fail(word_place(), fmt::format("a word of more than {} bytes; elements are separated by "
                                     "blanks and blocks by line ends",
                                     max_token_bytes));
    }
    ++p_;
  }
  if (*p_ == '\0' && p_ != end_) {
    check_byte();
  }
  length_ = static_cast<std::size_t>(p_ - start_);
  return Item::word;
}

bool TextScanner::comment_goes_on() {
  // Two bytes are enough to tell CR LF from a carriage return inside the line.
  if (end_ - p_ < 2 && !at_end_) {
    refill();
  }
  if (p_ == end_ || *p_ == '\n') {
    return false;
  }
  if (*p_ != '\r') {
    return true;
  }
  if (p_ + 1 != end_ && p_[1] != '\n') {
    fail(here(), lone_carriage_return);
  }
  return false;
}

bool TextScanner::comment_word(CommentWord& word, std::size_t longest) {
  word.text.clear();
  word.length = 0;
  while (comment_goes_on() && (*p_ == ' ' || *p_ == '\t')) {
    ++p_;
  }
  word.place = here();
  for (; comment_goes_on() && *p_ != ' ' && *p_ != '\t'; ++p_, ++word.length) {
    check_byte();
    if (word.length < longest) {
      word.text += *p_;
    }
  }
  return word.length > 0;
}

std::string TextScanner::rest_of_comment(std::size_t longest) {
  const Place place = here();
  std::string text;
  for (; comment_goes_on(); ++p_) {
    check_byte();
    if (text.size() == longest) {
      fail(place, fmt::format("more than {} bytes in this line; shorten it", longest));
    }
    text += *p_;
  }
  return text;
}

void TextScanner::skip_comment() {
  for (; comment_goes_on(); ++p_) {
    check_byte();
  }
}

std::optional<std::uint64_t> plain_number(std::string_view word) {
  if (word.empty() || (word[0] == '0' && word.size() > 1)) {
    return std::nullopt;
  }
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    value = 10 * value + static_cast<std::uint64_t>(c - '0');
  }
  return word.size() > 19 ? std::numeric_limits<std::uint64_t>::max() : value;
}

std::optional<std::string> word_defect(std::string_view label) {
  if (label.size() > max_token_bytes) {
    return fmt::format("a name of more than {} bytes; use shorter names", max_token_bytes);
  }
  return label_defect(label);
}

Element TokenTable::find(std::string_view word) const {
  if (const auto n = plain_number(word); n && *n < not_small) {
    return number(static_cast<std::uint32_t>(*n));
  }
  const auto found = by_word_.find(word);
  return found == by_word_.end() ? none : found->second;
}

Element TokenTable::add(std::string_view word) {
  const auto element = static_cast<Element>(words_.size());
  words_.emplace_back(word);
  if (const auto n = plain_number(word); n && *n < not_small) {
    const auto at = static_cast<std::size_t>(*n);
    if (at >= by_number_.size()) {
      by_number_.resize(std::max(at + 1, 2 * by_number_.size()), none);
    }
    by_number_[at] = element;
  } else {
    by_word_.emplace(std::string(word), element);
  }
  return element;
}

void TokenTable::add_numbers(std::uint64_t v) {
  by_number_.resize(static_cast<std::size_t>(v));
  std::iota(by_number_.begin(), by_number_.end(), Element{0});
}

void TokenTable::renumber(std::span<const Element> elements) {
  for (Element& element : by_number_) {
    element = element == none ? none : elements[element];
  }
  for (auto& [word, element] : by_word_) {
    element = elements[element];
  }
}

ElementSet element_set(std::span<const std::string> words) {
  ElementSet set;
  set.element_of.resize(words.size());
  std::iota(set.element_of.begin(), set.element_of.end(), Element{0});
  std::vector<std::pair<std::uint64_t, Element>> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto n = plain_number(words[i]);
    if (!n) {
      set.labels.assign(words.begin(), words.end());
      return set;
    }
    numbers.emplace_back(*n, static_cast<Element>(i));
  }
  // By value: there are no leading zeros, so a longer number is larger, also where a value does not
  // fit.
  std::ranges::sort(numbers, [&](const auto& a, const auto& b) {
    const std::string& x = words[a.second];
    const std::string& y = words[b.second];
    return x.size() != y.size() ? x.size() < y.size() : x < y;
  });
  for (std::size_t rank = 0; rank < numbers.size(); ++rank) {
    set.element_of[numbers[rank].second] = static_cast<Element>(rank);
    set.labels.push_back(words[numbers[rank].second]);
  }
  if (numbers.empty() || numbers.back().first + 1 == numbers.size()) {
    set.labels.clear();
  }
  return set;
}

void fill_labels(std::vector<std::string>& labels, std::uint64_t v) {
  const std::unordered_set<std::string> taken(labels.begin(), labels.end());
  for (std::uint64_t n = v; labels.size() < v; ++n) {
    std::string name = std::to_string(n);
    if (!taken.contains(name)) {
      labels.push_back(std::move(name));
    }
  }
}

}  // namespace changeover
