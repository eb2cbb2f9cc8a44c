// Internal: what workers in lockstep load and evict, as a list of events.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// An item that comes or goes at a worker. In a step all workers evict before any loads.
struct LockstepEvent {
  std::uint32_t step = 0;
  Element item = 0;
  bool comes = false;
};

/// By worker, in the order of the steps; of a step evictions first.
using LockstepEvents = std::vector<std::vector<LockstepEvent>>;

/// Steps of all workers: as many moves for each; workers beyond those have nothing to do.
struct LockstepLists {
  std::shared_ptr<const StepLists> lists;
  std::uint64_t workers = 0;  ///< with lists
  std::uint64_t steps = 0;
  std::uint64_t span = 0;
  std::uint64_t loads = 0;
};

/// What the steps of all workers move, with groups of items if there are any: a step moves whole
/// groups then.
[[nodiscard]] LockstepEvents events_of(StepSource& steps, std::uint64_t workers,
                                       const Groups& groups = {});

/// Leaves out stays in which no listed pair meets for the first time, steps in which nothing moves,
/// and joins steps that evict nothing to those before. Without a graph all stays are kept. With
/// sizes span and loads are in bytes.
[[nodiscard]] LockstepLists lists_of(LockstepEvents events, const PairGraph* graph,
                                     const ItemSizes* sizes = nullptr);

/// The steps of a worker.
using WorkerMaker = std::function<std::unique_ptr<StepSource>(std::uint64_t worker)>;
[[nodiscard]] WorkerMaker steps_in(const LockstepLists& lists);

/// The steps of `busy` workers; others have as many, and nothing to do in them.
[[nodiscard]] WorkerMaker with_idle(WorkerMaker maker, std::uint64_t busy, std::uint64_t steps);

/// The steps of all workers, alternating.
[[nodiscard]] std::unique_ptr<StepSource> in_lockstep(const WorkerMaker& maker,
                                                      std::uint64_t workers);

}  // namespace changeover
