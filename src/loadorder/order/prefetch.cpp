#include <algorithm>
#include <memory>
#include <utility>

#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "loadorder/order/in_rounds.hpp"
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

/// A way to leave room for loads; its time, if ways were compared.
template <typename Order>
struct Way {
  Prefetched<Order> plan;
  double time = 0;

  [[nodiscard]] bool better_than(const Way& other) const {
    return std::pair(time, plan.order.facts().loads) <
           std::pair(other.time, other.plan.order.facts().loads);
  }
};

// `plan` makes an order that leaves so much free; all of the items are so many.
template <typename Plan>
auto better_way(std::uint64_t items, std::uint64_t spare, std::uint64_t room, const LoadTime& loads,
                const Plan& plan) -> Way<decltype(plan(0))> {
  constexpr std::uint64_t most_compared = 2000;
  auto whole = plan(0);
  const double time = items <= most_compared ? time_of(whole, room, loads) : 0;
  if (spare == 0) {
    return {{std::move(whole), 0}, time};
  }
  auto less = plan(spare);
  const double its_time = items <= most_compared ? time_of(less, room, loads) : 0;
  if (items <= most_compared && time <= its_time) {
    return {{std::move(whole), 0}, time};
  }
  return {{std::move(less), spare}, its_time};
}

template <typename Plan>
auto better_way(std::uint64_t room, const WantedPairs& wanted, const Plan& plan) {
  const std::uint64_t spare = room < 3 || wanted.items() <= room ? 0 : 1;
  return better_way(wanted.items(), spare, room, LoadTime(std::max<std::uint64_t>(1, room)), plan);
}

// The memory of the largest item is free, unless two items that must meet need it.
template <typename Plan>
auto better_way(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
                const Plan& plan) {
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

// The best of rounds; `plan` makes an order that leaves so much free, with such options.
template <typename Items, typename Plan>
auto best_way(const Items& items, const WantedPairs& wanted, const LoadOrderOptions& options,
              const Plan& plan) {
  return best_in_rounds(
             options,
             [&](const LoadOrderOptions& its) {
               return better_way(items, wanted,
                                 [&](std::uint64_t spare) { return plan(spare, its); });
             },
             [](const auto& its, const auto& other) { return its.better_than(other); })
      .plan;
}

}  // namespace

PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                           const LoadOrderOptions& options) {
  return best_way(room, wanted, options, [&](std::uint64_t places, const LoadOrderOptions& its) {
    return plan_load_order(wanted, room - places, its);
  });
}

PrefetchSplit split_prefetch(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  return best_way(room, wanted, options, [&](std::uint64_t places, const LoadOrderOptions& its) {
    return split_load_order(wanted, room - places, workers, its);
  });
}

PrefetchPlan plan_prefetch(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
                           const LoadOrderOptions& options) {
  return best_way(sizes, wanted, options, [&](std::uint64_t spare, const LoadOrderOptions& its) {
    return plan_with_spare(sizes, wanted, spare, its);
  });
}

PrefetchSplit split_prefetch(const std::shared_ptr<const ItemSizes>& sizes,
                             const WantedPairs& wanted, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  return best_way(sizes, wanted, options, [&](std::uint64_t spare, const LoadOrderOptions& its) {
    return split_with_spare(sizes, wanted, workers, spare, its);
  });
}

}  // namespace changeover
