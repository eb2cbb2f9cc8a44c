// When tiny jobs on two benches with scarce parts can be done at the earliest, by looking at
// everything that can happen.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover::test {

/// The least makespan, in whole units, of a job with whole costs on two benches that begin with
/// what they have at their start. A state is what each bench holds, what it still has to do, and
/// what has met. A bench that is free may begin with any set-up for which there are parts; when its
/// test ends it gives back any parts. Time passes to the next end of a test. For up to four parts.
inline std::uint64_t earliest_end(const Job& job, const std::vector<Bench>& benches) {
  using Mask = std::uint32_t;
  struct Side {
    Mask held = 0;
    std::uint64_t left = 0;  // of the test that runs; 0: it is free
    auto operator<=>(const Side&) const = default;
  };
  using State = std::tuple<Side, Side, Mask>;
  const std::size_t v = job.names.size();
  std::vector<std::pair<Element, Element>> pairs;
  job.needed.for_each(1000, [&](Element x, Element y) { pairs.emplace_back(x, y); });
  const auto mask_of = [](const Block& block) {
    Mask mask = 0;
    for (const Element x : block) {
      mask |= 1U << x;
    }
    return mask;
  };
  const auto covered = [&](Mask setup) {
    Mask mask = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Mask both = 1U << pairs[i].first | 1U << pairs[i].second;
      mask |= (setup & both) == both ? 1U << i : 0U;
    }
    return mask;
  };
  const auto allowed = [&](std::size_t b, Mask setup) {
    const Block mounted = benches[b].mounted.value_or(job.mounted);
    bool fits = setup != 0 &&
                static_cast<std::uint64_t>(std::popcount(setup)) <=
                    benches[b].at_once.value_or(job.at_once) &&
                (setup & mask_of(mounted)) == mask_of(mounted) &&
                (setup & mask_of(benches[b].without)) == 0;
    for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
      std::uint64_t there = 0;
      for (std::size_t x = 0; x < v; ++x) {
        there += (setup >> x & 1U) != 0 && job.slot_of[x] == s ? 1U : 0U;
      }
      fits = fits && job.slots[s].least <= there && there <= job.slots[s].most;
    }
    job.never.for_each(1000, [&](Element x, Element y) {
      fits = fits && ((setup >> x & 1U) == 0 || (setup >> y & 1U) == 0);
    });
    return fits;
  };
  const Mask all = static_cast<Mask>((std::uint64_t{1} << pairs.size()) - 1);
  std::map<State, std::uint64_t> best;
  using Entry = std::pair<std::uint64_t, State>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](std::uint64_t time, const State& state) {
    const auto found = best.find(state);
    if (found == best.end() || time < found->second) {
      best[state] = time;
      queue.emplace(time, state);
    }
  };
  const auto start = [&](std::size_t b) { return mask_of(benches[b].start.value_or(job.start)); };
  reach(0, {{start(0), 0}, {start(1), 0}, 0});
  while (!queue.empty()) {
    const auto [time, state] = queue.top();
    queue.pop();
    if (best[state] < time) {
      continue;
    }
    const std::array<Side, 2> sides{std::get<0>(state), std::get<1>(state)};
    const Mask met = std::get<2>(state);
    if (met == all && sides[0].left == 0 && sides[1].left == 0) {
      return time;
    }
    const auto with = [&](std::size_t b, Side side, Mask now) {
      std::array<Side, 2> changed = sides;
      changed[b] = side;
      return State{changed[0], changed[1], now};
    };
    for (std::size_t b = 0; b < 2; ++b) {
      if (sides[b].left > 0) {
        continue;
      }
      // Gives back a part.
      for (std::size_t x = 0; x < v; ++x) {
        if ((sides[b].held >> x & 1U) != 0) {
          reach(time, with(b, {sides[b].held & ~(1U << x), 0}, met));
        }
      }
      for (Mask setup = 1; setup < 1U << v; ++setup) {
        if (!allowed(b, setup)) {
          continue;
        }
        std::uint64_t cost = benches[b].test_cost.value_or(job.test_cost).millionths;
        bool there = true;
        for (std::size_t x = 0; x < v; ++x) {
          if ((setup & ~sides[b].held) >> x & 1U) {
            cost +=
                job.change_costs[x].millionths * benches[b].change_factor.millionths / 1'000'000;
            const bool other = (sides[1 - b].held >> x & 1U) != 0;
            there = there && (job.quantities.empty() || job.quantities[x] > (other ? 1U : 0U));
          }
        }
        if (there) {
          reach(time, with(b, {setup, cost / 1'000'000}, met | covered(setup)));
        }
      }
    }
    // Time passes.
    std::uint64_t step = 0;
    for (const Side& side : sides) {
      step = side.left > 0 && (step == 0 || side.left < step) ? side.left : step;
    }
    if (step > 0) {
      std::array<Side, 2> later = sides;
      for (Side& side : later) {
        side.left -= std::min(side.left, step);
      }
      reach(time + step, {later[0], later[1], met});
    }
  }
  return ~std::uint64_t{0};
}

}  // namespace changeover::test
