#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "loadorder/pairs/item_names.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

std::optional<std::uint64_t> whole_number(std::string_view text, std::string_view& rest) {
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  rest = text.substr(static_cast<std::size_t>(stop - text.data()));
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

class SizeList {
 public:
  SizeList(std::unique_ptr<Input> input, std::optional<std::uint64_t> items, const PairGraph* graph,
           std::vector<std::string>* notes)
      : input_(std::move(input)),
        rows_(*input_, item_row_options()),
        items_(graph != nullptr ? graph->items() : items),
        graph_(graph),
        notes_(notes),
        numbers_(items_by_name(graph)) {}

  // Both are called once.
  std::vector<std::uint64_t> read() {
    each_item_row(
        rows_, notes_, [this](const Row& row) { return is_heading(row); },
        [this](const Row& row) { take(row); });
    return finish();
  }
  std::vector<std::string> take_names() { return std::move(names_); }

  [[nodiscard]] std::string place(Element x) const {
    Field field;
    std::tie(field.line, field.offset) = places_[x];
    return rows_.place(field);
  }

 private:
  static std::optional<std::uint64_t> size_in(const Field& field) {
    std::string_view unit;
    const auto number = whole_number(field.text, unit);
    constexpr std::string_view units = "KMGT";
    std::uint64_t bytes = 1;
    if (unit.size() == 1 && units.find(unit[0]) != std::string_view::npos) {
      for (std::size_t i = 0; i <= units.find(unit[0]); ++i) {
        bytes *= 1000;
      }
    } else if (!unit.empty() && unit != "B") {
      return std::nullopt;
    }
    constexpr std::uint64_t most = 1'000'000'000'000'000;  // sums of sizes still fit
    return number && *number > 0 && *number <= most / bytes ? std::optional(*number * bytes)
                                                            : std::nullopt;
  }

  // Words such as "NaN", "-3" and "1e400" are wrong sizes, not names.
  static bool is_meant_as_size(std::string_view word) {
    const std::size_t first = std::min(word.find_first_not_of("+-."), word.size());
    return is_missing_number(word) || is_digit(word[first]);
  }

  // A first line in which no cell looks like a size, or is an item.
  bool is_heading(const Row& row) {
    const bool is = row.size() <= 2 && !is_meant_as_size(row.front().text) &&
                    !is_meant_as_size(row.back().text) && !numbers_.contains(row.front().text) &&
                    row.back().text.find_first_of("0123456789") == std::string::npos;
    heading_ = is ? row : Row();
    return is;
  }

  // A word alone above items with sizes may be an item whose size is missing.
  void check_heading(std::size_t columns) const {
    if (heading_.size() == 1 && columns == 2) {
      rows_.fail(heading_.front(),
                 fmt::format("'{}' stands alone above items with sizes; write its size, or name "
                             "both columns if it heads them",
                             heading_.front().text));
    }
  }

  void take(const Row& row) {
    if (row.size() > 2 || (columns_ != 0 && row.size() != columns_)) {
      rows_.fail(row.back(),
                 "rows have different forms; give an item and its bytes in each, or only bytes");
    }
    if (columns_ == 0) {
      check_heading(row.size());
    }
    columns_ = row.size();
    const auto size = size_in(row.back());
    if (!size) {
      rows_.fail(row.back(),
                 fmt::format("'{}' is not a size; give a whole number of bytes, 1 to 1000T, or "
                             "with K, M, G or T, as in 4M",
                             row.back().text));
    }
    const Element x = columns_ == 1 ? static_cast<Element>(sizes_.size()) : item(row.front());
    if (items_ && x >= *items_) {
      rows_.fail(row.front(),
                 fmt::format("item {} does not exist; items are 0 to {}", x, *items_ - 1));
    }
    if (x >= sizes_.size()) {
      sizes_.resize(x + 1, 0);
      places_.resize(sizes_.size());
    }
    if (sizes_[x] != 0) {
      rows_.fail(row.front(), fmt::format("'{}' has a size already, in {} {}; keep one of the two",
                                          row.front().text, rows_.is_workbook() ? "row" : "line",
                                          places_[x].first));
    }
    sizes_[x] = *size;
    places_[x] = {row.back().line, row.back().offset};
  }

  // A list of names alone defines the items.
  Element item(const Field& field) {
    const auto number = item_number(field);
    const bool is_number = number.has_value();
    const bool by_name = graph_ != nullptr ? !numbers_.empty() : named_.value_or(!is_number);
    if (!by_name) {
      if (!is_number) {
        check_written_plainly(rows_, field);
        rows_.fail(field, fmt::format("'{}' is not a number, but the items before it are; number "
                                      "all items from 0, or name all of them",
                                      field.text));
      }
      named_ = false;
      return *number;
    }
    const auto found = numbers_.find(field.text);
    if (found != numbers_.end()) {
      return found->second;
    }
    if (graph_ != nullptr) {
      rows_.fail(field,
                 fmt::format("'{}' is not in the listed pairs; write it as there", field.text));
    }
    check_item_name(rows_, field);
    written_.add(rows_, field);
    named_ = true;
    names_.push_back(field.text);
    numbers_.emplace(field.text, static_cast<Element>(names_.size() - 1));
    return static_cast<Element>(names_.size() - 1);
  }

  std::vector<std::uint64_t> finish() {
    if (sizes_.empty()) {
      throw BadInput(input_->name() + ": no size is listed; give an item and its bytes per line");
    }
    sizes_.resize(
        std::max<std::size_t>(sizes_.size(), static_cast<std::size_t>(items_.value_or(0))), 0);
    for (Element x = 0; x < sizes_.size(); ++x) {
      if (sizes_[x] == 0 && (graph_ == nullptr || graph_->is_needed(x))) {
        const bool by_name = graph_ != nullptr && !graph_->names().empty();
        throw BadInput(fmt::format("{}: item {} has no size; give one for each item",
                                   input_->name(),
                                   by_name ? graph_->names()[x] : std::to_string(x)));
      }
    }
    return std::move(sizes_);
  }

  std::unique_ptr<Input> input_;
  RowReader rows_;
  std::optional<std::uint64_t> items_;
  const PairGraph* graph_;
  std::vector<std::string>* notes_;
  std::vector<std::string> names_;
  std::optional<bool> named_;
  std::unordered_map<std::string, Element> numbers_;
  WrittenNumbers written_;
  std::size_t columns_ = 0;
  Row heading_;
  std::vector<std::uint64_t> sizes_;
  std::vector<std::pair<std::uint64_t, std::size_t>> places_;  // line and offset, by item
};

}  // namespace

SizesRead read_sizes(std::unique_ptr<Input> input, std::optional<std::uint64_t> items,
                     const PairGraph* graph, std::vector<std::string>* notes) {
  const auto list = std::make_shared<SizeList>(std::move(input), items, graph, notes);
  std::vector<std::uint64_t> bytes = list->read();
  return {std::move(bytes), list->take_names(), [list](Element x) { return list->place(x); }};
}

}  // namespace changeover
