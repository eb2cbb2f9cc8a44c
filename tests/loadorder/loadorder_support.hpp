// The definition of a load order in plain code: sets, and nothing of the library's checks.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

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

  void take(const LoadStep& step, std::uint64_t room) {
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

/// Reads anything with next(LoadStep&) to its end.
template <typename Steps>
Simulation simulate(Steps& steps, std::uint64_t items, std::uint64_t room) {
  Simulation simulation;
  simulation.items = items;
  LoadStep step;
  while (steps.next(step)) {
    simulation.take(step, room);
  }
  return simulation;
}

}  // namespace changeover::test
