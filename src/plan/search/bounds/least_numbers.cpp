#include "plan/search/bounds/least_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {

std::vector<Element> all_meeting(const Job& job, const JobNumbers& n) {
  if (n.pairs == choose_two(n.parts.size())) {
    return n.parts;
  }
  std::vector<Element> by_degree = n.parts;
  std::stable_sort(by_degree.begin(), by_degree.end(),
                   [&](Element x, Element y) { return n.inner[x] > n.inner[y]; });
  std::vector<Element> together;
  for (const Element x : by_degree) {
    if (std::all_of(together.begin(), together.end(),
                    [&](Element y) { return job.needed.contains(x, y); })) {
      together.push_back(x);
    }
  }
  return together;
}

StaysCost least_by_stays(const Job& job, const JobNumbers& n) {
  std::vector<Amount> prices;
  std::uint64_t at_start = 0;  // more than K if parts that will stay mounted are not there yet
  for (const Element x : all_meeting(job, n)) {
    prices.push_back(job.change_costs[x]);
    at_start += n.at_start[x] ? 1U : 0U;
  }
  StaysCost least = stays_cost(std::move(prices), std::max(n.room, at_start));
  for (const Element x : n.parts) {
    if (!n.at_start[x]) {
      ++least.extra;
      least.cost += job.change_costs[x];
    }
  }
  return least;
}

LeastNumber least_tests(const Job& job, const JobNumbers& n) {
  const bool slots = !job.slots.empty();
  std::vector<std::uint64_t> inner_of_slot(slots ? job.names.size() * n.most.size() : 0, 0);
  if (slots) {
    std::vector<bool> mounted(job.names.size());
    for (const Element m : job.mounted) {
      mounted[m] = true;
    }
    job.needed.for_each(all_of_them, [&](Element x, Element y) {
      if (!mounted[x] && !mounted[y]) {
        ++inner_of_slot[x * n.most.size() + n.slot_of[y]];
        ++inner_of_slot[y * n.most.size() + n.slot_of[x]];
      }
    });
  }
  LeastNumber tests{1, "there is something to test"};
  std::uint64_t occurrences = 0;
  std::vector<std::uint64_t> by_slot(n.most.size(), 0);
  for (const Element x : n.parts) {
    std::uint64_t times = n.inner[x] == 0 ? 1 : ceil_div(n.inner[x], n.room - 1);
    if (slots) {
      for (std::size_t s = 0; s < n.most.size(); ++s) {
        const std::uint64_t places = n.most[s] - (n.slot_of[x] == s ? 1 : 0);
        const std::uint64_t partners = inner_of_slot[x * n.most.size() + s];
        times = partners == 0 ? times : std::max(times, ceil_div(partners, places));
      }
      by_slot[n.slot_of[x]] += times;
    }
    occurrences += times;
  }
  for (std::size_t s = 0; s < by_slot.size(); ++s) {
    if (by_slot[s] > 0) {
      tests.at_least(
          ceil_div(by_slot[s], n.most[s]),
          fmt::format("the parts {} are in at least {} in all, {} in each",
                      s < job.slots.size() ? "of slot " + job.slots[s].name : "of no slot",
                      count_of(by_slot[s], "set-up"), n.most[s]));
    }
  }
  if (n.room > 0) {
    tests.at_least(ceil_div(occurrences, n.room),
                   fmt::format("the parts are in at least {} in all, {} in each",
                               count_of(occurrences, "set-up"), n.room));
  }
  return tests;
}

LeastNumber least_introductions(const JobNumbers& n, std::uint64_t once, std::uint64_t by_stays) {
  LeastNumber least{0, "none is needed"};
  least.at_least(once, "each part once");
  const std::uint64_t v = n.parts.size();
  const std::uint64_t start =
      sum_of(n.parts, [&](const Element x) { return n.at_start[x] ? 1U : 0U; });
  if (n.pairs == choose_two(v) && n.room >= 2 && v > n.room && start <= n.room) {
    const Parameters p{.v = v, .k = n.room, .change = 1, .kind = Kind::linear};
    try {
      const std::uint64_t b = lower_bound(p).blocks;
      const std::uint64_t needed = n.room - 1 + b;
      least.at_least(needed - std::min(needed, start),
                     fmt::format("one change at a time takes {} blocks: {}", b, name(p, false)));
    } catch (const Stopped&) {  // What follows holds all the same.
    }
  }
  least.at_least(by_stays, "at most K parts come once, and on: docs/theorems.md, Theorem 5");
  return least;
}

}  // namespace changeover
