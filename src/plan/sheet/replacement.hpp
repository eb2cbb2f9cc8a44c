// The cost of a step if it depends on what is replaced: an independent computation for run_sheet().
#pragma once

#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The replacements of a step, and the cost of all its changes.
struct Replacement {
  Amount cost;
  std::vector<std::pair<Element, Element>> pairs;  ///< out and in, sorted by the first
};

/// The cheapest way to take out some parts and put in others, as job.hpp defines it, for a job with
/// replace_costs. For up to ten places of a slot, all ways are tried. For more, parts change places
/// along cycles that reduce the cost (found by the method of Bellman and Ford) until there is none,
/// which is optimal. @throws ImpossibleParameters if the cost overflows.
[[nodiscard]] Replacement cheapest_replacement(const Job& job, const Block& out, const Block& in);

/// The two methods separately, for a square table of costs by row and place: returns the place of
/// each row.
[[nodiscard]] std::vector<std::size_t> best_by_trying(
    const std::vector<std::vector<std::uint64_t>>& costs);
[[nodiscard]] std::vector<std::size_t> best_by_circles(
    const std::vector<std::vector<std::uint64_t>>& costs);

}  // namespace changeover
