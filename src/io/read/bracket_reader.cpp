// Designs as people write sets: blocks in brackets.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/read/beginning.hpp"
#include "io/read/declared.hpp"
#include "io/read/point_blocks.hpp"

namespace changeover {
namespace {

constexpr std::string_view between_elements = " \t\r\n,;";
constexpr std::string_view ends_a_word = " \t\r\n,;#()[]{}";  // x' and x" are names

char closing_of(char open) { return open == '(' ? ')' : open == '[' ? ']' : '}'; }
bool opens(char c) { return c == '(' || c == '[' || c == '{'; }

class BracketReader {
 public:
  BracketReader(std::string_view text, const std::string& name)
      : text_(without_byte_order_mark(text)), name_(&name) {
    std::string_view rest = text_;
    skip_comments(rest);
    skip_prompt(rest);
    skip_assignment(rest);
    at_ = text_.size() - rest.size();
  }

  Design read(const ReadOptions& options) {
    const std::size_t start = at_;
    while (skip_to_next()) {
      if (!opens(text_[at_])) {
        refuse_closing(at_, word());
        fail(at_, fmt::format("{} is in no bracket; write each block as {{A,B,C}}", shown(word())));
      }
      read_group(true);
    }
    if (offsets_.empty()) {
      fail(start, "no blocks; write each block as {A,B,C}");
    }
    return collector_.finish(Collector::Context{.name = *name_,
                                                .declared = merged(*name_, options, {}),
                                                .labels = std::nullopt,
                                                .labels_place = {},
                                                .place = place(start),
                                                .named = false,
                                                .place_of_word = [this](std::uint64_t word) {
                                                  return place(
                                                      offsets_[static_cast<std::size_t>(word)]);
                                                }});
  }

 private:
  [[noreturn]] void fail(std::size_t offset, std::string_view what) const {
    changeover::fail(*name_, place(offset), what);
  }
  [[nodiscard]] Place place(std::size_t offset) const { return place_of(text_, offset); }

  // Skips blanks, commas and comments; false at the end.
  bool skip_to_next() {
    for (;;) {
      at_ = std::min(text_.find_first_not_of(between_elements, at_), text_.size());
      if (at_ == text_.size() || text_[at_] != '#') {
        return at_ < text_.size();
      }
      at_ = std::min(text_.find('\n', at_), text_.size());
    }
  }

  // A block, or, in the outermost brackets, a list of blocks.
  void read_group(bool may_be_list) {
    const std::size_t start = at_;
    const char close = closing_of(text_[at_++]);
    bool is_list = false;
    for (;;) {
      if (!skip_to_next()) {
        fail(start, "this bracket is not closed; close it");
      }
      const char next = text_[at_];
      if (next == close) {
        ++at_;
        break;
      }
      if (opens(next)) {
        if (!may_be_list || collector_.block_size() > 0) {
          fail(at_, "a bracket within a block; write each block as {A,B,C}");
        }
        is_list = true;
        read_group(false);
      } else if (is_list) {
        fail(at_,
             fmt::format("{} is between blocks; write each block as {{A,B,C}}", shown(word())));
      } else {
        add_element();
      }
    }
    if (!is_list) {
      note(collector_.end_block(), start);
    }
  }

  void add_element() {
    const std::size_t start = at_;
    if (text_[at_] == '"' || text_[at_] == '\'') {
      const std::size_t end = text_.find(text_[at_], at_ + 1);
      if (end == std::string_view::npos) {
        fail(start, "a quote is opened and not closed; close it");
      }
      const std::string_view label = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      note(word_defect(label), start);
      if (at_ < text_.size() && ends_a_word.find(text_[at_]) == std::string_view::npos) {
        fail(at_, "a name goes on after its quote; correct it");
      }
      note(collector_.add(std::string(1, '"').append(label)), start);
    } else {
      const std::string_view element = word();
      at_ += element.size();
      note(word_defect(element), start);
      if (element.find("..") != std::string_view::npos) {
        fail(start, "a range; write out its elements");
      }
      refuse_closing(start, element);
      note(loose_word_defect(element, collector_.block_size() == 0), start);
      note(collector_.add(element), start);
    }
    offsets_.push_back(static_cast<std::uint32_t>(start));  // a text is at most 1 GiB
  }

  void refuse_closing(std::size_t offset, std::string_view word) const {
    if (word == ")" || word == "]" || word == "}") {
      fail(offset, "this bracket closes none that is open; correct it");
    }
  }

  void note(const std::optional<std::string>& defect, std::size_t offset) const {
    if (defect) {
      fail(offset, *defect);
    }
  }

  // The word here, or the single sign that ends words.
  [[nodiscard]] std::string_view word() const {
    const std::size_t end = std::min(text_.find_first_of(ends_a_word, at_), text_.size());
    return text_.substr(at_, std::max<std::size_t>(end - at_, 1));
  }

  std::string_view text_;
  const std::string* name_;
  Collector collector_;
  std::vector<std::uint32_t> offsets_;  // of the words of the collector
  std::size_t at_ = 0;
};

// Whether a text that begins with a bracket may be JSON: an object, whose keys are in quotes, or an
// array of arrays of numbers or of names in double quotes. What is cut off may be.
bool may_be_json(std::string_view text) {
  const auto next = [&] {
    text.remove_prefix(1);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return text.empty() ? '\0' : text[0];
  };
  const char first = text[0];
  const char second = next();
  if (first == '(' || second == '\0') {
    return first != '(';
  }
  if (first == '[' && second == '[') {
    const char third = next();
    return !is_letter(third) && third != '\'';
  }
  if (first == '[' && second != '{') {
    return second == ']';
  }
  const char key = first == '[' ? next() : second;
  if (key == '}') {
    return next() == '\0' || first == '[';  // "{}" alone
  }
  if (key != '"') {
    return false;
  }
  text.remove_prefix(std::min(text.find('"', 1), text.size()));
  const char after = text.empty() ? '\0' : next();
  return after == ':' || after == '\0';
}

}  // namespace

Design read_brackets(Input& input, const ReadOptions& options) {
  const std::string text =
      read_to_end(input, most_foreign_bytes, "write it as text, one block per line");
  return BracketReader(text, input.name()).read(options);
}

bool begins_like_brackets(std::string_view beginning) {
  beginning = without_byte_order_mark(beginning);
  const std::string_view all = beginning;
  skip_comments(beginning);
  const std::string_view comments = all.substr(0, all.size() - beginning.size());
  if (comments.find("# changeover design") != std::string_view::npos ||
      comments.find("# labels:") != std::string_view::npos) {
    return false;  // text, where names may have brackets
  }
  const bool has_comment = comments.find('#') != std::string_view::npos;
  const bool has_prompt = skip_prompt(beginning);
  const bool has_name = skip_assignment(beginning);
  if (beginning.empty() || !opens(beginning[0])) {
    return false;
  }
  return has_comment || has_prompt || has_name || !may_be_json(beginning);
}

}  // namespace changeover
