// Internal: workers that take tasks, each of two parts of the items.
//
// No two workers have a task of the same part at the same time, so they never hold the same item.
// What stays useful stays.
#pragma once

#include <cstdint>

#include "loadorder/listed/lockstep_events.hpp"
#include "loadorder/listed/tasks.hpp"

namespace changeover {

/// Which task a worker takes that is ready: whose parts have most left to do, that shares a part
/// with its last one, or the largest.
enum class NextTask : std::uint8_t { most_left, same_part, largest };

/// Plays all workers, each of which loads at most one item in a step.
[[nodiscard]] LockstepEvents play_tasks(const Tasks& tasks, std::uint64_t items, std::uint64_t room,
                                        std::uint64_t workers, NextTask choice);

}  // namespace changeover
