#include "changeover/plan/run_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// Deliberately plain: sets of pairs and set differences, nothing that a search would use.
using Pair = std::pair<Element, Element>;

std::set<Pair> pairs_of(const PairSet& pairs) {
  std::set<Pair> result;
  pairs.for_each(std::numeric_limits<std::uint64_t>::max(),
                 [&](Element x, Element y) { result.emplace(x, y); });
  return result;
}

Block sorted(const Job& job, Block block) {
  for (const Element x : block) {
    if (x >= job.parts()) {
      throw BadInput(fmt::format("a set-up names part {} of {}", x + 1, job.parts()));
    }
  }
  std::sort(block.begin(), block.end());
  return block;
}

Block without(const Block& from, const Block& what) {
  Block rest;
  std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

std::optional<std::uint64_t> RunSheet::constant_change() const {
  if (steps.size() < 2) {
    return std::nullopt;
  }
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (steps[i].setup.size() != steps.front().setup.size() ||
        steps[i].put_in.size() != steps[1].put_in.size()) {
      return std::nullopt;
    }
  }
  return steps[1].put_in.size();
}

RunSheet run_sheet(const Job& job, const std::vector<Block>& setups) {
  const std::set<Pair> never = pairs_of(job.never);
  std::set<Pair> missing = pairs_of(job.needed);
  const Block mounted = sorted(job, job.mounted);
  RunSheet sheet;
  sheet.pairs_needed = missing.size();
  Block before = sorted(job, job.start);
  for (const Block& given : setups) {
    RunStep step;
    step.setup = sorted(job, given);
    const std::string where = fmt::format("set-up {}", sheet.steps.size() + 1 + job.tests_done);
    if (std::adjacent_find(step.setup.begin(), step.setup.end()) != step.setup.end()) {
      sheet.faults.push_back(where + " names a part twice");
    }
    if (step.setup.size() > job.at_once) {
      sheet.faults.push_back(
          fmt::format("{} has {} parts, {} fit", where, step.setup.size(), job.at_once));
    }
    if (!without(mounted, step.setup).empty()) {
      sheet.faults.push_back(where + " lacks a part that stays mounted");
    }
    for (std::size_t i = 0; i < step.setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Pair pair{step.setup[j], step.setup[i]};
        if (never.count(pair) != 0) {
          sheet.faults.push_back(fmt::format("{} holds {} and {}, which must never meet", where,
                                             job.names[pair.first], job.names[pair.second]));
        }
        if (missing.erase(pair) != 0) {
          step.new_pairs.push_back(pair);
        }
      }
    }
    std::sort(step.new_pairs.begin(), step.new_pairs.end());
    step.take_out = without(before, step.setup);
    step.put_in = without(step.setup, before);
    before = step.setup;
    step.cost = job.test_cost;
    for (const Element x : step.put_in) {
      step.cost += job.change_costs[x];
      sheet.change_cost += job.change_costs[x];
    }
    sheet.changes += step.put_in.size();
    sheet.cost += step.cost;
    step.cost_so_far = sheet.cost;
    sheet.steps.push_back(std::move(step));
  }
  sheet.pairs_tested = sheet.pairs_needed - missing.size();
  return sheet;
}

}  // namespace changeover
