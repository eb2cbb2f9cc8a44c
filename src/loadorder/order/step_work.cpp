#include "changeover/loadorder/load_order.hpp"

#include <algorithm>
#include <utility>

#include "loadorder/order/pair_assigner.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

void shuffle_pairs(std::vector<ItemPair>& pairs, Random& random) {
  for (std::size_t i = pairs.size(); i > 1; --i) {
    std::swap(pairs[i - 1], pairs[random.below(static_cast<std::uint32_t>(i))]);
  }
}

}  // namespace

class StepWork::State {
 public:
  State(std::unique_ptr<StepSource> steps, const ScheduleRules& rules,
        std::shared_ptr<const PairOwners> owners)
      : rules_(rules),
        compute_(rules.compute.value_or(ComputeRules{})),
        random_(compute_.shuffle.value_or(0)),
        round_(static_cast<std::size_t>(std::max<std::uint64_t>(1, rules.lockstep))),
        made_(round_.size()),
        assigner_(rules.items, rules.fast_room.value_or(rules.room), rules.wanted,
                  static_cast<std::size_t>(rules.lockstep), rules.fast_room.has_value(),
                  std::move(owners)) {
    if (rules.store) {
      changed_.assign(static_cast<std::size_t>(rules.items), false);
      held_by_.assign(changed_.size(), 0);
      fast_.assign(rules.fast_room ? changed_.size() : 0, false);
    }
    assigner_.start(std::move(steps));
  }

  bool next(Step& step) {
    if (given_ == made_.size() || !begun_) {
      begun_ = true;
      given_ = 0;
      if (over_ || !make()) {
        given_ = made_.size();
        return false;
      }
    }
    std::swap(step, made_[given_++]);
    return true;
  }

 private:
  // The next step of all workers.
  bool make() {
    if (!read()) {
      over_ = true;
      if (!rules_.store) {
        return false;
      }
      leave_all();
      store();
      return true;
    }
    for (std::size_t w = 0; w < round_.size(); ++w) {
      put(round_[w], made_[w]);
      if (compute_.shuffle) {
        shuffle_pairs(made_[w].compute, random_);
        shuffle_pairs(made_[w].overlap, random_);
      }
    }
    last_ = {made_[0].number, made_[0].worker};
    if (rules_.store) {
      store();
    }
    return true;
  }

  bool read() {
    if (rules_.lockstep > 0) {
      return assigner_.next_round(round_);
    }
    before_.first = std::move(round_[0].evicted_first);
    before_.late = std::move(round_[0].evicted_late);
    return assigner_.next(round_[0]);
  }

  void put(const AssignedStep& from, Step& to) {
    to.number = from.step.number;
    to.worker = from.step.worker;
    to.load = from.step.load;
    to.fast_evict = from.step.fast_evict;
    to.fast_load = from.step.fast_load;
    to.late = 0;
    if (rules_.overlap) {
      to.evict = before_.first;
      to.evict.insert(to.evict.end(), before_.late.begin(), before_.late.end());
      to.late = before_.late.size();
    } else {
      to.evict = from.step.evict;
    }
    to.compute.clear();
    to.overlap.clear();
    if (!rules_.compute) {
      return;
    }
    // In lockstep an item alone comes with its arrival, otherwise before all pairs: journals rely
    // on it.
    std::size_t done = 0;
    const std::vector<Element>& came = rules_.fast_room ? to.fast_load : to.load;
    for (std::size_t i = 0; i < came.size() && compute_.self; ++i) {
      if (from.is_new[i]) {
        const std::vector<Element>& early = from.evicted_first;
        const bool waits =
            rules_.overlap && std::find(early.begin(), early.end(), came[i]) == early.end();
        (waits ? to.overlap : to.compute).emplace_back(came[i], came[i]);
      }
      if (rules_.lockstep > 0) {
        add(from.pairs, done, from.arrival_end[i], to.compute);
        done = from.arrival_end[i];
      }
    }
    const std::size_t middle = rules_.overlap ? from.before : from.pairs.size();
    add(from.pairs, done, middle, to.compute);
    add(from.pairs, middle, from.pairs.size(), to.overlap);
  }

  void add(const std::vector<ItemPair>& pairs, std::size_t begin, std::size_t end,
           std::vector<ItemPair>& out) const {
    for (std::size_t i = begin; i < end; ++i) {
      out.push_back(pairs[i]);
      if (compute_.ordered) {
        out.emplace_back(pairs[i].second, pairs[i].first);
      }
    }
  }

  // What was changed and goes, before any worker loads.
  void store() {
    for (Step& step : made_) {
      step.store.clear();
      for (const Element x : step.fast_evict) {
        fast_[x] = false;
      }
      for (const Element x : step.evict) {
        held_by_[x] = 0;
        if (changed_[x]) {
          step.store.push_back(x);
          changed_[x] = false;
        }
      }
    }
    for (const Step& step : made_) {
      for (const Element x : step.load) {
        held_by_[x] = step.worker + 1;
      }
      for (const Element x : step.fast_load) {
        fast_[x] = true;
      }
      for (const std::vector<ItemPair>* const pairs : {&step.compute, &step.overlap}) {
        for (const auto& [x, y] : *pairs) {
          changed_[x] = changed_[y] = true;
        }
      }
    }
  }

  // A last step.
  void leave_all() {
    for (std::size_t w = 0; w < made_.size(); ++w) {
      made_[w] = {};
      made_[w].number = last_.number + 1;
      made_[w].worker = last_.worker + w;
    }
    for (Element x = 0; x < held_by_.size(); ++x) {
      if (held_by_[x] != 0) {
        Step& step = made_[made_.size() > 1 ? static_cast<std::size_t>(held_by_[x] - 1) : 0];
        step.evict.push_back(x);
        if (!fast_.empty() && fast_[x]) {
          step.fast_evict.push_back(x);
        }
      }
    }
    for (Step& step : made_) {
      step.late = rules_.overlap ? step.evict.size() : 0;
    }
  }

  ScheduleRules rules_;
  ComputeRules compute_;
  Random random_;
  std::vector<AssignedStep> round_;  // by worker, in lockstep
  std::vector<Step> made_;
  PairAssigner assigner_;
  std::size_t given_ = 0;
  bool begun_ = false;
  bool over_ = false;
  struct {
    std::vector<Element> first, late;
  } before_;                            // what the step before has chosen to go
  std::vector<bool> changed_;           // by item: since it was loaded
  std::vector<std::uint64_t> held_by_;  // by item: its worker plus one
  std::vector<bool> fast_;              // by item: on the accelerator now
  struct {
    std::uint64_t number = 0, worker = 0;
  } last_;  // of the last step, in lockstep of the first worker's
};

StepWork::StepWork(std::unique_ptr<StepSource> steps, const ScheduleRules& rules,
                   std::shared_ptr<const PairOwners> owners)
    : state_(std::make_unique<State>(std::move(steps), rules, std::move(owners))) {}
StepWork::~StepWork() = default;

bool StepWork::next(Step& step) { return state_->next(step); }

LoadBound store_lower_bound(const LoadBound& loads, const WantedPairs& wanted, std::uint64_t items,
                            bool alone) {
  std::uint64_t without_pair = 0;
  if (!alone && wanted.are_all()) {
    without_pair = items == 1 ? 1 : 0;
  } else if (!alone && wanted.graph() != nullptr) {
    for (Element x = 0; x < wanted.items(); ++x) {
      without_pair += wanted.needs(x) && wanted.graph()->partners(x).empty() ? 1U : 0U;
    }
  }
  // A bound on loads counts each of them once.
  const std::uint64_t least = loads.loads > without_pair ? loads.loads - without_pair : 0;
  return {least,
          "a stay in memory in which an item changes has a load and a store, and the other "
          "stays can be left out"};
}

}  // namespace changeover
