// Internal: the steps of an order, forward and backward in turn, an epoch each way.
//
// What a step computes can be computed after it in either direction, since the same items are held
// then; so an epoch that is run backward begins with what the epoch before has left in memory, and
// loads what that one evicted. The first step of an epoch, the first excepted, moves nothing.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// So many items are kept in mind to go backward: loaded or evicted, 4 bytes each.
inline constexpr std::uint64_t most_moves_kept = 400'000'000;

/// What `maker` makes, `epochs` times; of workers in lockstep, if there are any. Steps are numbered
/// on. @throws ImpossibleParameters while steps are read that are too many to be kept in mind
[[nodiscard]] std::unique_ptr<StepSource> back_and_forth(LoadOrder::Maker maker,
                                                         std::uint64_t epochs,
                                                         std::uint64_t lockstep);

/// What moves, without any check; of workers in lockstep, or of others one after another: 1.
[[nodiscard]] ScheduleFacts count_moves(StepSource& steps, std::uint64_t workers);

/// @throws ImpossibleParameters if loads, evictions and steps of an epoch take too much memory to
/// be kept
void check_moves_kept(std::uint64_t moves, std::uint64_t steps);

/// @throws BadInput unless 1 ≤ epochs ≤ most_epochs
void check_epochs(std::uint64_t epochs);

/// Of the busiest of several workers, given the bound for one epoch and that on all their loads.
[[nodiscard]] LoadBound epochs_makespan_bound(const LoadBound& once, const LoadBound& all,
                                              std::uint64_t workers);

/// Says of a verdict that was read how often all met.
[[nodiscard]] std::string in_each_epoch(const std::string& certificate, std::uint64_t epochs);

}  // namespace changeover
