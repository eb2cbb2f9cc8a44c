#include "changeover/loadorder/prefetch.hpp"

#include <algorithm>
#include <utility>

namespace changeover {

namespace {

// In pairs: what the model of the summary says.
std::uint64_t time_of(const LoadOrder& order, std::uint64_t room) {
  const LoadOrderFacts& facts = order.facts();
  StepWork schedule(order.stream(), {.items = facts.items,
                                     .room = room,
                                     .wanted = facts.wanted,
                                     .compute = ComputeRules{},
                                     .overlap = true});
  std::uint64_t total = 0;
  std::uint64_t overlap = 0;
  for (Step step; schedule.next(step);) {
    total += std::max<std::uint64_t>(overlap, step.load.size() * (room - 1)) + step.compute.size();
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

}  // namespace changeover
