// Internal: lockstep orders that are grown step by step.
//
// In a step each worker changes one item, or two workers exchange one: the change that brings most
// new pairs together. There are several rules for what is evicted, and none is best for all
// parameters. An order is a list of changes, so it can be cut at any step and grown again from
// there.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "run/random.hpp"

namespace changeover {

/// A worker loads `in` and evicts `out`.
struct LockstepChange {
  std::uint32_t worker = 0;
  Element out = 0;
  Element in = 0;
};

/// Worker w starts with items wC, …, wC + C − 1. Then follows a list of changes for each step, at
/// most one per worker.
struct GrownOrder {
  std::vector<std::vector<LockstepChange>> steps;
  std::uint64_t changes = 0;

  [[nodiscard]] bool better_than(const GrownOrder& other) const {
    return std::pair(steps.size(), changes) < std::pair(other.steps.size(), other.changes);
  }
};

/// Which item of a worker is evicted, and which of the items with the most pairs is loaded.
struct GrowthRule {
  enum class Goes { fewest_open_pairs, last_come, first_come, best_afterwards } goes;
  enum class Comes { any, fewest_open_pairs, most_open_pairs } comes;
};

inline constexpr std::size_t growth_rules = 12;
[[nodiscard]] GrowthRule growth_rule(std::size_t number);

/// Grows an order from the first `keep` steps of `start`. Nullopt if it would have more than
/// `most_steps`. W·C ≤ P, C ≥ 2.
[[nodiscard]] std::optional<GrownOrder> grow_order(std::uint64_t items, std::uint64_t room,
                                                   std::uint64_t workers, const GrownOrder& start,
                                                   std::size_t keep, GrowthRule rule,
                                                   std::uint64_t most_steps, Random& random);

/// 2W items, room for 2: the rounds of a tournament. Two successive perfect matchings form even
/// cycles, along which each worker keeps one item and takes the other from its neighbour: 2W + (2W
/// − 2)W loads, and the span is 2W.
[[nodiscard]] GrownOrder round_robin_order(std::uint64_t workers);

}  // namespace changeover
