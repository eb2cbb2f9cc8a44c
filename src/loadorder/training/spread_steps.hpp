// Internal: pairs given to steps at random, each to one of those that have both items.
//
// What each step of a worker computes in an epoch is read first; then each pair goes to a random
// step among all in which its worker, or in lockstep any worker, holds both items in this epoch;
// and then pairs of the fullest steps move to others that may have them. The same seed gives the
// same steps; each epoch has random numbers of its own.
#pragma once

#include <cstdint>
#include <memory>

#include "changeover/loadorder/schedule.hpp"

namespace changeover {

/// So many pairs of an epoch are kept in memory, 24 bytes each.
inline constexpr std::uint64_t most_pairs_spread = 50'000'000;

/// Steps without overlap. While they are read: @throws ImpossibleParameters for more pairs than
/// can be spread
[[nodiscard]] std::unique_ptr<StepSource> spread_over_steps(std::unique_ptr<StepSource> steps,
                                                            const ScheduleRules& rules,
                                                            std::uint64_t seed);

}  // namespace changeover
