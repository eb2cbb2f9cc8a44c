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

// Counts a list, set-up by set-up.
class SheetCounter {
 public:
  explicit SheetCounter(const Job& job)
      : job_(&job),
        never_(job.never),
        missing_(job.needed),
        missing_triples_(job),
        mounted_(sorted(job, job.mounted)),
        before_(sorted(job, job.start)) {
    sheet_.pairs_needed = missing_.size();
    sheet_.triples_needed = missing_triples_.size();
    if (weighs()) {
      job.needed.for_each(std::numeric_limits<std::uint64_t>::max(),
                          [&](Element x, Element y) { sheet_.weight_needed += job.weights(x, y); });
    }
  }

  void add(const Block& given) {
    RunStep step;
    step.setup = sorted(*job_, given);
    check_parts(step.setup);
    check_slots(step.setup);
    check_place(step.setup);
    step.take_out = without(before_, step.setup);
    step.put_in = without(step.setup, before_);
    test_pairs(step);
    count_cost(step);
    before_ = step.setup;
    sheet_.steps.push_back(std::move(step));
  }

  RunSheet end() {
    if (sheet_.steps.size() < job_->first.size()) {
      fault("some of the set-ups that must come first are not there");
    }
    sheet_.pairs_tested = sheet_.pairs_needed - missing_.size();
    sheet_.triples_tested = sheet_.triples_needed - missing_triples_.size();
    return std::move(sheet_);
  }

 private:
  [[nodiscard]] bool weighs() const { return !job_->weights.empty(); }

  void fault(std::string what) { sheet_.faults.push_back(std::move(what)); }

  // The set-up that is being added, in messages.
  [[nodiscard]] std::string where() const {
    return fmt::format("set-up {}", sheet_.steps.size() + 1 + job_->steps_before());
  }

  void check_parts(const Block& setup) {
    if (std::ranges::adjacent_find(setup) != setup.end()) {
      fault(where() + " names a part twice");
    }
    if (setup.size() > job_->at_once) {
      fault(
          fmt::format("{} has {}, {} fit", where(), count_of(setup.size(), "part"), job_->at_once));
    }
    if (!without(mounted_, setup).empty()) {
      fault(where() + " lacks a part that stays mounted");
    }
  }

  void check_slots(const Block& setup) {
    for (std::uint32_t s = 0; s < job_->slots.size(); ++s) {
      const Slot& slot = job_->slots[s];
      const auto there = static_cast<std::uint64_t>(
          std::ranges::count_if(setup, [&](Element x) { return job_->slot_of.at(x) == s; }));
      if (there < slot.least || there > slot.most) {
        fault(fmt::format("{} has {} of slot {}, not {} to {}", where(), count_of(there, "part"),
                          slot.name, slot.least, slot.most));
      }
    }
  }

  // What the model and the set-ups that come first ask of it.
  void check_place(const Block& setup) {
    if (job_->model != nullptr) {
      if (const auto broken = broken_rule(*job_->model, setup)) {
        fault(fmt::format("{} is not a test of the model: {}", where(), *broken));
      }
    }
    for (const Element x : setup) {
      if (std::ranges::count(job_->barred, x) > 0) {
        fault(fmt::format("{} has {}, which it may not have", where(), job_->names[x]));
      }
    }
    const std::size_t place = sheet_.steps.size();
    if (place < job_->first.size() && setup != sorted(*job_, job_->first[place])) {
      fault(where() + " is not the one that must be run there");
    }
  }

  // A value out of range makes a test fail early, so its other pairs do not count as tested.
  [[nodiscard]] bool hides(Element x) const {
    return job_->model != nullptr && x < job_->model->values() && job_->model->value(x).negative;
  }

  void test_pairs(RunStep& step) {
    const bool any_hides = std::ranges::any_of(step.setup, [&](Element x) { return hides(x); });
    // A pair that meets here first includes a part that was put in; but in the first set-up, and
    // after one that hid something, any pair may be new.
    const bool look_at_all = sheet_.steps.empty() || was_hidden_;
    was_hidden_ = any_hides;
    for (const Element x : look_at_all ? step.setup : step.put_in) {
      for (const Element y : step.setup) {
        const bool seen_from_y =
            y >= x && (look_at_all || std::ranges::binary_search(step.put_in, y));
        if (!seen_from_y) {
          meet(x, y, !any_hides || hides(x) || hides(y), step);
        }
      }
    }
    std::ranges::sort(step.new_pairs);
    step.weight_so_far = sheet_.weight_tested;
    step.new_triples = missing_triples_.met(step.setup, [&](const Triple& t) {
      return !any_hides || std::ranges::any_of(t, [&](Element x) { return hides(x); });
    });
  }

  // Two parts are together in a set-up; `shown`: nothing hides what they do.
  void meet(Element x, Element y, bool shown, RunStep& step) {
    const std::pair<Element, Element> pair = std::minmax({x, y});
    if (never_.contains(x, y)) {
      const std::string& why = job_->why_never(x, y);
      fault(fmt::format("{} holds {} and {}, which must never meet{}", where(),
                        job_->names[pair.first], job_->names[pair.second],
                        why.empty() ? "" : " (" + why + ")"));
    }
    if (shown && missing_.contains(x, y)) {
      missing_.erase(x, y);
      step.new_pairs.push_back(pair);
      sheet_.weight_tested += weighs() ? job_->weights(x, y) : Amount{};
    }
  }

  void count_cost(RunStep& step) {
    Amount changes;
    if (job_->replaces()) {
      Replacement replacement = cheapest_replacement(*job_, step.take_out, step.put_in);
      changes = replacement.cost;
      step.replaced = std::move(replacement.pairs);
    } else {
      for (const Element x : step.put_in) {
        changes += job_->change_costs[x];
      }
    }
    sheet_.change_cost += changes;
    step.cost = job_->test_cost + changes;
    sheet_.changes += step.put_in.size();
    sheet_.cost += step.cost;
    step.cost_so_far = sheet_.cost;
  }

  const Job* job_;
  PairTable never_;
  PairTable missing_;
  TripleTable missing_triples_;
  Block mounted_;
  Block before_;
  bool was_hidden_ = false;  // whether the set-up before hid something
  RunSheet sheet_;
};

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
  SheetCounter counter(job);
  for (const Block& setup : setups) {
    counter.add(setup);
  }
  return counter.end();
}

}  // namespace changeover
