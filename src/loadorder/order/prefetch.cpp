#include "changeover/loadorder/prefetch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/pairs/wanted_set.hpp"

namespace changeover {

struct PrefetchSchedule::State {
  State(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted)
      : assigner(items, room, wanted) {}
  PairAssigner assigner;
  AssignedStep assigned;
};

PrefetchSchedule::PrefetchSchedule(std::unique_ptr<StepSource> steps, std::uint64_t items,
                                   std::uint64_t room, const WantedPairs& wanted)
    : state_(std::make_unique<State>(items, room, wanted)) {
  state_->assigner.start(std::move(steps));
}

PrefetchSchedule::~PrefetchSchedule() = default;
PrefetchSchedule::PrefetchSchedule(PrefetchSchedule&&) noexcept = default;

bool PrefetchSchedule::next(PrefetchStep& step) {
  AssignedStep& assigned = state_->assigned;
  step.evict_first = assigned.evicted_first;
  step.evict_late = assigned.evicted_late;
  if (!state_->assigner.next(assigned)) {
    return false;
  }
  step.number = assigned.step.number;
  step.load = assigned.step.load;
  const auto middle = assigned.pairs.begin() + static_cast<std::ptrdiff_t>(assigned.before);
  step.before.assign(assigned.pairs.begin(), middle);
  step.overlap.assign(middle, assigned.pairs.end());
  return true;
}

namespace {

// In pairs: what the model of the summary says.
std::uint64_t time_of(const LoadOrder& order, std::uint64_t room) {
  const LoadOrderFacts& facts = order.facts();
  PrefetchSchedule schedule(order.stream(), facts.items, room, facts.wanted);
  std::uint64_t total = 0;
  std::uint64_t overlap = 0;
  for (PrefetchStep step; schedule.next(step);) {
    total += std::max<std::uint64_t>(overlap, step.load.size() * (room - 1)) + step.before.size();
    overlap = step.overlap.size();
  }
  return total + overlap;
}

// `plan` makes an order for a room.
template <typename Plan>
PrefetchPlan better_way(std::uint64_t items, std::uint64_t room, Plan&& plan) {
  LoadOrder whole = plan(room);
  if (room < 3 || items <= room) {
    return {std::move(whole), 0};
  }
  constexpr std::uint64_t most_compared = 2000;
  LoadOrder less = plan(room - 1);
  if (items <= most_compared && time_of(whole, room) <= time_of(less, room)) {
    return {std::move(whole), 0};
  }
  return {std::move(less), 1};
}

}  // namespace

PrefetchPlan plan_prefetch(std::uint64_t items, std::uint64_t room,
                           const LoadOrderOptions& options) {
  return better_way(items, room,
                    [&](std::uint64_t places) { return plan_load_order(items, places, options); });
}

PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                           const LoadOrderOptions& options) {
  return better_way(wanted.items(), room,
                    [&](std::uint64_t places) { return plan_load_order(wanted, places, options); });
}

PrefetchCheck::PrefetchCheck(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted)
    : room_(room),
      wanted_(wanted),
      done_(std::make_unique<WantedSet>(wanted, items)),
      there_(static_cast<std::size_t>(items), false) {}

PrefetchCheck::~PrefetchCheck() = default;

void PrefetchCheck::fail(std::string fault) {
  if (verdict_.fault.empty()) {
    verdict_.fault = std::move(fault);
  }
}

void PrefetchCheck::compute(const std::vector<ItemPair>& pairs, bool overlapped) {
  for (const auto& [x, y] : pairs) {
    if (x >= y || y >= there_.size() || !there_[x] || !there_[y]) {
      fail(fmt::format("step {} computes {{{},{}}}, which is not in memory", held_.number, x, y));
      return;
    }
    if (!wanted_.contains(x, y)) {
      fail(fmt::format("step {} computes {{{},{}}}, which is not wanted", held_.number, x, y));
      return;
    }
    verdict_.repeated += done_->insert(x, y) ? 0U : 1U;
    ++verdict_.computed;
    verdict_.overlapped += overlapped ? 1U : 0U;
  }
}

void PrefetchCheck::evict(const std::vector<Element>& items, std::uint64_t step) {
  for (const Element x : items) {
    if (x >= there_.size() || !there_[x]) {
      return fail(fmt::format("step {} evicts {}, which is not in memory", step, x));
    }
    there_[x] = false;
    --count_;
  }
}

// The second part of the step before runs while these loads are on their way.
void PrefetchCheck::read(const PrefetchStep& step) {
  if (!verdict_.fault.empty()) {
    return;
  }
  if (step.number != ++verdict_.steps) {
    return fail(fmt::format("step {} is numbered {}", verdict_.steps, step.number));
  }
  evict(step.evict_first, step.number);
  count_ += step.load.size();
  if (count_ > room_) {
    return fail(fmt::format("step {} needs {} places", step.number, count_));
  }
  compute(held_.overlap, true);
  evict(step.evict_late, step.number);
  for (const Element x : step.load) {
    if (x >= there_.size() || there_[x]) {
      return fail(fmt::format("step {} loads {}, which is in memory or no item", step.number, x));
    }
    there_[x] = true;
  }
  held_ = step;
  compute(held_.before, false);
}

PrefetchVerdict PrefetchCheck::finish() {
  compute(held_.overlap, false);
  held_.overlap.clear();
  verdict_.missing = done_->missing();
  return verdict_;
}

}  // namespace changeover
