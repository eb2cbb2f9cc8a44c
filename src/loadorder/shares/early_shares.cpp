// Two levels of several workers whose loads start early.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/order/levels/loads_ahead.hpp"
#include "loadorder/shares/split_maker.hpp"

namespace changeover {
namespace {

// The time of the slowest worker.
double time_of(const WorkerSplit& split, const WorkerSteps& steps) {
  ScheduleRules rules = split.rules(ComputeRules{});
  double longest = 0;
  for (std::uint64_t w = 0; w < split.facts().workers.size(); ++w) {
    StepWork work(steps.of(w), rules, split.owners());
    longest = std::max(longest, time_ahead(work, rules));
  }
  return longest;
}

}  // namespace

void SplitMaker::start_early(WorkerSplit& split) {
  std::shared_ptr<const WorkerSteps> best;
  double least = 0;
  for (const std::uint64_t spare : spares_to_try(split.rules())) {
    stop_if_asked();
    auto steps = std::make_shared<StepLists>();
    for (std::uint64_t w = 0; w < split.facts().workers.size(); ++w) {
      steps->add(loads_ahead(*split.stream(w), split.facts().items, split.facts().room, spare,
                             split.order().facts().sizes.get()));
    }
    if (const double time = time_of(split, *steps); best == nullptr || time < least) {
      least = time;
      best = std::move(steps);
    }
  }
  SplitFacts& facts = split.facts_;
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    facts.workers[w].loads = 0;
    const auto steps = best->of(w);
    for (Step step; steps->next(step);) {
      facts.workers[w].loads += step.load.size();
    }
  }
  take_steps(split, best);
  ScheduleRules rules = split.rules();
  std::unique_ptr<StepSource> steps = split.stream();
  constexpr std::uint64_t most_pairs = 30'000'000;
  if (facts.all_pairs <= most_pairs && (split.owners_ != nullptr || facts.workers.size() == 1)) {
    rules.compute = ComputeRules{};
    steps = std::make_unique<StepWork>(std::move(steps), rules, split.owners_);
  }
  const ScheduleVerdict verdict = check_schedule(*steps, rules);
  if (!verdict.valid() || verdict.loads != facts.loads) {
    throw InternalError(fmt::format("the early loads of {} workers are wrong: {}{}",
                                    facts.workers.size(), verdict.fault, verdict.example));
  }
  facts.epoch_loads = facts.epochs > 1 ? verdict.epoch_loads : std::vector<std::uint64_t>();
  LoadOrderFacts whole = split.order_.facts();
  whole.bytes = verdict.bytes;
  whole.most_bytes = verdict.most_bytes;
  split.order_ = LoadOrder(std::move(whole), split.order_.maker());
}

WorkerSplit start_loads_early(WorkerSplit split) {
  SplitMaker::start_early(split);
  return split;
}

}  // namespace changeover
