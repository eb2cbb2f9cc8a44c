// Internal: two levels whose loads run while pairs are computed on the accelerator.
//
// What the accelerator does in each step stays as it is. A load starts in the first step in which
// memory has room for it, in the sequence in which items are transferred; an item leaves memory
// when its place is needed and the accelerator has done with it, and is not loaded again if it is
// still there. So what waits for a load is its first transfer alone.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// What the same steps of one worker move, with other evictions and loads. `spare` is the room that
/// a cache leaves free for what is loading, at most room − the room of the accelerator; 0: what the
/// steps keep for each other stays. Room is counted in bytes if there are sizes. @throws
/// ImpossibleParameters if there are too many moves to be kept
[[nodiscard]] std::vector<Move> loads_ahead(StepSource& steps, std::uint64_t items,
                                            std::uint64_t room, std::uint64_t spare,
                                            const ItemSizes* sizes);

/// What can be left free, to be compared.
[[nodiscard]] std::vector<std::uint64_t> spares_to_try(const ScheduleRules& rules);

/// How long the steps take until the last pair is computed, in pairs: one disk loads item by item
/// in the time of docs/loadorder.md, and a transfer waits for its load. `steps` compute.
[[nodiscard]] double time_ahead(StepSource& steps, const ScheduleRules& rules);

}  // namespace changeover
