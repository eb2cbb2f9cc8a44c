// The cheapest plan of a tiny job, by looking at all of them.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover::test {

/// What cannot be done.
inline constexpr auto no_cost = std::numeric_limits<std::uint64_t>::max();

/// By set of needed pairs, one bit each in the order of PairSet, or of needed triples if there are
/// any: the least cost, in millionths, of a list that covers these and no others. A dynamic program
/// over what is covered and the last set-up: a step that covers nothing new can be left out, since
/// going straight to the next set-up introduces no more. For jobs of up to six parts.
inline std::vector<std::uint64_t> least_costs(const Job& job) {
  const std::size_t v = job.names.size();
  std::vector<unsigned> needed;  // the parts of each
  job.needed.for_each(1000, [&](Element x, Element y) {
    if (job.triples.empty()) {
      needed.push_back(1U << x | 1U << y);
    }
  });
  for (const Triple& t : job.triples) {
    needed.push_back(1U << t[0] | 1U << t[1] | 1U << t[2]);
  }
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
      if ((parts & needed[i]) == needed[i]) {
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
  constexpr auto never = no_cost;
  const std::size_t states = std::size_t{1} << needed.size();
  std::vector<std::vector<std::uint64_t>> cost(states,
                                               std::vector<std::uint64_t>(setups.size(), never));
  const unsigned start = mask_of(job.start);
  std::vector<std::uint64_t> least(states, never);
  least[0] = 0;
  for (std::size_t s = 0; s < setups.size(); ++s) {
    cost[setups[s].pairs][s] = step(start, setups[s].parts);
  }
  for (std::size_t covered = 0; covered < states; ++covered) {
    for (std::size_t s = 0; s < setups.size(); ++s) {
      if (cost[covered][s] == never) {
        continue;
      }
      least[covered] = std::min(least[covered], cost[covered][s]);
      for (std::size_t next = 0; next < setups.size(); ++next) {
        const std::size_t now = covered | setups[next].pairs;
        if (now != covered) {
          cost[now][next] = std::min(cost[now][next],
                                     cost[covered][s] + step(setups[s].parts, setups[next].parts));
        }
      }
    }
  }
  return least;
}

/// The least cost, in millionths, of covering at least so many needed pairs or triples (all of them
/// by default); nullopt if that is impossible.
inline std::optional<std::uint64_t> least_cost(const Job& job,
                                               std::optional<std::uint64_t> pairs = {}) {
  const std::vector<std::uint64_t> least = least_costs(job);
  const auto all = static_cast<std::uint64_t>(std::popcount(least.size() - 1));
  std::uint64_t best = no_cost;
  for (std::size_t covered = 0; covered < least.size(); ++covered) {
    if (static_cast<std::uint64_t>(std::popcount(covered)) >= pairs.value_or(all)) {
      best = std::min(best, least[covered]);
    }
  }
  return best == no_cost ? std::nullopt : std::optional(best);
}

}  // namespace changeover::test
