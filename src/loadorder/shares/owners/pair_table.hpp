// Internal: assigns pairs to workers one by one, and leaves out loads that are then needless.
//
// The steps of all workers are replayed, and the workers that have a pair are recorded. Pairs that
// several workers have are spread evenly, by cost, or belong to the first worker that has them. A
// stay of an item at a worker that computes none
// of its pairs in that stay is left out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// Limits: this many items, unless pairs are listed, and 65,534 workers. Memory: 8 bytes per pair,
/// and 16 for one that several workers have.
inline constexpr std::uint64_t most_items_of_a_table = 5'000;
inline constexpr std::uint64_t most_workers_of_a_table = 65'534;

struct SpreadPairs {
  std::shared_ptr<const PairOwners> owners;
  std::shared_ptr<const WorkerSteps> steps;  ///< null if nothing was left out, or should be
  std::vector<WorkerFacts>
      workers;  ///< after the change; without first steps if something was left out
};

/// Pairs, and items with themselves, that were `computed` before are assigned to no worker. `of`
/// returns the steps of a worker, and `workers` describes them. For two levels, pairs are those on
/// the accelerator, and nothing is left out. O(pairs that workers have, with repetition). @throws
/// BadInput for a negative cost
[[nodiscard]] SpreadPairs spread_pairs(
    const ScheduleRules& rules, const std::vector<WorkerFacts>& workers,
    const std::function<std::unique_ptr<StepSource>(std::uint64_t worker)>& of,
    const std::function<double(Element, Element)>& cost,
    const std::function<bool(Element, Element)>& computed = {}, bool first_holder = false);

/// Owners of the pairs that are given to each worker; `alone` are the items that it loads first.
[[nodiscard]] std::shared_ptr<const PairOwners> owners_of_lists(
    const WantedPairs& wanted, const std::vector<std::vector<ItemPair>>& pairs,
    const std::vector<std::vector<Element>>& alone);

/// Whether pairs are given one by one, and not by the step in which they meet.
[[nodiscard]] bool are_given_one_by_one(const PairOwners& owners);

}  // namespace changeover
