// What a step costs if that depends on what is replaced: the referee's own count.
#pragma once

#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Who comes into whose place, and what all changes of the step cost.
struct Replacement {
  Amount cost;
  std::vector<std::pair<Element, Element>> pairs;  ///< out and in, by the first
};

/// The cheapest way to take out some parts and put in others, as job.hpp defines it, for a job with
/// replace_costs. Up to ten places of a slot are tried in all ways; where there are more, parts
/// change places around in circles, the search for which is Bellman's and Ford's, until no circle
/// saves anything, and then nothing does. @throws ImpossibleParameters if the cost overflows.
[[nodiscard]] Replacement cheapest_replacement(const Job& job, const Block& out, const Block& in);

/// The two ways by themselves, for a square table of costs by row and place: the place of each row.
[[nodiscard]] std::vector<std::size_t> best_by_trying(
    const std::vector<std::vector<std::uint64_t>>& costs);
[[nodiscard]] std::vector<std::size_t> best_by_circles(
    const std::vector<std::vector<std::uint64_t>>& costs);

}  // namespace changeover
