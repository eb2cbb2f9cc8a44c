#include "changeover/loadorder/workers.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace changeover {
namespace {

std::shared_ptr<const PairOwners> owners_in(const LoadOrder& /*order*/) { return nullptr; }
std::shared_ptr<const PairOwners> owners_in(const WorkerSplit& split) { return split.owners(); }

// The time of the busiest worker in the model of loadorder/workers.hpp, in pairs.
template <typename Order>
std::uint64_t time_of(const Order& order, std::uint64_t room, const WantedPairs& wanted) {
  StepWork schedule(order.stream(),
                    {.items = wanted.items(),
                     .room = room,
                     .wanted = wanted,
                     .compute = ComputeRules{},
                     .overlap = true},
                    owners_in(order));
  std::uint64_t longest = 0;
  std::uint64_t total = 0;
  std::uint64_t overlap = 0;
  for (Step step; schedule.next(step);) {
    if (step.number == 1) {
      longest = std::max(longest, total + overlap);
      total = overlap = 0;
    }
    total += std::max<std::uint64_t>(overlap, step.load.size() * (room - 1)) + step.compute.size();
    overlap = step.overlap.size();
  }
  return std::max(longest, total + overlap);
}

// `plan` makes an order for a given room.
template <typename Plan>
auto better_way(const WantedPairs& wanted, std::uint64_t room, Plan&& plan)
    -> Prefetched<decltype(plan(room))> {
  auto whole = plan(room);
  if (room < 3 || wanted.items() <= room) {
    return {std::move(whole), 0};
  }
  constexpr std::uint64_t most_compared = 2000;
  auto less = plan(room - 1);
  if (wanted.items() <= most_compared &&
      time_of(whole, room, wanted) <= time_of(less, room, wanted)) {
    return {std::move(whole), 0};
  }
  return {std::move(less), 1};
}

}  // namespace

PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                           const LoadOrderOptions& options) {
  return better_way(wanted, room,
                    [&](std::uint64_t places) { return plan_load_order(wanted, places, options); });
}

PrefetchSplit split_prefetch(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  return better_way(wanted, room, [&](std::uint64_t places) {
    return split_load_order(wanted, places, workers, options);
  });
}

}  // namespace changeover
