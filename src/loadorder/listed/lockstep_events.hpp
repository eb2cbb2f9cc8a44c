// Internal: what workers in lockstep load and evict, as a list of events.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/listed/parts.hpp"

namespace changeover {

/// An item that comes or goes at a worker. In a step all workers evict before any loads.
struct LockstepEvent {
  std::uint32_t step = 0;
  Element item = 0;
  bool comes = false;
};

/// By worker, in the order of the steps; of a step evictions first.
using LockstepEvents = std::vector<std::vector<LockstepEvent>>;

/// Leaves out stays in which no listed pair meets for the first time, steps in which nothing moves,
/// and joins steps that evict nothing to those before.
[[nodiscard]] LockstepLists lists_of(LockstepEvents events, const PairGraph& graph);

}  // namespace changeover
