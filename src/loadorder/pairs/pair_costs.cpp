#include "loadorder/pairs/pair_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "loadorder/pairs/item_names.hpp"

namespace changeover {
namespace {

using Costs = std::unordered_map<std::uint64_t, double>;

// A limit with which sums of costs remain finite.
constexpr double highest_cost = 1e100;

std::uint64_t key_of(Element x, Element y) {
  return std::uint64_t{std::max(x, y)} << 32 | std::min(x, y);
}

template <typename Number>
std::optional<Number> number_in(const Field& field) {
  Number number{};
  const char* const end = field.text.data() + field.text.size();
  const auto [stop, error] = std::from_chars(field.text.data(), end, number);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

class CostList {
 public:
  CostList(Input& input, const WantedPairs& wanted, std::vector<std::string>* notes)
      : rows_(input, item_row_options()),
        notes_(notes),
        items_(wanted.items()),
        numbers_(items_by_name(wanted.graph())) {}

  Costs read() {
    each_item_row(
        rows_, notes_, [this](const Row& row) { return is_header(row); },
        [this](const Row& row) { take(row); });
    return std::move(costs_);
  }

 private:
  // A header is words over columns, none of which is an item; otherwise the cost of a pair would be
  // lost.
  [[nodiscard]] bool is_header(const Row& row) const {
    const auto is_item = [&](const Field& field) {
      return numbers_.contains(field.text) || number_in<double>(field);
    };
    return row.size() == 3 && !number_in<double>(row[2]) && !is_missing_number(row[2].text) &&
           !is_item(row[0]) && !is_item(row[1]);
  }

  Element item(const Field& field) {
    if (!numbers_.empty()) {
      const auto found = numbers_.find(field.text);
      if (found == numbers_.end()) {
        rows_.fail(field,
                   fmt::format("'{}' is not in the listed pairs; write it as there", field.text));
      }
      return found->second;
    }
    const auto number = number_in<Element>(field);
    if (!number || *number >= items_) {
      rows_.fail(field,
                 fmt::format("item {} does not exist; items are 0 to {}", field.text, items_ - 1));
    }
    return *number;
  }

  void take(const Row& row) {
    if (row.size() != 3) {
      rows_.fail(row[std::min<std::size_t>(row.size() - 1, 3)],
                 "the cost of the pair is missing; write two items and a cost in each row");
    }
    const Element x = item(row[0]);
    const Element y = item(row[1]);
    const double cost = cost_in(rows_, row[2]);
    if (x == y) {
      rows_.fail(row[1],
                 fmt::format("'{}' is both items; a pair has two different ones", row[1].text));
    }
    if (!costs_.emplace(key_of(x, y), cost).second) {
      rows_.fail(row[0],
                 fmt::format("the pair of '{}' and '{}' has a cost already; keep one of the two",
                             row[0].text, row[1].text));
    }
  }

  RowReader rows_;
  std::vector<std::string>* notes_;
  std::uint64_t items_;
  std::unordered_map<std::string, Element> numbers_;  // of names
  Costs costs_;
};

}  // namespace

double cost_in(const RowReader& rows, const Field& field) {
  const auto cost = number_in<double>(field);
  if (!cost || !std::isfinite(*cost) || *cost < 0) {
    rows.fail(field, fmt::format("'{}' is not a cost; give a number, 0 or more", field.text));
  }
  if (*cost > highest_cost) {
    rows.fail(field, fmt::format("'{}' is too much for a cost; give {} at most", field.text,
                                 highest_cost));
  }
  return *cost;
}

std::function<double(Element, Element)> read_pair_costs(Input& input, const WantedPairs& wanted,
                                                        std::vector<std::string>* notes) {
  const auto costs = std::make_shared<const Costs>(CostList(input, wanted, notes).read());
  return [costs](Element x, Element y) {
    const auto found = costs->find(key_of(x, y));
    return found == costs->end() ? 1.0 : found->second;
  };
}

}  // namespace changeover
