// Internal: some pairs only, for workers that step together and never hold one item twice.
//
// The items are in parts. A task is two parts, or one, with the listed pairs between them and some
// of those within them; it has an order of its own. No two workers have a task of the same part at
// the same time, so they never hold the same item. A worker that is ready takes the task whose
// parts have most left to do, or that shares a part with its last one, and items that stay useful
// stay.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// Steps of all workers: as many moves for each; workers beyond those have nothing to do.
struct LockstepLists {
  std::shared_ptr<const StepLists> lists;
  std::uint64_t workers = 0;  ///< with lists
  std::uint64_t steps = 0;
  std::uint64_t span = 0;
  std::uint64_t loads = 0;
  std::uint64_t parts = 0;
};

/// The best for several numbers of parts. W ≥ 2.
[[nodiscard]] LockstepLists lockstep_of_parts(const PairGraph& graph, std::uint64_t room,
                                              std::uint64_t workers);

}  // namespace changeover
