#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/least_number.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/stays_cost.hpp"
#include "plan/search/triple_plan.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

// The numbers of the proof in the header.
struct TripleNumbers {
  std::uint64_t room = 0;
  std::uint64_t triples = 0;  // within F
  bool all_inner = true;      // no needed triple has a mounted part
  std::vector<Element> parts;
  std::vector<bool> inner;        // by three parts, in any order
  std::vector<std::uint64_t> of;  // by two parts: number of triples within F
  std::vector<bool> at_start;
  std::uint64_t start = 0;
  Amount mounting;
  std::uint64_t mounted_introductions = 0;

  explicit TripleNumbers(const Job& job)
      : room(job.room() - job.mounted.size()), at_start(job.names.size(), false) {
    const std::size_t v = job.names.size();
    std::vector<bool> mounted(v, false);
    for (const Element m : job.mounted) {
      mounted[m] = true;
    }
    for (const Element x : job.start) {
      at_start[x] = true;
      start += mounted[x] ? 0U : 1U;
    }
    for (const Element m : job.mounted) {
      mounting += at_start[m] ? Amount{} : job.change_costs[m];
      mounted_introductions += at_start[m] ? 0U : 1U;
    }
    inner.assign(v * v * v, false);
    of.assign(v * v, 0);
    std::vector<bool> used(v, false);
    for (Triple t : job.triples) {
      for (const Element x : t) {
        used[x] = true;
      }
      if (mounted[t[0]] || mounted[t[1]] || mounted[t[2]]) {
        all_inner = false;
        continue;
      }
      ++triples;
      do {
        inner[(t[0] * v + t[1]) * v + t[2]] = true;
        ++of[t[0] * v + t[1]];  // counts each ordered pair once
      } while (std::next_permutation(t.begin(), t.end()));
    }
    for (Element x = 0; x < v; ++x) {
      if (used[x] && !mounted[x]) {
        parts.push_back(x);
      }
    }
  }
};

std::uint64_t most_triples(const TripleNumbers& n, std::uint64_t tests,
                           std::uint64_t introductions) {
  return most_by_steps(
      n.room, tests, introductions,
      [&](std::uint64_t j) { return choose_three(j + std::min(n.start, n.room - j)); },
      [&](std::uint64_t j) { return choose_three(n.room) - choose_three(n.room - j); });
}

// (2)
std::uint64_t least_tests_of_triples(const Job& job, const TripleNumbers& n) {
  const std::size_t v = job.names.size();
  std::uint64_t places = 0;
  for (const Element x : n.parts) {
    const std::uint64_t met = sum_of(n.parts, [&](const Element y) {
      return x == y ? 0 : ceil_div(n.of[x * v + y], n.room - 2);
    });
    places += ceil_div(met, n.room - 1);
  }
  return ceil_div(places, n.room);
}

// (3): for all introductions of parts of F.
StaysCost triples_by_stays(const Job& job, const TripleNumbers& n) {
  const std::size_t v = job.names.size();
  std::vector<Element> together;
  const bool all = n.triples == choose_three(n.parts.size());
  for (const Element x : n.parts) {
    bool meets_all = true;
    for (std::size_t i = 0; !all && i < together.size() && meets_all; ++i) {
      for (std::size_t j = 0; j < i && meets_all; ++j) {
        meets_all = n.inner[(x * v + together[i]) * v + together[j]];
      }
    }
    if (meets_all) {
      together.push_back(x);
    }
  }
  StaysCost least;
  constexpr std::size_t few = 3;
  if (together.size() >= few) {
    std::vector<Amount> prices;
    std::uint64_t at_start = 0;
    for (const Element x : together) {
      prices.push_back(job.change_costs[x]);
      at_start += n.at_start[x] ? 1U : 0U;
    }
    least = stays_cost_of_triples(std::move(prices), std::max(n.room, at_start));
  }
  for (const Element x : n.parts) {
    if (!n.at_start[x]) {
      ++least.extra;
      least.cost += job.change_costs[x];
    }
  }
  return least;
}

// (4)
std::uint64_t by_refining(const TripleNumbers& n) {
  if (n.triples != choose_three(n.parts.size()) || n.parts.size() <= n.room || n.start > n.room) {
    return 0;
  }
  const std::uint64_t start =
      sum_of(n.parts, [&](const Element x) { return n.at_start[x] ? 1U : 0U; });
  try {
    const std::uint64_t b =
        lower_bound(
            {.v = n.parts.size(), .k = n.room, .change = 1, .kind = Kind::linear, .strength = 3})
            .blocks;
    const std::uint64_t needed = n.room - 1 + b;
    return needed - std::min(needed, start);
  } catch (const Stopped&) {
    return 0;
  }
}

}  // namespace

CostBound bound_for_triples(const Job& job) {
  Job pairs = job;
  pairs.triples.clear();
  CostBound bound = bound_of_valid_job(pairs);
  const TripleNumbers n(job);
  if (n.triples == 0) {
    return bound;
  }
  std::uint64_t once = 0;
  Amount base;
  Amount cheapest{std::numeric_limits<std::uint64_t>::max()};
  for (const Element x : n.parts) {
    cheapest = std::min(cheapest, job.change_costs[x]);
    if (!n.at_start[x]) {
      ++once;
      base += job.change_costs[x];
    }
  }
  const StaysCost stays = triples_by_stays(job, n);
  const std::uint64_t refined = by_refining(n);
  const std::uint64_t fewest_tests = std::max(least_tests_of_triples(job, n), bound.tests);
  const std::uint64_t of_pairs =
      bound.introductions - std::min(bound.introductions, n.mounted_introductions);
  const std::uint64_t fewest = std::max({once, stays.extra, refined, of_pairs});
  const std::uint64_t first = !job.start.empty() ? 0 : n.all_inner ? 3 : 1;
  const auto price = [&](std::uint64_t introductions) {
    return std::max(base + cheapest * (introductions - once), stays.cost) + n.mounting;
  };
  struct Least {
    Amount cost;
    std::uint64_t tests = 0;
    std::uint64_t introductions = 0;
  };
  std::optional<Least> best;
  for (std::uint64_t t = fewest_tests;; ++t) {
    if (best && job.test_cost * t + price(fewest) >= best->cost) {
      break;
    }
    const std::uint64_t most = n.room * t;
    if (most_triples(n, t, most) < n.triples) {
      continue;
    }
    const std::uint64_t low = least_number(
        0, most, [&](std::uint64_t changes) { return most_triples(n, t, changes) >= n.triples; });
    const std::uint64_t steps = t - 1 + first;
    const std::uint64_t introductions = std::max({low, fewest, steps});
    const Amount cost = job.test_cost * t + price(introductions);
    if (!best || cost < best->cost) {
      best = Least{cost, t, introductions};
    }
    if (steps >= std::max(low, fewest)) {
      break;  // more tests only cost more
    }
  }
  const Amount cost = rounded_up(job, best->cost);
  bound.tests = fewest_tests;
  bound.introductions = fewest + n.mounted_introductions;
  if (cost <= bound.cost) {
    bound.reason = "of the pairs alone: " + bound.reason;
    return bound;
  }
  bound.cost = cost;
  bound.reason = fmt::format(
      "every three meet: at least {} and {} (docs/theorems.md, Theorems 5 and 7), and j "
      "changes of {} bring at most C({},3) - C({}-j,3) new triples: {} with {} {} least",
      count_of(fewest_tests, "test"), count_of(bound.introductions, "change"), n.room, n.room,
      n.room, count_of(best->tests, "test"),
      count_of(best->introductions + n.mounted_introductions, "change"),
      best->tests == 1 ? "costs" : "cost");
  return bound;
}

}  // namespace changeover
