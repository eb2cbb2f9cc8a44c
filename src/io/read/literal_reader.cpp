// Designs as GAP and Sage write them down.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/read/beginning.hpp"
#include "io/read/point_blocks.hpp"
#include "io/scan/text_scanner.hpp"

namespace changeover {
namespace {

enum class Language : std::uint8_t { unknown, gap, sage };

constexpr std::string_view third_argument =
    "a third argument, as for blocks developed under a group; write out all blocks";

class LiteralReader {
 public:
  LiteralReader(std::string_view text, const std::string& name)
      : text_(without_byte_order_mark(text)), points_(text_, name) {
    skip_blanks();
    std::string_view rest = text_.substr(at_);
    skip_prompt(rest);
    at_ = text_.size() - rest.size();
  }

  Design read(const ReadOptions& options) {
    std::string_view word = name("BlockDesign, IncidenceStructure or rec");
    if (take(":=")) {
      language_ = Language::gap;
      word = name("BlockDesign or rec");
    } else if (take("=")) {
      language_ = Language::sage;
      word = name("IncidenceStructure or BlockDesign");
    }
    const std::size_t start = at_ - word.size();
    need("(");
    if (word == "rec" && language_ != Language::sage) {
      language_ = Language::gap;
      read_record();
    } else if (word == "IncidenceStructure" && language_ != Language::gap) {
      language_ = Language::sage;
      read_arguments();
    } else if (word == "BlockDesign") {
      read_arguments();
    } else {
      points_.fail(start,
                   fmt::format("{} is not a design; give BlockDesign(v, blocks) of GAP or Sage, "
                               "IncidenceStructure(v, blocks) of Sage or rec(v, blocks) of GAP",
                               shown(word)));
    }
    while (take(";")) {
      language_ = language_ == Language::unknown ? Language::gap : language_;
    }
    skip_blanks();
    if (at_ < text_.size()) {
      points_.fail(at_, "text after the design; give one design per file");
    }
    if (!points_.has_blocks()) {
      points_.fail(start, "no blocks; give at least one");
    }
    return points_.finish(options, first_point(start));
  }

 private:
  // GAP counts points from 1, Sage from 0; a BlockDesign may be of both.
  [[nodiscard]] std::uint32_t first_point(std::size_t start) const {
    if (language_ == Language::gap && !points_.v()) {
      points_.fail(start, "the number of points is missing; give v");
    }
    if (language_ != Language::unknown) {
      return language_ == Language::gap ? 1 : 0;
    }
    const bool of_gap = points_.v() && points_.greatest() == *points_.v();
    if (of_gap == (points_.least() == 0)) {
      points_.fail(
          start,
          "points may be counted from 1 (GAP) or from 0 (Sage); write D := BlockDesign(…); for "
          "GAP, or D = BlockDesign(…) for Sage");
    }
    return of_gap ? 1 : 0;
  }

  void skip_blanks() {
    for (;;) {
      at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
      if (at_ == text_.size() || text_[at_] != '#') {
        return;
      }
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      points_.comment(text_.substr(at_ + 1, end - at_ - 1), at_);
      at_ = end;
    }
  }

  bool take(std::string_view sign) {
    skip_blanks();
    if (!text_.substr(at_).starts_with(sign)) {
      return false;
    }
    at_ += sign.size();
    return true;
  }

  void need(std::string_view sign) {
    if (!take(sign)) {
      points_.fail(at_, at_ == text_.size()
                            ? fmt::format("expected {}, but the text ends; complete it", sign)
                            : fmt::format("expected {}, found {}; correct it", sign,
                                          shown(text_.substr(at_, 1))));
    }
  }

  std::string_view name(std::string_view wanted) {
    skip_blanks();
    std::size_t end = at_;
    while (end < text_.size() && is_of_name(text_[end])) {
      ++end;
    }
    if (end == at_) {
      points_.fail(at_, fmt::format("expected {}; write it here", wanted));
    }
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
  }

  bool at_digit() {
    skip_blanks();
    return at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9';
  }

  std::string_view number() {
    if (!at_digit()) {
      points_.fail(at_, "expected a number; points are numbers");
    }
    const std::size_t end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
    const std::string_view digits = text_.substr(at_, end - at_);
    at_ = end;
    return digits;
  }

  void read_v() {
    const std::string_view digits = number();
    points_.declare_v(digits, at_ - digits.size());
  }

  void read_blocks() {
    if (points_.has_blocks()) {
      points_.fail(at_, "blocks are given twice; give them once");
    }
    need("[");
    while (!take("]")) {
      read_block();
      if (!take(",")) {
        need("]");
        return;
      }
    }
  }

  // "[ 1, 2, 5 ]", "[ 1 .. 3 ]", or in round brackets.
  void read_block() {
    skip_blanks();
    const std::size_t start = at_;
    const std::string_view close = take("(") ? ")" : "]";
    if (close == "]") {
      need("[");
    }
    while (!take(close)) {
      const std::string_view digits = number();
      const std::size_t place = at_ - digits.size();
      points_.add(digits, place);
      if (take("..")) {
        const std::string_view last_digits = number();
        const auto from = plain_number(digits);
        const auto to = plain_number(last_digits);
        if (!from || !to || *to <= *from || *to > max_elements_in_memory) {
          points_.fail(place, "this range does not go up; write out the points");
        }
        for (std::uint64_t x = *from + 1; x <= *to; ++x) {
          points_.add(static_cast<std::uint32_t>(x), place);
        }
      }
      if (!take(",")) {
        need(close);
        break;
      }
    }
    points_.end_block(start);
  }

  // BlockDesign(7, [[1, 2, 4], …]); Sage may name its arguments, and have others that say how to
  // check.
  void read_arguments() {
    while (!take(")")) {
      skip_blanks();
      const std::size_t start = at_;
      const bool has_name = !at_digit() && at_ < text_.size() && is_of_name(text_[at_]);
      const std::string_view key = has_name ? name("an argument") : "";
      const bool is_keyword = has_name && take("=");
      if (is_keyword) {
        language_ = Language::sage;
      } else if (has_name) {
        points_.fail(start, points_.has_blocks() ? third_argument
                                                 : "points and blocks are numbers; write them so");
      }
      if (key == "points" || (!has_name && at_digit())) {
        read_v();
      } else if (key == "blocks" || (!has_name && !points_.has_blocks())) {
        read_blocks();
      } else if (has_name) {
        skip_value();
      } else {
        points_.fail(start, third_argument);
      }
      if (!take(",")) {
        need(")");
        return;
      }
    }
  }

  // rec( isBlockDesign := true, v := 7, blocks := [ … ], … ).
  void read_record() {
    while (!take(")")) {
      const std::string_view key = name("a component of the record");
      need(":=");
      if (key == "v") {
        read_v();
      } else if (key == "blocks") {
        read_blocks();
      } else {
        skip_value();
      }
      if (!take(",")) {
        need(")");
        return;
      }
    }
  }

  // Skips a value that is ignored, up to the comma or bracket after it.
  void skip_value() {
    std::size_t depth = 0;
    for (skip_blanks(); at_ < text_.size(); ++at_, skip_blanks()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        const std::size_t start = at_;
        for (++at_; at_ < text_.size() && text_[at_] != c; ++at_) {
          at_ += text_[at_] == '\\' ? 1U : 0U;
        }
        if (at_ >= text_.size()) {
          points_.fail(start, "a quote is opened and not closed; close it");
        }
      } else if (c == '(' || c == '[' || c == '{') {
        ++depth;
      } else if (depth > 0 && (c == ')' || c == ']' || c == '}')) {
        --depth;
      } else if (depth == 0 && (c == ',' || c == ')')) {
        return;
      }
    }
  }

  std::string_view text_;
  PointBlocks points_;
  std::size_t at_ = 0;
  Language language_ = Language::unknown;
};

}  // namespace

Design read_literal(Input& input, const ReadOptions& options) {
  const std::string text =
      read_to_end(input, most_foreign_bytes, "write it as text, one block per line");
  return LiteralReader(text, input.name()).read(options);
}

bool begins_like_a_literal(std::string_view beginning) {
  beginning = without_byte_order_mark(beginning);
  skip_comments(beginning);
  skip_prompt(beginning);
  skip_assignment(beginning);
  const auto end = std::ranges::find_if_not(beginning, is_of_name);
  const std::string_view found =
      beginning.substr(0, static_cast<std::size_t>(end - beginning.begin()));
  beginning.remove_prefix(found.size());
  skip_comments(beginning);
  return beginning.starts_with('(') &&
         (found == "BlockDesign" || found == "IncidenceStructure" || found == "rec");
}

}  // namespace changeover
