#include "changeover/plan/run_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/words.hpp"
#include "plan/sheet/replacement.hpp"

namespace changeover {
namespace {

// Plain on purpose: a table of pairs and set differences, nothing that a search would use.
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

// The missing needed triples, as a plain list of flags.
class TripleTable {
 public:
  TripleTable(const Job& job) : v_(job.triples.empty() ? 0 : job.names.size()) {
    needed_.assign(v_ * v_ * v_, false);
    for (const Triple& t : job.triples) {
      if (!needed_.at(place(t))) {
        needed_[place(t)] = true;
        ++size_;
      }
    }
  }

  [[nodiscard]] std::uint64_t size() const { return size_; }
  // Removes the triples of an increasing set-up that count, and returns those that were missing.
  template <typename Counts>
  std::vector<Triple> met(const Block& setup, Counts&& counts) {
    std::vector<Triple> found;
    for (std::size_t i = 0; size_ > 0 && i < setup.size(); ++i) {
      for (std::size_t j = i + 1; j < setup.size(); ++j) {
        for (std::size_t l = j + 1; l < setup.size(); ++l) {
          const Triple t{setup[i], setup[j], setup[l]};
          if (needed_[place(t)] && counts(t)) {
            needed_[place(t)] = false;
            --size_;
            found.push_back(t);
          }
        }
      }
    }
    return found;
  }

 private:
  [[nodiscard]] std::size_t place(const Triple& t) const { return (t[0] * v_ + t[1]) * v_ + t[2]; }

  std::size_t v_;
  std::vector<bool> needed_;
  std::uint64_t size_ = 0;
};

Block sorted(const Job& job, Block block) {
  for (const Element x : block) {
    if (x >= job.parts()) {
      throw BadInput(fmt::format("a set-up names part {} of {}; name parts that there are", x + 1,
                                 job.parts()));
    }
  }
  std::ranges::sort(block);
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
  TripleTable missing_triples(job);
  sheet.triples_needed = missing_triples.size();
  const bool weighs = !job.weights.empty();
  if (weighs) {
    job.needed.for_each(std::numeric_limits<std::uint64_t>::max(),
                        [&](Element x, Element y) { sheet.weight_needed += job.weights(x, y); });
  }
  Block before = sorted(job, job.start);
  bool was_hidden = false;
  for (const Block& given : setups) {
    RunStep step;
    step.setup = sorted(job, given);
    const auto where = [&] {
      return fmt::format("set-up {}", sheet.steps.size() + 1 + job.tests_done);
    };
    if (std::ranges::adjacent_find(step.setup) != step.setup.end()) {
      sheet.faults.push_back(where() + " names a part twice");
    }
    if (step.setup.size() > job.at_once) {
      sheet.faults.push_back(fmt::format("{} has {}, {} fit", where(),
                                         count_of(step.setup.size(), "part"), job.at_once));
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
        sheet.faults.push_back(fmt::format("{} has {} of slot {}, not {} to {}", where(),
                                           count_of(there, "part"), job.slots[s].name,
                                           job.slots[s].least, job.slots[s].most));
      }
    }
    if (job.model != nullptr) {
      if (const auto broken = broken_rule(*job.model, step.setup)) {
        sheet.faults.push_back(fmt::format("{} is no test of the model: {}", where(), *broken));
      }
    }
    // A value out of range hides what the others would show.
    const auto hides = [&](Element x) {
      return job.model != nullptr && x < job.model->values() && job.model->value(x).negative;
    };
    const bool any_hides = std::ranges::any_of(step.setup, hides);
    const std::size_t place = sheet.steps.size();
    if (place < job.first.size() && step.setup != sorted(job, job.first[place])) {
      sheet.faults.push_back(where() + " is not the one that must be run there");
    }
    step.take_out = without(before, step.setup);
    step.put_in = without(step.setup, before);
    // A pair that meets here first includes a part that was put in; but in the first set-up, and
    // after one that hid something, any pair may be new.
    const bool look_at_all = sheet.steps.empty() || was_hidden;
    was_hidden = any_hides;
    for (const Element x : look_at_all ? step.setup : step.put_in) {
      for (const Element y : step.setup) {
        const bool seen_from_y =
            y >= x && (look_at_all || std::ranges::binary_search(step.put_in, y));
        if (seen_from_y) {
          continue;
        }
        const std::pair<Element, Element> pair = std::minmax({x, y});
        if (never.contains(x, y)) {
          const std::string& why = job.why_never(x, y);
          sheet.faults.push_back(fmt::format("{} holds {} and {}, which must never meet{}", where(),
                                             job.names[pair.first], job.names[pair.second],
                                             why.empty() ? "" : " (" + why + ")"));
        }
        if (missing.contains(x, y) && (!any_hides || hides(x) || hides(y))) {
          missing.erase(x, y);
          step.new_pairs.push_back(pair);
          sheet.weight_tested += weighs ? job.weights(x, y) : Amount{};
        }
      }
    }
    std::ranges::sort(step.new_pairs);
    step.weight_so_far = sheet.weight_tested;
    step.new_triples = missing_triples.met(step.setup, [&](const Triple& t) {
      return !any_hides || hides(t[0]) || hides(t[1]) || hides(t[2]);
    });
    before = step.setup;
    Amount changes;
    if (job.replaces()) {
      Replacement replacement = cheapest_replacement(job, step.take_out, step.put_in);
      changes = replacement.cost;
      step.replaced = std::move(replacement.pairs);
    } else {
      for (const Element x : step.put_in) {
        changes += job.change_costs[x];
      }
    }
    sheet.change_cost += changes;
    step.cost = job.test_cost + changes;
    sheet.changes += step.put_in.size();
    sheet.cost += step.cost;
    step.cost_so_far = sheet.cost;
    sheet.steps.push_back(std::move(step));
  }
  if (setups.size() < job.first.size()) {
    sheet.faults.push_back("some of the set-ups that must come first are not there");
  }
  sheet.pairs_tested = sheet.pairs_needed - missing.size();
  sheet.triples_tested = sheet.triples_needed - missing_triples.size();
  return sheet;
}

}  // namespace changeover
