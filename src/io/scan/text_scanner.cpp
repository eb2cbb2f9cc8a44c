#include "io/scan/text_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

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
      fail(here(), "carriage return inside a line; end lines with LF or CR LF");
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
  return *p_ != '\r' || (p_ + 1 != end_ && p_[1] != '\n');
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

}  // namespace changeover
