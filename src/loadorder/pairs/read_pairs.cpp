#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "loadorder/pairs/item_names.hpp"
#include "loadorder/pairs/listed_rows.hpp"
#include "loadorder/pairs/pair_costs.hpp"

namespace changeover {
namespace {

// Items with anything between them. Lists are long: a row is not kept.
RowOptions row_options(bool groups) {
  RowOptions options = item_row_options();
  if (!groups) {
    options.longest_line = 65'536;
    options.too_long = "a line of more than 65536 bytes; give two items per line";
  }
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

/// Whether a column may have this title, such as "cost (s)": letters above all, so that a cost that
/// is mistyped is none.
bool is_title(std::string_view word) {
  const auto is = [](std::string_view among) {
    return [among](char c) { return is_letter(c) || among.find(c) != std::string_view::npos; };
  };
  return std::ranges::count_if(word, is("")) >= 2 && std::ranges::all_of(word, is(" _.()[]")) &&
         !is_missing_number(word);
}

class PairReader {
 public:
  PairReader(Input& input, const PairFileOptions& options)
      : rows_(input, row_options(options.groups)),
        name_(input.name()),
        options_(options),
        listed_(options.groups) {
    if (options_.items && (*options_.items == 0 || *options_.items > most_items)) {
      throw BadInput(fmt::format("{} items: give 1 to {}", *options_.items, most_items));
    }
  }

  std::shared_ptr<const PairGraph> read() {
    while (rows_.next_line()) {
      if (!named_ && seen_any_ && first_line_.empty() && columns_ <= 2 && !options_.groups) {
        const auto pair = plain_pair(rows_.line());
        if (pair && std::max(pair->first, pair->second) < options_.items.value_or(most_items)) {
          largest_ = std::max({largest_, pair->first, pair->second});
          listed_.add(pair->first, pair->second);
          continue;
        }
      }
      if (rows_.split(row_) && items_of_row()) {
        take();
      }
    }
    settle_first_line(false);
    check_heading();
    if (listed_.pairs() == 0) {
      throw BadInput(name_ + (options_.groups
                                  ? ": no pair is in a group; give two items or more per line"
                                  : ": no pair is listed; give two items per line"));
    }
    constexpr std::uint64_t bytes_a_pair = 2 * sizeof(Element);
    require_memory(listed_.pairs() * bytes_a_pair,
                   fmt::format("{}: a list of {} pairs", name_, listed_.pairs()));
    const std::uint64_t items = options_.items && names_.empty() ? *options_.items
                                : names_.empty()                 ? std::uint64_t{largest_} + 1
                                                                 : names_.size();
    numbers_.clear();
    written_.clear();
    auto graph = std::make_shared<const PairGraph>(
        items, [&](const PairGraph::Visit& visit) { listed_.each_pair(visit); }, std::move(names_));
    if (columns_ > 2) {
      *options_.costs = costs_of(graph);
    }
    return graph;
  }

 private:
  // Reduces a row to its two items; false for a row without items.
  bool items_of_row() {
    take_fields(row_, rows_);
    if (!options_.groups) {
      if (row_.size() > 3 || (row_.size() == 3 && options_.costs == nullptr)) {
        rows_.fail(row_[2],
                   "more than two items; give two per line, and names with blanks in "
                   "quotes" +
                       options_.no_costs);
      }
      if (row_.size() == 1) {
        rows_.fail(row_[0], "one item stands alone; give two per line");
      }
    }
    for (const Field& field : row_) {
      if (!field.in_quotes && are_numbers(field.text)) {
        rows_.fail(field,
                   fmt::format("'{}' is more than one number; give two items per line, or put "
                               "it in quotes if it is a name",
                               field.text));
      }
    }
    return !row_.empty();
  }

  void take() {
    const bool words = std::ranges::none_of(
        row_, [](const Field& field) { return as_number(field.text).has_value(); });
    if (!options_.groups && !take_cost(words)) {
      return;
    }
    const bool numbers = std::ranges::all_of(
        row_, [](const Field& field) { return item_number(field).has_value(); });
    if (!seen_any_ && words && columns_ < 3 && !rows_.is_given()) {  // perhaps names of columns
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
      if (!named_ && !listed_.empty()) {
        for (const Field& field : row_) {
          check_written_plainly(rows_, field);
        }
      }
      become_named();
      add_named(row_);
      return;
    }
    items_.clear();
    for (const Field& field : row_) {
      const Element item = *item_number(field);
      if (options_.items && item >= *options_.items) {
        rows_.fail(field, fmt::format("item {} does not exist; items are 0 to {}", item,
                                      *options_.items - 1));
      }
      largest_ = std::max(largest_, item);
      items_.push_back(item);
    }
    add_items(row_.front());
  }

  void add_named(const Row& row) {
    items_.clear();
    for (const Field& field : row) {
      items_.push_back(item_called(field));
    }
    add_items(row.front());
  }

  void add_items(const Field& first) {
    if (!listed_.add(items_)) {
      rows_.fail(first, fmt::format("with this group more than {} pairs are wanted; give smaller "
                                    "groups",
                                    most_pairs_in_groups));
    }
  }

  // Takes the third column off a row of a list of pairs; false if the row names columns.
  bool take_cost(bool words) {
    const std::size_t columns = row_.size();
    const bool names_columns =
        !seen_any_ && words && columns == 3 && !rows_.is_given() && is_title(row_.back().text);
    if (columns_ != 0 && columns != columns_) {
      rows_.fail(row_[columns - 1],
                 columns > columns_
                     ? "the pairs before have no cost; give one to every pair or to none"
                     : "the pairs before have a cost each; give one to every pair or to none");
    }
    columns_ = columns;
    seen_any_ = seen_any_ || names_columns;
    if (names_columns) {
      heading_ = row_;
    }
    if (columns == 3 && !names_columns) {
      if (row_[0].text == row_[1].text) {
        rows_.fail(row_[1],
                   fmt::format("'{}' is both items; a pair has two different ones", row_[1].text));
      }
      costs_.push_back(cost_in(rows_, row_[2]));
    }
    row_.resize(2);
    return !names_columns;
  }

  std::function<double(Element, Element)> costs_of(const std::shared_ptr<const PairGraph>& graph) {
    constexpr double none = -1;
    std::vector<double> by_place(2 * graph->pairs(), none);
    std::size_t row = 0;
    listed_.each_pair([&](Element x, Element y) {
      const double cost = costs_[row++];
      double& known = by_place[*graph->place(x, y)];
      if (known != none && known != cost) {
        const auto called = [&](Element item) {
          return graph->names().empty() ? std::to_string(item) : graph->names()[item];
        };
        throw BadInput(
            fmt::format("{}: the pair of '{}' and '{}' has two costs, {} and {}; keep "
                        "one of the two",
                        name_, called(x), called(y), known, cost));
      }
      known = cost;
    });
    costs_ = {};
    return [graph, costs = std::make_shared<const std::vector<double>>(std::move(by_place))](
               Element x, Element y) {
      const auto place = graph->place(x, y);
      return place ? (*costs)[*place] : 1.0;
    };
  }

  // Words above numbers are column names.
  void settle_first_line(bool numbers_follow) {
    if (first_line_.empty()) {
      return;
    }
    const Row row = std::move(first_line_);
    first_line_.clear();
    if (numbers_follow && options_.groups) {  // a title would be a loss, if it is a group
      throw BadInput(name_ +
                     ": words in the first line, numbers below; begin the line with # if it "
                     "names columns, or write every item as a word");
    }
    const bool has_missing =
        std::ranges::any_of(row, [](const Field& field) { return is_missing_number(field.text); });
    if (numbers_follow && !has_missing) {
      heading_ = row;
      return;
    }
    if (numbers_follow) {
      note_first_pair(rows_, row, options_.notes);
    }
    become_named();
    add_named(row);
  }

  // A first row that was read as names of columns would be a pair that is lost, if what comes below
  // it says that its words are items.
  void check_heading() {
    if (heading_.empty()) {
      return;
    }
    if (named_ && columns_ < 3) {
      rows_.fail(heading_.front(),
                 "words above numbers name columns, but names of items come further down; begin "
                 "the line with # if it names columns, or write it further down if it is a pair");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (numbers_.contains(heading_[i].text)) {
        rows_.fail(heading_[2],
                   fmt::format("'{}' is not a cost, and '{}' is an item of later rows; write the "
                               "cost of the pair, or begin the line with # if it names columns",
                               heading_[2].text, heading_[i].text));
      }
    }
    note_heading(rows_, heading_, options_.notes);
  }

  // From now on the numbers so far are names.
  void become_named() {
    if (named_) {
      return;
    }
    named_ = true;
    Field number;
    listed_.each_item([&](Element& item) {
      number.text = std::to_string(item);
      item = item_called(number);
    });
  }

  Element item_called(const Field& field) {
    const std::string& word = field.text;
    const auto [found, is_new] = numbers_.try_emplace(word, static_cast<Element>(names_.size()));
    if (is_new) {
      check_item_name(rows_, field);
      written_.add(rows_, field);
      if (names_.size() == options_.items.value_or(most_items)) {
        rows_.fail(field, fmt::format("'{}' is one name more than {} items; remove it, or give "
                                      "more items",
                                      word, names_.size()));
      }
      names_.push_back(word);
    }
    return found->second;
  }

  RowReader rows_;
  std::string name_;
  PairFileOptions options_;
  Row row_;
  std::vector<Element> items_;  // of a row
  ListedRows listed_;
  std::size_t columns_ = 0;    // of a list of pairs, 2 or 3; 0: not known yet
  std::vector<double> costs_;  // of its rows
  bool seen_any_ = false;
  bool named_ = false;
  Row first_line_;
  Row heading_;  // the first row, if it was read as names of columns
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
