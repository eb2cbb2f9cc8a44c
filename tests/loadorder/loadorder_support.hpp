// The definition of a load order in plain code: sets, and nothing of the library's checks.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover::test {

struct Simulation {
  std::uint64_t items = 0;
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;
  std::set<Element> memory;
  std::set<std::pair<Element, Element>> met;
  std::string fault;

  [[nodiscard]] std::uint64_t missing() const { return items * (items - 1) / 2 - met.size(); }

  void take(const Step& step, std::uint64_t room) {
    ++steps;
    if (step.number != steps) {
      fault = fmt::format("step {} is numbered {}", steps, step.number);
    }
    for (const Element x : step.evict) {
      if (memory.erase(x) != 1) {
        fault = fmt::format("step {} evicts {}", steps, x);
      }
    }
    for (const Element x : step.load) {
      if (x >= items || !memory.insert(x).second) {
        fault = fmt::format("step {} loads {}", steps, x);
      }
      ++loads;
    }
    if (memory.size() > room) {
      fault = fmt::format("step {} has {} items in memory", steps, memory.size());
    }
    for (const Element x : step.load) {
      for (const Element y : memory) {
        if (x != y) {
          met.emplace(std::min(x, y), std::max(x, y));
        }
      }
    }
  }
};

inline std::vector<Step> all_steps(StepSource& source) {
  std::vector<Step> steps;
  for (Step step; source.next(step);) {
    steps.push_back(step);
  }
  return steps;
}

/// With the work that the rules ask for.
inline std::vector<Step> work_of(std::unique_ptr<StepSource> loads, const ScheduleRules& rules) {
  StepWork work(std::move(loads), rules);
  return all_steps(work);
}

inline ScheduleVerdict verdict_of(const std::vector<Step>& steps, const ScheduleRules& rules,
                                  const CheckOptions& options = {}) {
  ScheduleCheck check(rules, options);
  for (const Step& step : steps) {
    check.read(step);
  }
  return check.finish();
}

/// Reads anything with next(Step&) to its end.
template <typename Steps>
Simulation simulate(Steps& steps, std::uint64_t items, std::uint64_t room) {
  Simulation simulation;
  simulation.items = items;
  Step step;
  while (steps.next(step)) {
    simulation.take(step, room);
  }
  return simulation;
}

}  // namespace changeover::test
