#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "core/utf8.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_name = 255;

// Items with anything between them. Lists are long: a row is not kept.
RowOptions row_options() {
  RowOptions options = RowOptions::of_any_length();
  options.any_separator = options.blanks = options.percent_too = true;
  options.longest_line = 65'536;
  options.too_long = "a line of more than 65536 bytes; give two items a line";
  return options;
}

bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; }

/// A plain decimal below `most_items`.
std::optional<Element> item_number(const Field& field) {
  const std::string_view word = field.text;
  Element number = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  const bool plain = error == std::errc() && stop == end && (word[0] != '0' || word.size() == 1);
  return plain && number < most_items ? std::optional(number) : std::nullopt;
}

/// What `word` is as a number if it is written like one: digits, perhaps with a sign, leading zeros
/// or a point, without what makes no difference to the number. Nothing for all other words.
std::optional<std::string> as_number(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) {
    word.remove_prefix(1);
  }
  const std::size_t point = std::min(word.find('.'), word.size());
  const std::string_view whole = word.substr(0, point);
  std::string_view part = point < word.size() ? word.substr(point + 1) : std::string_view();
  const auto digits = [](std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  if (whole.empty() || !digits(whole) || !digits(part)) {
    return std::nullopt;
  }
  std::string number(whole.substr(std::min(whole.find_first_not_of('0'), whole.size() - 1)));
  part = part.substr(0, part.find_last_not_of('0') + 1);
  if (!part.empty()) {
    number += '.';
    number += part;
  }
  return negative && number != "0" ? '-' + number : number;
}

/// "0 1": its author meant two items, and not one of this name.
bool are_numbers(std::string_view text) {
  if (text.find(' ') == std::string_view::npos) {
    return false;
  }
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (!word.empty() && !as_number(word)) {
      return false;
    }
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return true;
}

/// An invisible character that makes another name of a name, as in "U+200B"; nothing if there is
/// none. `word` is UTF-8.
std::optional<std::string> invisible_character(std::string_view word) {
  constexpr auto ranges = std::to_array<std::pair<char32_t, char32_t>>({{0xA0, 0xA0},
                                                                        {0xAD, 0xAD},
                                                                        {0x34F, 0x34F},
                                                                        {0x61C, 0x61C},
                                                                        {0x115F, 0x1160},
                                                                        {0x17B4, 0x17B5},
                                                                        {0x180B, 0x180F},
                                                                        {0x2000, 0x200F},
                                                                        {0x2028, 0x202F},
                                                                        {0x205F, 0x206F},
                                                                        {0x3000, 0x3000},
                                                                        {0x3164, 0x3164},
                                                                        {0xFE00, 0xFE0F},
                                                                        {0xFEFF, 0xFEFF},
                                                                        {0xFFA0, 0xFFA0},
                                                                        {0xE0000, 0xE0FFF}});
  while (!word.empty()) {
    const CodePoint point = first_code_point(word);
    word.remove_prefix(point.bytes);
    for (const auto& [first, last] : ranges) {
      if (point.value >= first && point.value <= last) {
        return fmt::format("U+{:04X}", std::uint32_t{point.value});
      }
    }
  }
  return std::nullopt;
}

/// Two items as most files write them: digits, one blank, tab or comma, digits. Nothing for every
/// other line.
std::optional<std::pair<Element, Element>> plain_pair(std::string_view line) {
  constexpr std::size_t most_digits = 7;  // below most_items
  static_assert(most_items == 10'000'000);
  std::size_t at = 0;
  const auto number = [&](Element& value) {
    const std::size_t begin = at;
    value = 0;
    for (; at < line.size() && line[at] >= '0' && line[at] <= '9'; ++at) {
      value =
          10 * value + static_cast<Element>(line[at] - '0');  // of no use if there are more digits
    }
    const std::size_t digits = at - begin;
    return digits > 0 && digits <= most_digits && (digits == 1 || line[begin] != '0');
  };
  std::pair<Element, Element> pair;
  if (number(pair.first) && at < line.size() && separates(line[at]) &&
      (++at, number(pair.second)) && at == line.size()) {
    return pair;
  }
  return std::nullopt;
}

/// Pairs in pieces, so that more of them move none. A piece is so large that the system has it back
/// at once; what is not used of it takes no memory.
class Pieces {
 public:
  void add(Element x, Element y) {
    if (pieces_.empty() || pieces_.back().size() == piece) {
      pieces_.emplace_back().reserve(piece);
    }
    pieces_.back().emplace_back(x, y);
  }

  template <typename Visit>
  void each(Visit&& visit) {
    for (auto& of_piece : pieces_) {
      for (auto& [x, y] : of_piece) {
        visit(x, y);
      }
    }
  }

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  void clear() { pieces_.clear(); }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 22;
  std::vector<std::vector<ItemPair>> pieces_;
};

class PairReader {
 public:
  PairReader(Input& input, const PairFileOptions& options)
      : rows_(input, row_options()), name_(input.name()), options_(options) {
    if (options_.items && (*options_.items == 0 || *options_.items > most_items)) {
      throw BadInput(fmt::format("{} items: give 1 to {}", *options_.items, most_items));
    }
  }

  std::shared_ptr<const PairGraph> read() {
    while (rows_.next_line()) {
      if (!named_ && seen_any_ && first_line_.empty()) {
        const auto pair = plain_pair(rows_.line());
        if (pair && std::max(pair->first, pair->second) < options_.items.value_or(most_items)) {
          add_numbers(pair->first, pair->second);
          continue;
        }
      }
      if (rows_.split(row_) && items_of_row()) {
        take();
      }
    }
    settle_first_line(false);
    if (pairs_.empty()) {
      throw BadInput(name_ + ": no pair is listed; give two items per line");
    }
    const std::uint64_t items = options_.items && names_.empty() ? *options_.items
                                : names_.empty()                 ? std::uint64_t{largest_} + 1
                                                                 : names_.size();
    numbers_.clear();
    written_.clear();
    return std::make_shared<const PairGraph>(
        items,
        [&](const PairGraph::Visit& visit) {
          pairs_.each([&](Element x, Element y) { visit(x, y); });
        },
        std::move(names_));
  }

 private:
  // Leaves the two items of a row in it; false for a row without any.
  bool items_of_row() {
    std::erase_if(row_, [](const Field& field) { return field.text.empty(); });
    if (row_.size() == 1 && !row_.front().in_quotes) {
      row_ = at_blanks(row_.front(), rows_);
    }
    if (row_.size() > 2) {
      rows_.fail(row_[2],
                 "more than two items; give two per line, and names with blanks in quotes");
    }
    if (row_.size() == 1) {
      rows_.fail(row_[0], "one item stands alone; give two per line");
    }
    for (const Field& field : row_) {
      if (!field.in_quotes && are_numbers(field.text)) {
        rows_.fail(field, fmt::format("'{}' is more than one number; give two items a line, or put "
                                      "it in quotes if it is a name",
                                      field.text));
      }
    }
    return !row_.empty();
  }

  void take() {
    const auto x = item_number(row_[0]);
    const auto y = item_number(row_[1]);
    const bool numbers = x && y;
    if (!seen_any_ && !as_number(row_[0].text) &&
        !as_number(row_[1].text)) {  // perhaps names of columns
      seen_any_ = true;
      first_line_ = row_;
      for (const Field& field : first_line_) {
        check_name(field);
      }
      return;
    }
    seen_any_ = true;
    settle_first_line(numbers);
    if (named_ || !numbers) {
      if (!named_ && !pairs_.empty()) {
        for (const Field& field : row_) {
          if (const auto number = as_number(field.text); number && *number != field.text) {
            rows_.fail(field,
                       fmt::format("'{}' is not written like the whole numbers before it; write "
                                   "{}, or begin all items with a letter if they are names",
                                   field.text, *number));
          }
        }
      }
      become_named();
      add_named(row_);
      return;
    }
    for (const auto& [item, field] : {std::pair(*x, &row_[0]), std::pair(*y, &row_[1])}) {
      if (options_.items && item >= *options_.items) {
        rows_.fail(*field,
                   fmt::format("item {} is not one of {} items, which have the numbers 0 to {}",
                               item, *options_.items, *options_.items - 1));
      }
    }
    add_numbers(*x, *y);
  }

  void add_named(const Row& row) {
    const Element a = item_called(row[0]);
    const Element b = item_called(row[1]);
    pairs_.add(a, b);
  }

  void add_numbers(Element x, Element y) {
    largest_ = std::max({largest_, x, y});
    pairs_.add(x, y);
  }

  // Words over numbers are the names of columns.
  void settle_first_line(bool numbers_follow) {
    if (first_line_.empty()) {
      return;
    }
    const Row row = std::move(first_line_);
    first_line_.clear();
    if (!numbers_follow) {
      become_named();
      add_named(row);
    }
  }

  // What were numbers are names from now on.
  void become_named() {
    if (named_) {
      return;
    }
    named_ = true;
    Field number;
    pairs_.each([&](Element& x, Element& y) {
      for (Element* const item : {&x, &y}) {
        number.text = std::to_string(*item);
        *item = item_called(number);
      }
    });
  }

  void check_name(const Field& field) {
    const std::string& word = field.text;
    if (word.size() > longest_name) {
      rows_.fail(field, "a name of more than 255 bytes; shorten it");
    }
    if (const auto character = invisible_character(word)) {
      rows_.fail(field, fmt::format("the name '{}' has a character that cannot be seen, {}; "
                                    "remove it",
                                    word, *character));
    }
    if (word.find('|') != std::string_view::npos) {
      rows_.fail(field, fmt::format("the name '{}' has a '|', which stands between the names of a "
                                    "pair; rename it",
                                    word));
    }
  }

  Element item_called(const Field& field) {
    const std::string& word = field.text;
    const auto [found, is_new] = numbers_.try_emplace(word, static_cast<Element>(names_.size()));
    if (is_new) {
      check_name(field);
      if (const auto number = as_number(word)) {
        const auto [other, first] = written_.try_emplace(*number, word);
        if (!first) {
          rows_.fail(field,
                     fmt::format("'{}' and '{}' are one number and two names; write it in one way",
                                 other->second, word));
        }
      }
      if (names_.size() == options_.items.value_or(most_items)) {
        rows_.fail(field, fmt::format("'{}' is one name more than {} items", word, names_.size()));
      }
      names_.push_back(word);
    }
    return found->second;
  }

  RowReader rows_;
  std::string name_;
  PairFileOptions options_;
  Row row_;
  Pieces pairs_;
  bool seen_any_ = false;
  bool named_ = false;
  Row first_line_;
  Element largest_ = 0;
  std::vector<std::string> names_;
  std::unordered_map<std::string, Element> numbers_;
  std::unordered_map<std::string, std::string> written_;  // names that are numbers, by the number
};

}  // namespace

std::shared_ptr<const PairGraph> read_pairs(Input& input, const PairFileOptions& options) {
  return PairReader(input, options).read();
}

std::shared_ptr<const PairGraph> read_pairs(const std::string& path,
                                            const PairFileOptions& options) {
  return read_pairs(*open_list(path), options);
}

}  // namespace changeover
