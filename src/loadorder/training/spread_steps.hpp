// Internal: assigns each pair to a random one of the steps that have both items.
//
// The steps of a worker in an epoch are read first. Then each pair is assigned to a random step
// among all in which its worker (in lockstep, any worker) holds both items in this epoch. Finally
// pairs move from the fullest steps to others that can have them. The same seed gives the same
// steps; each epoch has its own random numbers.
#pragma once

#include <cstdint>
#include <memory>

#include "changeover/loadorder/schedule.hpp"

namespace changeover {

/// Limit for the pairs of an epoch, which take 24 bytes each.
inline constexpr std::uint64_t most_pairs_spread = 50'000'000;

/// Steps without overlap. @throws ImpossibleParameters while reading, if there are too many pairs
[[nodiscard]] std::unique_ptr<StepSource> spread_over_steps(std::unique_ptr<StepSource> steps,
                                                            const ScheduleRules& rules,
                                                            std::uint64_t seed);

}  // namespace changeover
