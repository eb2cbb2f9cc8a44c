// Internal: the steps of an order, alternating between forward and backward epochs.
//
// The pairs of a step can be computed after it in either direction, since the same items are in
// memory then. So a backward epoch begins with the items that the epoch before has left in memory,
// and loads what that one evicted. The first step of each epoch after the first moves nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// Limit for the loads and evictions that are stored for going back, 4 bytes each.
inline constexpr std::uint64_t most_moves_kept = 400'000'000;

/// Repeats the steps of `maker` `epochs` times, for workers in lockstep if there are any. Step
/// numbers continue. @throws ImpossibleParameters while reading, if there are too many steps to be
/// stored
[[nodiscard]] std::unique_ptr<StepSource> back_and_forth(const LoadOrder::Maker& maker,
                                                         std::uint64_t epochs,
                                                         std::uint64_t lockstep);

/// Counts the moves without any check; `workers` is for lockstep, and 1 for workers one after
/// another.
[[nodiscard]] ScheduleFacts count_moves(StepSource& steps, std::uint64_t workers,
                                        const ItemSizes* sizes);

/// @throws ImpossibleParameters if the loads, evictions and steps of an epoch need too much memory
void check_moves_kept(std::uint64_t moves, std::uint64_t steps);

/// @throws BadInput unless 1 ≤ epochs ≤ most_epochs
void check_epochs(std::uint64_t epochs);

/// For the busiest of several workers, given the bound for one epoch and that on the loads, or what
/// else is counted, of all workers.
[[nodiscard]] LoadBound epochs_makespan_bound(const LoadBound& once, const LoadBound& all,
                                              std::uint64_t workers,
                                              const std::string& what = "loads");

/// Bytes that several epochs load, given the bound for one and the memory of each worker.
[[nodiscard]] LoadBound epochs_byte_bound(const LoadBound& once, std::uint64_t memory,
                                          std::uint64_t workers, std::uint64_t epochs);

/// Adds to a certificate in how many epochs all pairs met.
[[nodiscard]] std::string in_each_epoch(const std::string& certificate, std::uint64_t epochs);

}  // namespace changeover
