#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "io/scan/row_reader.hpp"
#include "loadorder/pairs/item_names.hpp"

namespace changeover {
namespace {

// Items with any separators. Lists are long, so rows are not kept.
RowOptions row_options() {
  RowOptions options = RowOptions::of_any_length();
  options.any_separator = options.blanks = options.percent_too = true;
  options.longest_line = 65'536;
  options.too_long = "a line of more than 65536 bytes; give two items a line";
  return options;
}

bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; }

/// "0 1": two numbers, meant as two items rather than as one name.
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

/// Parses a line in the most common form: digits, one blank, tab or comma, digits. Nullopt for
/// every other line.
std::optional<std::pair<Element, Element>> plain_pair(std::string_view line) {
  constexpr std::size_t most_digits = 7;  // below most_items
  static_assert(most_items == 10'000'000);
  std::size_t at = 0;
  const auto number = [&](Element& value) {
    const std::size_t begin = at;
    value = 0;
    for (; at < line.size() && line[at] >= '0' && line[at] <= '9'; ++at) {
      value = 10 * value + static_cast<Element>(line[at] - '0');  // unused if there are more digits
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

/// Pairs in pieces, so that growing moves none of them. A piece is so large that freeing it returns
/// it to the system at once, and its unused part takes no memory.
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
  // Reduces a row to its two items; false for a row without items.
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
        !as_number(row_[1].text)) {  // possibly column names
      seen_any_ = true;
      first_line_ = row_;
      for (const Field& field : first_line_) {
        check_item_name(rows_, field);
      }
      return;
    }
    seen_any_ = true;
    settle_first_line(numbers);
    if (named_ || !numbers) {
      if (!named_ && !pairs_.empty()) {
        for (const Field& field : row_) {
          check_written_plainly(rows_, field);
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

  // Words above numbers are column names.
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

  // From now on the numbers so far are names.
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

  Element item_called(const Field& field) {
    const std::string& word = field.text;
    const auto [found, is_new] = numbers_.try_emplace(word, static_cast<Element>(names_.size()));
    if (is_new) {
      check_item_name(rows_, field);
      written_.add(rows_, field);
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
  WrittenNumbers written_;
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
