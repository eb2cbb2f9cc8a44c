// The cheapest plan of a tiny job, by looking at all of them.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover::test {

/// The least cost, in millionths, of covering at least so many needed pairs (all of them by default); nullopt
/// if that is impossible. A dynamic program over the pairs covered and the last set-up: a step that covers
/// nothing new can be left out, since going straight to the next set-up introduces no more. For jobs of up to
/// six parts.
inline std::optional<std::uint64_t> least_cost(const Job& job,
                                               std::optional<std::uint64_t> pairs = {}) {
  const std::size_t v = job.names.size();
  std::vector<std::pair<Element, Element>> needed;
  job.needed.for_each(1000, [&](Element x, Element y) { needed.emplace_back(x, y); });
  const auto mask_of = [](const Block& block) {
    unsigned mask = 0;
    for (const Element x : block) {
      mask |= 1U << x;
    }
    return mask;
  };
  const unsigned mounted = mask_of(job.mounted);
  struct SetUp {
    unsigned parts = 0;
    unsigned pairs = 0;
  };
  std::vector<SetUp> setups;
  for (unsigned parts = 1; parts < 1U << v; ++parts) {
    bool allowed = static_cast<std::uint64_t>(std::popcount(parts)) <= job.at_once &&
                   (parts & mounted) == mounted;
    job.never.for_each(1000, [&](Element x, Element y) {
      allowed = allowed && ((parts >> x & 1U) == 0 || (parts >> y & 1U) == 0);
    });
    for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
      std::uint64_t there = 0;
      for (std::size_t x = 0; x < v; ++x) {
        there += (parts >> x & 1U) != 0 && job.slot_of[x] == s ? 1U : 0U;
      }
      allowed = allowed && job.slots[s].least <= there && there <= job.slots[s].most;
    }
    SetUp setup{parts, 0};
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if ((parts >> needed[i].first & 1U) != 0 && (parts >> needed[i].second & 1U) != 0) {
        setup.pairs |= 1U << i;
      }
    }
    if (allowed && setup.pairs != 0) {
      setups.push_back(setup);
    }
  }
  const auto step = [&](unsigned from, unsigned to) {
    std::uint64_t cost = job.test_cost.millionths;
    for (std::size_t x = 0; x < v; ++x) {
      if ((to >> x & 1U) != 0 && (from >> x & 1U) == 0) {
        cost += job.change_costs[x].millionths;
      }
    }
    return cost;
  };
  constexpr auto never = std::numeric_limits<std::uint64_t>::max();
  const std::size_t states = std::size_t{1} << needed.size();
  const std::uint64_t wanted = pairs.value_or(needed.size());
  std::vector<std::vector<std::uint64_t>> cost(states,
                                               std::vector<std::uint64_t>(setups.size(), never));
  const unsigned start = mask_of(job.start);
  std::uint64_t best = wanted == 0 ? 0 : never;
  for (std::size_t s = 0; s < setups.size(); ++s) {
    cost[setups[s].pairs][s] = step(start, setups[s].parts);
  }
  for (std::size_t covered = 0; covered < states; ++covered) {
    for (std::size_t s = 0; s < setups.size(); ++s) {
      if (cost[covered][s] == never) {
        continue;
      }
      if (static_cast<std::uint64_t>(std::popcount(covered)) >= wanted) {
        best = std::min(best, cost[covered][s]);
      }
      for (std::size_t next = 0; next < setups.size(); ++next) {
        const std::size_t now = covered | setups[next].pairs;
        if (now != covered) {
          cost[now][next] = std::min(cost[now][next],
                                     cost[covered][s] + step(setups[s].parts, setups[next].parts));
        }
      }
    }
  }
  return best == never ? std::nullopt : std::optional(best);
}

}  // namespace changeover::test
