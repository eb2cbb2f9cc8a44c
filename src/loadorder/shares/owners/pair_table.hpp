// Internal: pairs given to workers one by one, and what the workers then need not load.
//
// All workers' steps are played, and it is noted which of them have a pair. Pairs that several have
// are spread evenly, by what they cost; then a stay of an item at a worker that computes none of
// its pairs in that stay is left out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// At most so many items, unless pairs are listed, and 65,534 workers: 8 bytes a pair, and 16 for
/// one that several workers have.
inline constexpr std::uint64_t most_items_of_a_table = 5'000;
inline constexpr std::uint64_t most_workers_of_a_table = 65'534;

struct SpreadPairs {
  std::shared_ptr<const PairOwners> owners;
  std::shared_ptr<const WorkerSteps> steps;  ///< null: nothing was left out, or it was not to be
  std::vector<WorkerFacts>
      workers;  ///< as they are now; none of them has a first step if something was left out
};

/// Pairs, and items with themselves, that were `computed` before are no worker's. `of` gives the
/// steps of a worker, which `workers` describes. Of two levels, pairs are those on the accelerator,
/// and nothing is left out. O(pairs that workers have, with repetition). @throws BadInput for a
/// cost below 0
[[nodiscard]] SpreadPairs spread_pairs(
    const ScheduleRules& rules, const std::vector<WorkerFacts>& workers,
    const std::function<std::unique_ptr<StepSource>(std::uint64_t worker)>& of,
    const std::function<double(Element, Element)>& cost,
    const std::function<bool(Element, Element)>& computed = {});

}  // namespace changeover
