#include <algorithm>
#include <memory>
#include <utility>

#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

std::shared_ptr<const PairOwners> owners_in(const LoadOrder& /*order*/) { return nullptr; }
std::shared_ptr<const PairOwners> owners_in(const WorkerSplit& split) { return split.owners(); }

/// How long loads take, in pairs: as long as the pairs that a place, or an item of mean size, can
/// bring together.
class LoadTime {
 public:
  explicit LoadTime(std::uint64_t room) : of_item_(static_cast<double>(room - 1)) {}
  LoadTime(std::shared_ptr<const ItemSizes> sizes, double mean) : sizes_(std::move(sizes)) {
    of_item_ = (static_cast<double>(sizes_->memory) / mean - 1) / mean;
  }

  [[nodiscard]] double of(const std::vector<Element>& items) const {
    const std::uint64_t size = sizes_ == nullptr ? items.size() : bytes_of(*sizes_, items);
    return static_cast<double>(size) * of_item_;
  }

 private:
  double of_item_ = 0;  // or of a byte
  std::shared_ptr<const ItemSizes> sizes_;
};

// The time of the busiest worker in the model of loadorder/workers.hpp, in pairs, with `room` for
// items of equal size.
template <typename Order>
double time_of(const Order& order, std::uint64_t room, const LoadTime& loads) {
  ScheduleRules rules = order.rules(ComputeRules{});
  rules.room = std::max(room, rules.room);
  rules.overlap = true;
  StepWork schedule(order.stream(), rules, owners_in(order));
  double longest = 0;
  double total = 0;
  double overlap = 0;
  for (Step step; schedule.next(step);) {
    if (step.number == 1) {
      longest = std::max(longest, total + overlap);
      total = overlap = 0;
    }
    total += std::max(overlap, loads.of(step.load)) + static_cast<double>(step.compute.size());
    overlap = static_cast<double>(step.overlap.size());
  }
  return std::max(longest, total + overlap);
}

// `plan` makes an order that leaves so much free; all of the items are so many.
template <typename Plan>
auto better_way(std::uint64_t items, std::uint64_t spare, std::uint64_t room, const LoadTime& loads,
                Plan&& plan) -> Prefetched<decltype(plan(spare))> {
  auto whole = plan(0);
  if (spare == 0) {
    return {std::move(whole), 0};
  }
  constexpr std::uint64_t most_compared = 2000;
  auto less = plan(spare);
  if (items <= most_compared && time_of(whole, room, loads) <= time_of(less, room, loads)) {
    return {std::move(whole), 0};
  }
  return {std::move(less), spare};
}

template <typename Plan>
auto better_way(const WantedPairs& wanted, std::uint64_t room, Plan&& plan) {
  const std::uint64_t spare = room < 3 || wanted.items() <= room ? 0 : 1;
  return better_way(wanted.items(), spare, room, LoadTime(std::max<std::uint64_t>(1, room)),
                    [&](std::uint64_t places) { return plan(room - places); });
}

// The memory of the largest item is free, unless two items that must meet need it.
template <typename Plan>
auto better_way(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
                Plan&& plan) {
  check_sizes(*sizes, wanted);
  std::uint64_t all = 0;
  std::uint64_t count = 0;
  std::uint64_t spare = 0;
  for (Element x = 0; x < sizes->bytes.size(); ++x) {
    if (wanted.needs(x)) {
      all = checked_add(all, sizes->bytes[x]);
      spare = std::max(spare, sizes->bytes[x]);
      ++count;
    }
  }
  if (all <= sizes->memory || sizes->memory - largest_pair(*sizes, wanted) < spare) {
    spare = 0;
  }
  const double mean = static_cast<double>(all) / static_cast<double>(count);
  return better_way(sizes->bytes.size(), spare, 0, LoadTime(sizes, mean), plan);
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

PrefetchPlan plan_prefetch(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
                           const LoadOrderOptions& options) {
  return better_way(sizes, wanted, [&](std::uint64_t spare) {
    return plan_with_spare(sizes, wanted, spare, options);
  });
}

PrefetchSplit split_prefetch(const std::shared_ptr<const ItemSizes>& sizes,
                             const WantedPairs& wanted, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  return better_way(sizes, wanted, [&](std::uint64_t spare) {
    return split_with_spare(sizes, wanted, workers, spare, options);
  });
}

}  // namespace changeover
