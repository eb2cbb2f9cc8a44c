#include "changeover/loadorder/step_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/order/shuffle_pairs.hpp"
#include "loadorder/pairs/wanted_set.hpp"
#include "run/random.hpp"

namespace changeover {

struct StepWork::State {
  State(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted,
        const StepWorkOptions& how)
      : assigner(items, room, wanted), options(how), random(how.shuffle.value_or(0)) {}

  PairAssigner assigner;
  AssignedStep assigned;
  StepWorkOptions options;
  Random random;
};

StepWork::StepWork(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted,
                   const StepWorkOptions& options)
    : state_(std::make_unique<State>(items, room, wanted, options)) {}

StepWork::~StepWork() = default;
StepWork::StepWork(StepWork&&) noexcept = default;

void StepWork::start(std::unique_ptr<StepSource> steps) {
  state_->assigner.start(std::move(steps));
}

bool StepWork::next(WorkStep& step) {
  AssignedStep& assigned = state_->assigned;
  if (!state_->assigner.next(assigned)) {
    return false;
  }
  step.loads = assigned.step;
  step.pairs.clear();
  if (state_->options.self) {
    for (std::size_t i = 0; i < assigned.step.load.size(); ++i) {
      if (assigned.is_new[i]) {
        step.pairs.emplace_back(assigned.step.load[i], assigned.step.load[i]);
      }
    }
  }
  for (const auto& [x, y] : assigned.pairs) {
    step.pairs.emplace_back(x, y);
    if (state_->options.ordered) {
      step.pairs.emplace_back(y, x);
    }
  }
  if (state_->options.shuffle) {
    shuffle_pairs(step.pairs, state_->random);
  }
  return true;
}

WorkCheck::WorkCheck(std::uint64_t items, const WantedPairs& wanted, const StepWorkOptions& options)
    : wanted_(wanted),
      options_(options),
      upward_(std::make_unique<WantedSet>(wanted, items)),
      downward_(options.ordered ? std::make_unique<WantedSet>(wanted, items) : nullptr),
      alone_(static_cast<std::size_t>(items), false),
      loaded_(alone_),
      there_(alone_) {}

WorkCheck::~WorkCheck() = default;

void WorkCheck::start_over() { std::fill(there_.begin(), there_.end(), false); }

void WorkCheck::compute(const ItemPair& pair, std::uint64_t step) {
  const auto [x, y] = pair;
  if (x >= there_.size() || y >= there_.size() || !there_[x] || !there_[y]) {
    verdict_.fault = fmt::format("step {} computes ({},{}), which is not in memory", step, x, y);
    return;
  }
  ++verdict_.computed;
  bool is_new = false;
  if (x == y && options_.self) {
    is_new = !alone_[x];
    alone_[x] = true;
  } else if (x == y || (x > y && !options_.ordered) || !wanted_.contains(x, y)) {
    verdict_.fault = fmt::format("step {} computes ({},{}), which is not wanted", step, x, y);
    return;
  } else {
    is_new = (x < y ? upward_ : downward_)->insert(x, y);
  }
  verdict_.repeated += is_new ? 0U : 1U;
}

void WorkCheck::read(const WorkStep& step) {
  if (!verdict_.fault.empty()) {
    return;
  }
  const auto put = [&](const std::vector<Element>& items, bool present) {
    for (const Element x : items) {
      if (x >= there_.size() || there_[x] == present) {
        verdict_.fault =
            fmt::format("step {} {} {}", step.loads.number, present ? "loads" : "evicts", x);
        return;
      }
      there_[x] = present;
      loaded_[x] = true;
    }
  };
  put(step.loads.evict, false);
  put(step.loads.load, true);
  for (const ItemPair& pair : step.pairs) {
    if (verdict_.fault.empty()) {
      compute(pair, step.loads.number);
    }
  }
}

WorkVerdict WorkCheck::finish() const {
  WorkVerdict verdict = verdict_;
  verdict.missing = upward_->missing() + (downward_ ? downward_->missing() : 0);
  for (std::size_t x = 0; x < loaded_.size() && options_.self; ++x) {
    verdict.missing += loaded_[x] && !alone_[x] ? 1U : 0U;
  }
  return verdict;
}

}  // namespace changeover
