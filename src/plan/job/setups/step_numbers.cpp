#include "plan/job/setups/step_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

// A text that is a number and nothing else, as 3, -1, 2.5 and 1e300.
std::optional<double> step_said(const std::string& text) {
  double number = 0;
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, number);
  const bool is_number = text.size() > sign && is_digit(text[sign]) && rest == end;
  if (failure == std::errc::result_out_of_range && is_number) {
    return sign == 0 ? HUGE_VAL : -HUGE_VAL;
  }
  return failure == std::errc() && is_number ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> StepNumbers::take(const Row& row, const SetupColumns& columns,
                                               const std::string& text, const RowReader& reader) {
  if (!columns.step || *columns.step >= row.size()) {
    offsets_.push_back(0);
    return std::nullopt;
  }
  const Field& cell = row[*columns.step];
  offsets_.push_back(cell.offset);
  const auto number = step_said(text.starts_with('#') ? text.substr(1) : text);
  if (number && !(*number >= 0 && *number <= static_cast<double>(most_steps))) {
    reader.fail(cell,
                fmt::format("{} is not the number of a step; write a whole number, at most {}",
                            shown(text), most_steps));
  }
  if (number && std::floor(*number) == *number) {
    return static_cast<std::uint64_t>(*number);
  }
  if (!text.empty()) {
    others_ += unread_ ? 1U : 0U;
    unread_ = unread_ ? unread_ : fmt::format("{}: {}", reader.place(cell), shown(text));
  }
  return std::nullopt;
}

void StepNumbers::put_in_order(DoneList& list, const Row& header, const SetupColumns& columns,
                               const RowReader& reader) const {
  if (!columns.step) {
    const auto number = std::ranges::find_if(
        header, [](const Field& field) { return heads_row_numbers(field.text); });
    if (number != header.end()) {
      list.notes.push_back(fmt::format(
          "{}: the column {} is not read; the tests are taken in the order of the rows; call it "
          "step if it numbers them",
          reader.place(*number), shown(number->text)));
    } else if (std::ranges::any_of(header, [](const Field& field) {
                 const OwnHead* const own = own_head(field.text);
                 return own != nullptr && own->counts_new;
               })) {
      list.notes.push_back(fmt::format(
          "{}: the sheet has no column step, so the tests are taken in the order of the rows",
          reader.place(header.front())));
    }
    return;
  }
  const Field& head = header[*columns.step];
  if (!heads_steps(head.text)) {
    list.notes.push_back(fmt::format("{}: the steps are those of the column {}", reader.place(head),
                                     shown(head.text)));
  }
  if (unread_) {
    list.notes.push_back(fmt::format(
        "{} is not the number of a step{}, and a test without one follows that of the row above "
        "it; number the tests 1, 2, 3",
        *unread_,
        others_ == 0
            ? ""
            : fmt::format(", nor {} {}", others_ == 1 ? "is" : "are", count_of(others_, "other"))));
  }
  std::map<std::string, std::vector<std::size_t>> by_bench;
  for (std::size_t i = 0; i < list.rows.size(); ++i) {
    by_bench[list.rows[i].bench].push_back(i);
  }
  bool is_moved = false;
  for (const auto& [bench, at] : by_bench) {
    std::size_t repeated = 0;
    const Moved moved = put_in_order(list, at, repeated);
    is_moved = is_moved || moved == Moved::yes;
    if (moved == Moved::cannot) {
      const DoneRow& row = list.rows[repeated];
      list.notes.push_back(fmt::format(
          "{}: step {} is here a second time, so the tests are taken in the order of the rows; "
          "give each its own number",
          reader.place(Field{.text = {}, .offset = offsets_[repeated], .line = row.line}),
          *row.step));
    }
  }
  if (is_moved) {
    list.notes.push_back(
        fmt::format("{}: the rows are not in the order of their steps; they are taken in the order "
                    "of this column",
                    reader.place(head)));
  }
}

namespace {

// The places of rows of a bench by their steps; nothing if these say no order.
using Placed = std::vector<std::pair<std::uint64_t, std::size_t>>;

std::optional<Placed> by_steps(const std::vector<DoneRow>& rows,
                               const std::vector<std::vector<std::size_t>>& sheets) {
  Placed placed;
  for (const std::vector<std::size_t>& sheet : sheets) {
    std::set<std::uint64_t> seen;
    std::optional<std::uint64_t> last;
    for (const std::size_t i : sheet) {
      const auto step = rows[i].step;
      if ((!step && !last) || (step && !seen.insert(*step).second)) {
        return std::nullopt;
      }
      last = step ? step : last;
      placed.emplace_back(*last, i);
    }
  }
  return placed;
}

}  // namespace

bool put_sheets_in_order(std::vector<DoneRow>& rows, const std::vector<std::size_t>& begins) {
  std::map<std::string, std::vector<std::vector<std::size_t>>> by_bench;
  std::size_t sheet = 0;
  for (std::size_t i = begins.empty() ? rows.size() : begins.front(); i < rows.size(); ++i) {
    while (sheet + 1 < begins.size() && begins[sheet + 1] <= i) {
      ++sheet;
    }
    auto& of_bench = by_bench[rows[i].bench];
    of_bench.resize(begins.size());
    of_bench[sheet].push_back(i);
  }
  bool is_moved = false;
  for (const auto& [bench, sheets] : by_bench) {
    auto placed = by_steps(rows, sheets);
    const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
    if (!placed || std::ranges::is_sorted(*placed, before)) {
      continue;
    }
    const auto at = each_of<std::size_t>(*placed, [](const auto& each) { return each.second; });
    Placed with_results = *placed;
    std::erase_if(with_results, [&](const auto& each) { return rows[each.second].result.empty(); });
    is_moved = is_moved || !std::ranges::is_sorted(with_results, before);
    std::ranges::stable_sort(*placed, before);
    std::vector<DoneRow> sorted;
    for (const auto& [step, i] : *placed) {
      sorted.push_back(std::move(rows[i]));
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      rows[at[k]] = std::move(sorted[k]);
    }
  }
  return is_moved;
}

// The same for the rows of a bench. A number that occurs twice says nothing about the order; the
// row that has it again is then `repeated`.
StepNumbers::Moved StepNumbers::put_in_order(DoneList& list, const std::vector<std::size_t>& at,
                                             std::size_t& repeated) const {
  std::set<std::uint64_t> seen;
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  std::uint64_t last = 0;
  bool is_repeated = false;
  for (const std::size_t i : at) {
    if (const auto step = list.rows[i].step) {
      if (!seen.insert(*step).second && !is_repeated) {
        is_repeated = true;
        repeated = i;
      }
      last = *step;
    }
    order.emplace_back(last, i);
  }
  const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
  if (std::ranges::is_sorted(order, before)) {
    return Moved::no;
  }
  if (is_repeated) {
    return Moved::cannot;
  }
  std::ranges::stable_sort(order, before);
  std::vector<DoneRow> sorted;
  for (const auto& [step, i] : order) {
    sorted.push_back(std::move(list.rows[i]));
  }
  for (std::size_t k = 0; k < at.size(); ++k) {
    list.rows[at[k]] = std::move(sorted[k]);
  }
  return Moved::yes;
}

}  // namespace changeover
