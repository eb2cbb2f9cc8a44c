#include "changeover/plan/run_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// Deliberately plain: a table of pairs and set differences, nothing that a search would use.
class PairTable {
 public:
  explicit PairTable(const PairSet& pairs) {
    for (std::uint64_t i = 0; i < pairs.v(); ++i) {
      rows_.emplace_back(static_cast<std::size_t>(pairs.v()), false);
    }
    pairs.for_each(std::numeric_limits<std::uint64_t>::max(), [&](Element x, Element y) {
      rows_[x][y] = rows_[y][x] = true;
      ++size_;
    });
  }

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] bool contains(Element x, Element y) const { return rows_[x][y]; }
  void erase(Element x, Element y) {
    rows_[x][y] = rows_[y][x] = false;
    --size_;
  }

 private:
  std::vector<std::vector<bool>> rows_;
  std::uint64_t size_ = 0;
};

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
  const PairTable never(job.never);
  PairTable missing(job.needed);
  const Block mounted = sorted(job, job.mounted);
  RunSheet sheet;
  sheet.pairs_needed = missing.size();
  Block before = sorted(job, job.start);
  for (const Block& given : setups) {
    RunStep step;
    step.setup = sorted(job, given);
    const auto where = [&] {
      return fmt::format("set-up {}", sheet.steps.size() + 1 + job.tests_done);
    };
    if (std::adjacent_find(step.setup.begin(), step.setup.end()) != step.setup.end()) {
      sheet.faults.push_back(where() + " names a part twice");
    }
    if (step.setup.size() > job.at_once) {
      sheet.faults.push_back(
          fmt::format("{} has {} parts, {} fit", where(), step.setup.size(), job.at_once));
    }
    if (!without(mounted, step.setup).empty()) {
      sheet.faults.push_back(where() + " lacks a part that stays mounted");
    }
    for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
      std::uint64_t there = 0;
      for (const Element x : step.setup) {
        there += job.slot_of.at(x) == s ? 1U : 0U;
      }
      if (there < job.slots[s].least || there > job.slots[s].most) {
        sheet.faults.push_back(fmt::format("{} has {} parts of slot {}, not {} to {}", where(),
                                           there, job.slots[s].name, job.slots[s].least,
                                           job.slots[s].most));
      }
    }
    const std::size_t place = sheet.steps.size();
    if (place < job.first.size() && step.setup != sorted(job, job.first[place])) {
      sheet.faults.push_back(where() + " is not the one that must be run there");
    }
    step.take_out = without(before, step.setup);
    step.put_in = without(step.setup, before);
    // A pair that meets here first has a part that was put in; in the first set-up, any pair may be it.
    const bool is_first = sheet.steps.empty();
    for (const Element x : is_first ? step.setup : step.put_in) {
      for (const Element y : step.setup) {
        const bool seen_from_y =
            y >= x && (is_first || std::binary_search(step.put_in.begin(), step.put_in.end(), y));
        if (seen_from_y) {
          continue;
        }
        const std::pair<Element, Element> pair = std::minmax({x, y});
        if (never.contains(x, y)) {
          sheet.faults.push_back(fmt::format("{} holds {} and {}, which must never meet", where(),
                                             job.names[pair.first], job.names[pair.second]));
        }
        if (missing.contains(x, y)) {
          missing.erase(x, y);
          step.new_pairs.push_back(pair);
        }
      }
    }
    std::sort(step.new_pairs.begin(), step.new_pairs.end());
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
  if (setups.size() < job.first.size()) {
    sheet.faults.push_back("some of the set-ups that must come first are not there");
  }
  sheet.pairs_tested = sheet.pairs_needed - missing.size();
  return sheet;
}

}  // namespace changeover
