// Internal: some pairs only, for workers that step together and never hold one item twice.
//
// Either the items are cut into parts, and a task of a worker is two of them (parts.hpp); or an
// order of one worker is cut into stretches (stretches_in_lockstep.hpp).
#pragma once

#include "changeover/loadorder/load_order.hpp"
#include "loadorder/listed/lockstep_events.hpp"

namespace changeover {

/// The best for several numbers of parts and several orders, which `options.search_pairs` goes on
/// to improve. Describes it in `facts`, whose wanted pairs, room, workers and bounds are known.
/// W ≥ 2.
[[nodiscard]] LockstepLists lockstep_of_list(LoadOrderFacts& facts, const PairGraph& graph,
                                             const LoadOrderOptions& options);

}  // namespace changeover
