// Holds schedules of benches against their definition (plan/benches.hpp), at every moment between
// two events, with code that shares nothing with the library.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover::test {

/// A line for each way in which a schedule is not one; `makespan` is when it ends, `cost` what it
/// costs.
struct CheckedSchedule {
  std::vector<std::string> faults;
  std::uint64_t makespan = 0;
  std::uint64_t cost = 0;
  std::set<std::pair<Element, Element>> met;
};

inline CheckedSchedule check_schedule(const Job& job, const std::vector<Bench>& benches,
                                      const BenchSchedule& schedule) {
  CheckedSchedule checked;
  const auto fault = [&](std::size_t bench, std::size_t step, const std::string& what) {
    checked.faults.push_back("bench " + std::to_string(bench) + ", step " + std::to_string(step) +
                             ": " + what);
  };
  struct Step {
    std::set<Element> setup;
    std::set<Element> put_in;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
  };
  std::uint64_t day = 0;
  for (const Bench& bench : benches) {
    if (!bench.down) {
      day = std::max(day, bench.hours ? bench.hours->millionths : 24'000'000);
    }
  }
  std::vector<std::vector<Step>> all(benches.size());
  std::set<std::uint64_t> events{0};
  if (schedule.size() != benches.size()) {
    checked.faults.emplace_back("another number of benches");
    return checked;
  }
  for (std::size_t b = 0; b < benches.size(); ++b) {
    const Bench& bench = benches[b];
    const std::uint64_t room = bench.at_once.value_or(job.at_once);
    const Block start = bench.start.value_or(job.start);
    const Block mounted = bench.mounted.value_or(job.mounted);
    const std::vector<Block> first = bench.first.value_or(job.first);
    std::set<Element> before(start.begin(), start.end());
    std::uint64_t free = 0;
    if (bench.down && !schedule[b].empty()) {
      fault(b, 0, "down");
    }
    if (!bench.down && schedule[b].size() < first.size()) {
      fault(b, 0, "first set-ups missing");
    }
    for (std::size_t i = 0; i < schedule[b].size(); ++i) {
      const BenchStep& given = schedule[b][i];
      Step step{{given.setup.begin(), given.setup.end()}, {}, given.begin.millionths, 0};
      if (step.setup.size() != given.setup.size() || step.setup.size() > room) {
        fault(b, i, "too many parts");
      }
      if (i < first.size() && step.setup != std::set<Element>(first[i].begin(), first[i].end())) {
        fault(b, i, "not the first");
      }
      for (const Element m : mounted) {
        if (step.setup.count(m) == 0) {
          fault(b, i, "lacks what stays mounted");
        }
      }
      for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
        Slot slot = job.slots[s];
        for (const Slot& limit : bench.slots) {
          slot = limit.name == slot.name ? limit : slot;
        }
        std::uint64_t there = 0;
        for (const Element x : step.setup) {
          there += job.slot_of[x] == s ? 1U : 0U;
        }
        if (there < slot.least || there > slot.most) {
          fault(b, i, "slot " + slot.name);
        }
      }
      std::uint64_t cost = bench.test_cost.value_or(job.test_cost).millionths;
      for (const Element x : step.setup) {
        const bool own = std::count(bench.own.begin(), bench.own.end(), x) > 0;
        const bool without = std::count(bench.without.begin(), bench.without.end(), x) > 0;
        if (without || (!job.quantities.empty() && job.quantities[x] == 0 && !own)) {
          fault(b, i, "a part that the bench cannot have");
        }
        const bool again = std::count(given.again.begin(), given.again.end(), x) > 0;
        if (before.count(x) == 0 || again) {
          step.put_in.insert(x);
          cost += job.change_costs[x].millionths * bench.change_factor.millionths / 1'000'000;
        }
        for (const Element y : step.setup) {
          if (x < y && job.never.contains(x, y)) {
            fault(b, i, "parts that must never meet");
          }
          if (x < y) {
            checked.met.insert({x, y});
          }
        }
      }
      if (std::set<Element>(given.again.begin(), given.again.end()).size() != given.again.size()) {
        fault(b, i, "put in again twice");
      }
      for (const Element x : given.again) {
        if (before.count(x) == 0 || step.setup.count(x) == 0) {
          fault(b, i, "put in again what did not stay");
        }
      }
      if (step.begin < free) {
        fault(b, i, "two steps at a time");
      }
      // Hour by hour: as long as there is work left, it is done within the hours of a day.
      const std::uint64_t hours = bench.hours ? bench.hours->millionths : 24'000'000;
      if (hours == 24'000'000) {
        step.end = step.begin + cost;
      } else {
        std::uint64_t left = cost;
        std::uint64_t now = step.begin;
        if (left <= hours ? now % day + left > hours : now % day != 0) {
          fault(b, i, "over night");
        }
        while (left > 0) {
          const std::uint64_t can = std::min(left, hours - std::min(hours, now % day));
          now += can;
          left -= can;
          if (left > 0 && now % day != 0) {
            now = (now / day + 1) * day;
          }
        }
        step.end = now;
      }
      free = step.end;
      checked.cost += cost;
      checked.makespan = std::max(checked.makespan, step.end);
      events.insert(step.begin);
      events.insert(step.end);
      before = step.setup;
      all[b].push_back(step);
    }
  }
  // What each bench holds from one event to the next.
  for (auto event = events.begin(); std::next(event) != events.end(); ++event) {
    std::map<Element, std::uint64_t> there;
    for (std::size_t b = 0; b < benches.size(); ++b) {
      const Block start = benches[b].start.value_or(job.start);
      std::set<Element> held;
      for (std::size_t i = 0; i < all[b].size(); ++i) {
        const Step& step = all[b][i];
        if (step.begin <= *event && *event < step.end) {
          held.insert(step.setup.begin(), step.setup.end());
        }
        // It waits: what was there, and stays without being put in again.
        const std::uint64_t since = i == 0 ? 0 : all[b][i - 1].end;
        if (since <= *event && *event < step.begin) {
          for (const Element x : step.setup) {
            const bool was_there = i == 0 ? std::count(start.begin(), start.end(), x) > 0
                                          : all[b][i - 1].setup.count(x) > 0;
            if (was_there && step.put_in.count(x) == 0) {
              held.insert(x);
            }
          }
        }
      }
      for (const Element x : held) {
        there[x] += std::count(benches[b].own.begin(), benches[b].own.end(), x) == 0 ? 1U : 0U;
      }
    }
    for (const auto& [x, number] : there) {
      if (!job.quantities.empty() && number > job.quantities[x]) {
        checked.faults.push_back("at " + std::to_string(*event) + " part " + std::to_string(x) +
                                 " is on " + std::to_string(number) + " benches");
      }
    }
  }
  return checked;
}

}  // namespace changeover::test
