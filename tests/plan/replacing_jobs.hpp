// Jobs whose change costs depend on what is replaced, and their cheapest plans by looking at all
// lists.
#pragma once

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/setups/setup_list.hpp"
#include "run/random.hpp"

namespace changeover::test {

/// The job with costs of replacement drawn at random, some of them nothing.
inline Job replacing(Job job, std::uint64_t seed) {
  Random random(seed, 4711);
  const std::size_t v = job.names.size();
  job.replace_costs.assign(v * v, Amount{});
  for (Amount& cost : job.replace_costs) {
    cost = Amount{random.below(9) * 500'000ULL};
  }
  return job;
}

/// What the changes of a step cost in one slot, in millionths: all ways to put the parts into the
/// places.
inline std::uint64_t cost_of_changes(const Job& job, unsigned from, unsigned to,
                                     std::uint32_t slot) {
  std::vector<Element> out;
  std::vector<Element> in;
  for (Element x = 0; x < job.parts(); ++x) {
    if (!job.slots.empty() && job.slot_of[x] != slot) {
      continue;
    }
    if ((from >> x & 1U) != 0 && (to >> x & 1U) == 0) {
      out.push_back(x);
    }
    if ((from >> x & 1U) == 0 && (to >> x & 1U) != 0) {
      in.push_back(x);
    }
  }
  std::vector<std::size_t> place(std::max(out.size(), in.size()));
  std::iota(place.begin(), place.end(), std::size_t{0});
  std::optional<std::uint64_t> least;
  do {
    std::uint64_t cost = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
      cost += place[i] < out.size()
                  ? job.replace_costs[out[place[i]] * job.names.size() + in[i]].millionths
                  : job.change_costs[in[i]].millionths;
    }
    least = std::min(least.value_or(cost), cost);
  } while (std::next_permutation(place.begin(), place.end()));
  return *least;
}

inline std::uint64_t cost_of_changes(const Job& job, unsigned from, unsigned to) {
  std::uint64_t cost = job.slots.empty() ? 0 : cost_of_changes(job, from, to, no_slot);
  for (std::uint32_t slot = 0; slot < std::max<std::size_t>(1, job.slots.size()); ++slot) {
    cost += cost_of_changes(job, from, to, slot);
  }
  return cost;
}

/// The least cost of a list for the job, in millionths: the shortest way, from nothing done, among
/// what is covered and the last set-up, steps that cover nothing new included. For jobs of up to
/// five parts.
inline std::uint64_t least_cost_of_replacing(const Job& job) {
  std::vector<unsigned> needed;
  job.needed.for_each(1000, [&](Element x, Element y) { needed.push_back(1U << x | 1U << y); });
  struct SetUp {
    unsigned parts = 0;
    std::size_t pairs = 0;
  };
  std::vector<SetUp> setups;
  for (unsigned parts = 1; parts < 1U << job.parts(); ++parts) {
    Block block;
    for (Element x = 0; x < job.parts(); ++x) {
      if ((parts >> x & 1U) != 0) {
        block.push_back(x);
      }
    }
    SetUp setup{parts, 0};
    for (std::size_t i = 0; i < needed.size(); ++i) {
      setup.pairs |= (parts & needed[i]) == needed[i] ? std::size_t{1} << i : 0;
    }
    if (!setup_defect(job, block)) {
      setups.push_back(setup);
    }
  }
  unsigned start = 0;
  for (const Element x : job.start) {
    start |= 1U << x;
  }
  const std::size_t n = setups.size();
  std::vector<std::vector<std::uint64_t>> step(n + 1, std::vector<std::uint64_t>(n));
  for (std::size_t a = 0; a <= n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      step[a][b] = job.test_cost.millionths +
                   cost_of_changes(job, a == n ? start : setups[a].parts, setups[b].parts);
    }
  }
  const std::size_t all = (std::size_t{1} << needed.size()) - 1;
  using State = std::tuple<std::uint64_t, std::size_t, std::size_t>;  // cost, covered, last
  std::priority_queue<State, std::vector<State>, std::greater<>> queue;
  std::vector<std::vector<bool>> done(all + 1, std::vector<bool>(n + 1, false));
  queue.emplace(0, 0, n);
  while (!queue.empty()) {
    const auto [cost, covered, last] = queue.top();
    queue.pop();
    if (done[covered][last]) {
      continue;
    }
    done[covered][last] = true;
    if (covered == all) {
      return cost;
    }
    for (std::size_t next = 0; next < n; ++next) {
      if (!done[covered | setups[next].pairs][next]) {
        queue.emplace(cost + step[last][next], covered | setups[next].pairs, next);
      }
    }
  }
  return ~std::uint64_t{0};
}

}  // namespace changeover::test
