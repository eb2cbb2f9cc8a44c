#include "answer/planned_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/cli.hpp"

namespace changeover::cli {
namespace {

PlanRange with_surroundings(const TableRange& range) {
  const auto& [k, v, change] = range;
  // Designs beyond the range help inside it: larger ones can be truncated, smaller blocks extended. An
  // element less comes with a smaller block only, so few smaller v can matter.
  constexpr std::uint64_t margin = 8;
  const std::uint64_t k_from = std::max<std::uint64_t>(2, k.from - 1);
  // And w elements more at once by partial expansion, at most about every k-th; what is better comes from there.
  const std::uint64_t less = std::max(k.to - k_from, v.from / k.from + margin);
  return {.v_from = v.from - std::min(v.from - 2, less),
          .v_to = std::min(v.to + margin, largest_v_of_a_plan),
          .k_from = k_from,
          .k_to = k.to,
          .change = change};
}

}  // namespace

TableRange table_range(const std::string& k, const std::string& v,
                       std::optional<std::uint64_t> change) {
  TableRange range{.k = range_of("--k", k, 2), .v = {}, .change = change.value_or(2)};
  range.v = range_of("--v", v, range.k.from);
  if (range.k.from < 2) {
    throw UsageError{fmt::format("--k {}: blocks have at least 2 elements", k)};
  }
  if (range.v.from < 2 || range.v.to > largest_v_of_a_plan) {
    throw UsageError{
        fmt::format("--v {}: a table goes from v = 2 to v = {}", v, largest_v_of_a_plan)};
  }
  if (range.change < 1) {
    throw UsageError{"--change 0: consecutive blocks differ in at least 1 element"};
  }
  const PlanRange asked = with_surroundings(range);
  if (asked.k_to - asked.k_from >= most_cells_of_a_plan / 2 / (asked.v_to - asked.v_from + 1)) {
    throw UsageError{
        fmt::format("--k {} --v {}: the range has more than {} cells", k, v, most_cells_of_a_plan)};
  }
  return range;
}

Plan planned(const TableRange& range) {
  return plan_range(Registry::standard(), with_surroundings(range));
}

std::vector<const PlannedCell*> cells_of(const Plan& plan, const TableRange& range, Kind kind) {
  std::vector<const PlannedCell*> cells;
  for (std::uint64_t k = range.k.from; k <= range.k.to; ++k) {
    for (std::uint64_t v = range.v.from; v <= range.v.to; ++v) {
      cells.push_back(&plan.at({.v = v, .k = k, .change = range.change, .kind = kind}));
    }
  }
  return cells;
}

}  // namespace changeover::cli
