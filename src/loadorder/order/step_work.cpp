#include "changeover/loadorder/load_order.hpp"

#include <algorithm>
#include <utility>

#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/training/spread_steps.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

std::size_t workers_in_lockstep(const ScheduleRules& rules) {
  return static_cast<std::size_t>(std::max<std::uint64_t>(1, rules.lockstep));
}

/// Adds what each step computes: each pair in the first step that can.
class ComputedSteps final : public StepSource {
 public:
  ComputedSteps(std::unique_ptr<StepSource> steps, const ScheduleRules& rules,
                std::shared_ptr<const PairOwners> owners)
      : rules_(rules),
        compute_(rules.compute.value_or(ComputeRules{})),
        round_(workers_in_lockstep(rules)),
        given_(round_.size()),
        assigner_(rules.items, rules.fast_room.value_or(rules.room), rules.wanted,
                  static_cast<std::size_t>(rules.lockstep), rules.fast_room.has_value(),
                  std::move(owners), rules.sizes) {
    assigner_.start(std::move(steps));
  }

  bool next(Step& step) override {
    if (given_ == round_.size()) {
      if (over_ || !read()) {
        over_ = true;
        return false;
      }
      given_ = 0;
    }
    put(round_[given_++], step);
    return true;
  }

 private:
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
    to.epoch = from.step.epoch;
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
    to.store.clear();
    to.compute.clear();
    to.overlap.clear();
    if (!rules_.compute) {
      return;
    }
    for (std::size_t i = 0; i < from.stayed.size() && compute_.self; ++i) {
      add_alone(from, from.stayed[i], to);
    }
    // In lockstep an item is computed alone when it arrives, otherwise before all pairs of the
    // step: journals depend on this order.
    std::size_t done = 0;
    if (rules_.lockstep > 0) {
      add(from.pairs, 0, from.stayed_end, to.compute);
      done = from.stayed_end;
    }
    const std::vector<Element>& came = rules_.fast_room ? to.fast_load : to.load;
    for (std::size_t i = 0; i < came.size() && compute_.self; ++i) {
      if (from.is_new[i]) {
        add_alone(from, came[i], to);
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

  void add_alone(const AssignedStep& from, Element x, Step& to) const {
    const std::vector<Element>& early = from.evicted_first;
    const bool waits = rules_.overlap && std::ranges::find(early, x) == early.end();
    (waits ? to.overlap : to.compute).emplace_back(x, x);
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

  ScheduleRules rules_;
  ComputeRules compute_;
  std::vector<AssignedStep> round_;  // by worker, in lockstep
  std::size_t given_;
  bool over_ = false;
  PairAssigner assigner_;
  struct {
    std::vector<Element> first, late;
  } before_;  // what the step before will evict
};

/// The pairs of each step in random order.
class ShuffledSteps final : public StepSource {
 public:
  ShuffledSteps(std::unique_ptr<StepSource> steps, std::uint64_t seed)
      : steps_(std::move(steps)), random_(seed) {}

  bool next(Step& step) override {
    if (!steps_->next(step)) {
      return false;
    }
    shuffle(step.compute, random_);
    shuffle(step.overlap, random_);
    return true;
  }

 private:
  std::unique_ptr<StepSource> steps_;
  Random random_;
};

/// A changed item is stored when it is evicted, before any worker loads; in a last step all items
/// are evicted.
class StoredSteps final : public StepSource {
 public:
  StoredSteps(std::unique_ptr<StepSource> steps, const ScheduleRules& rules)
      : rules_(rules),
        steps_(std::move(steps)),
        made_(workers_in_lockstep(rules)),
        given_(made_.size()),
        changed_(static_cast<std::size_t>(rules.items), false),
        held_by_(changed_.size(), 0),
        fast_(rules.fast_room ? changed_.size() : 0, false) {}

  bool next(Step& step) override {
    if (given_ == made_.size()) {
      if (over_) {
        return false;
      }
      make();
      given_ = 0;
    }
    std::swap(step, made_[given_++]);
    return true;
  }

 private:
  // The next step of all workers.
  void make() {
    for (Step& step : made_) {
      if (!steps_->next(step)) {
        over_ = true;
        leave_all();
        break;
      }
    }
    if (!over_) {
      last_ = {made_[0].number, made_[0].worker, made_[0].epoch};
    }
    store();
  }

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

  // The last step, in which all items are evicted.
  void leave_all() {
    for (std::size_t w = 0; w < made_.size(); ++w) {
      made_[w] = {};
      made_[w].number = last_.number + 1;
      made_[w].worker = last_.worker + w;
      made_[w].epoch = last_.epoch;
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
  std::unique_ptr<StepSource> steps_;
  std::vector<Step> made_;
  std::size_t given_;
  bool over_ = false;
  std::vector<bool> changed_;           // by item: since it was loaded
  std::vector<std::uint64_t> held_by_;  // by item: its worker plus one
  std::vector<bool> fast_;              // by item: on the accelerator now
  struct {
    std::uint64_t number = 0, worker = 0, epoch = 1;
  } last_;  // the last step; in lockstep, that of the first worker
};

}  // namespace

StepWork::StepWork(std::unique_ptr<StepSource> steps, const ScheduleRules& rules,
                   std::shared_ptr<const PairOwners> owners)
    : steps_(std::make_unique<ComputedSteps>(std::move(steps), rules, std::move(owners))) {
  const ComputeRules compute = rules.compute.value_or(ComputeRules{});
  if (compute.spread) {
    steps_ = spread_over_steps(std::move(steps_), rules, *compute.spread);
  }
  if (compute.shuffle) {
    steps_ = std::make_unique<ShuffledSteps>(std::move(steps_), *compute.shuffle);
  }
  if (rules.store) {
    steps_ = std::make_unique<StoredSteps>(std::move(steps_), rules);
  }
}
StepWork::~StepWork() = default;

bool StepWork::next(Step& step) { return steps_->next(step); }

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
  // The bound on loads counts each of these items once.
  const std::uint64_t least = loads.loads > without_pair ? loads.loads - without_pair : 0;
  return {least,
          "a stay in memory in which an item changes has a load and a store, and the other "
          "stays can be left out"};
}

}  // namespace changeover
