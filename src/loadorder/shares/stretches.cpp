#include "loadorder/shares/stretches.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/least_number.hpp"
#include "loadorder/order/order_relay.hpp"

namespace changeover {

std::shared_ptr<const GroupOwners> owners_of_stretches(const LoadOrder& order,
                                                       const std::vector<WorkerFacts>& workers,
                                                       std::uint64_t items) {
  const std::uint64_t groups = order.facts().items;
  auto owners = std::make_shared<GroupOwners>(ItemGroups{items, groups}, workers.size());
  const auto relay = std::make_shared<OrderRelay>();
  std::vector<std::uint64_t> met(static_cast<std::size_t>(groups * groups), 0);  // by worker plus 1
  for (std::uint64_t w = 0; w < workers.size(); ++w) {
    const WorkerFacts& facts = workers[static_cast<std::size_t>(w)];
    const auto steps = stretch_steps(relay, order, facts.first_step, facts.steps, groups, w);
    std::vector<Element> memory;
    for (Step step; steps->next(step);) {
      for (const Element group : step.evict) {
        std::erase(memory, group);
      }
      for (const Element group : step.load) {
        memory.push_back(group);
        for (const Element other : memory) {
          const std::uint64_t place = std::max(group, other) * groups + std::min(group, other);
          if (std::exchange(met[static_cast<std::size_t>(place)], w + 1) != w + 1) {
            owners->add(w, group, other, step.number);
          }
        }
      }
    }
  }
  owners->balance();
  return owners;
}

namespace {

/// What a load and a transfer to an accelerator count, as numbers of items or of bytes.
struct Weights {
  std::uint64_t load = 1;
  std::uint64_t transfer = 0;
};

// At two levels the moves on both, each divided by its lower bound.
Weights weights_of(const LoadOrderFacts& whole) {
  if (!whole.fast_room) {
    return {};
  }
  const bool by_bytes = whole.sizes != nullptr;
  Weights weights{by_bytes ? whole.transfer_byte_bound.loads : whole.transfer_bound.loads,
                  by_bytes ? whole.byte_bound.loads : whole.bound.loads};
  const auto loads = static_cast<double>(by_bytes ? whole.bytes : whole.loads);
  const auto transfers = static_cast<double>(by_bytes ? whole.transfer_bytes : whole.transfers);
  constexpr double most = 1e18;  // all of it, so that sums fit into 64 bits
  while (static_cast<double>(weights.load) * loads +
             static_cast<double>(weights.transfer) * transfers >
         most) {
    weights = {weights.load / 2, weights.transfer / 2};
  }
  return {std::max<std::uint64_t>(1, weights.load), std::max<std::uint64_t>(1, weights.transfer)};
}

/// What the steps of an order hold and load, in items or in bytes.
class StepSizes {
 public:
  StepSizes(const LoadOrder& order, std::uint64_t items, Weights weights = {},
            const ItemSizes* bytes = nullptr);

  [[nodiscard]] std::uint64_t steps() const { return held_.size(); }
  /// The loads of a worker whose share begins with step `first`, counted from 0: what is in memory
  /// then, and all after it.
  [[nodiscard]] std::uint64_t loads(std::uint64_t first, std::uint64_t count) const {
    return held_[first] + loaded_[first + count] - loaded_[first + 1];
  }
  /// The number of steps of each share, of so many workers, whose largest has as few loads as can
  /// be: with contiguous shares, by bisection.
  [[nodiscard]] std::vector<std::uint64_t> best_shares(std::uint64_t workers) const;

 private:
  [[nodiscard]] std::uint64_t fitting(std::uint64_t first, std::uint64_t most) const;
  [[nodiscard]] std::vector<std::uint64_t> shares(std::uint64_t most) const;

  std::vector<std::uint64_t> held_;    // after each step
  std::vector<std::uint64_t> loaded_;  // before each step
};

StepSizes::StepSizes(const LoadOrder& order, std::uint64_t items, Weights weights,
                     const ItemSizes* bytes) {
  const LoadOrderFacts& whole = order.facts();
  const auto size_of = [&](const std::vector<Element>& groups) {
    std::uint64_t sum = 0;
    for (const Element group : groups) {
      sum += bytes != nullptr
                 ? bytes->bytes[group]
                 : (group + std::uint64_t{1}) * items / whole.items - group * items / whole.items;
    }
    return sum;
  };
  const auto size = [&](const std::vector<Element>& groups, const std::vector<Element>& fast) {
    return size_of(groups) * weights.load + size_of(fast) * weights.transfer;
  };
  held_.reserve(static_cast<std::size_t>(whole.steps));
  loaded_.reserve(static_cast<std::size_t>(whole.steps) + 1);
  loaded_.push_back(0);
  std::uint64_t held = 0;
  const auto steps = order.stream();
  for (Step step; steps->next(step);) {
    stop_if_asked();
    const std::uint64_t loads = size(step.load, step.fast_load);
    held += loads - size(step.evict, step.fast_evict);
    held_.push_back(held);
    loaded_.push_back(loaded_.back() + loads);
  }
}

// The most steps from `first` on with at most `most` loads.
std::uint64_t StepSizes::fitting(std::uint64_t first, std::uint64_t most) const {
  if (held_[first] > most) {
    return 0;
  }
  const auto begin = loaded_.begin() + static_cast<std::ptrdiff_t>(first + 1);
  const std::uint64_t left = most - held_[first] + *begin;
  return static_cast<std::uint64_t>(std::upper_bound(begin, loaded_.end(), left) - begin);
}

// As many shares as needed so that each has at most `most` loads; empty if a single step has more.
std::vector<std::uint64_t> StepSizes::shares(std::uint64_t most) const {
  std::vector<std::uint64_t> counts;
  for (std::uint64_t first = 0; first < steps();) {
    const std::uint64_t count = fitting(first, most);
    if (count == 0) {
      return {};
    }
    counts.push_back(count);
    first += count;
  }
  return counts;
}

std::vector<std::uint64_t> StepSizes::best_shares(std::uint64_t workers) const {
  return shares(least_number(1, loaded_.back(), [&](std::uint64_t makespan) {
    const std::vector<std::uint64_t> counts = shares(makespan);
    return !counts.empty() && counts.size() <= workers;
  }));
}

// The number of steps of each worker. Each step brings the same number of pairs together, except
// the first, which brings together those of `ahead` further steps; its worker gets fewer steps.
std::vector<std::uint64_t> equal_shares(std::uint64_t steps, std::uint64_t workers,
                                        std::uint64_t ahead) {
  std::vector<std::uint64_t> counts(static_cast<std::size_t>(workers), 0);
  if (workers == 0 || steps == 0) {
    return counts;
  }
  if (ahead > 0 && (steps + ahead) / workers <= ahead + 1) {
    counts = equal_shares(steps - 1, workers - 1, 0);
    counts.insert(counts.begin(), 1);
    return counts;
  }
  const std::uint64_t all = steps + ahead;
  for (std::uint64_t w = 0; w < workers; ++w) {
    counts[static_cast<std::size_t>(w)] = all / workers + (w < all % workers ? 1 : 0);
  }
  counts[0] -= ahead;
  return counts;
}

// How many steps as all others the first one is worth, in pairs, beside itself.
std::uint64_t steps_ahead(std::uint64_t room, std::uint64_t change) {
  const std::uint64_t a_step = change * (room - change) + binomial(change, 2);
  return a_step == 0 ? 0 : (binomial(room, 2) - std::min(binomial(room, 2), a_step)) / a_step;
}

}  // namespace

Stretches cut_order(const LoadOrder& order, std::uint64_t items, std::uint64_t workers,
                    bool even_pairs) {
  Stretches cut;
  const LoadOrderFacts& whole = order.facts();
  // Blocks are full and steps alike, unless items are grouped: then sizes differ by one.
  const std::uint64_t first_loads = std::min(whole.room, whole.items);
  const std::uint64_t change =
      whole.steps > 1 ? (whole.loads - first_loads) / (whole.steps - 1) : 0;
  const bool alike = whole.items == items && whole.wanted.are_all() && !whole.fast_room &&
                     !whole.sizes && whole.loads == first_loads + change * (whole.steps - 1);
  // Shares of equal numbers of steps, unless steps differ: then shares whose loads are even.
  constexpr std::uint64_t most_steps_cut = 10'000'000;
  std::vector<std::uint64_t> counts;
  std::optional<StepSizes> sizes;
  if (!alike && whole.steps <= most_steps_cut) {
    sizes.emplace(order, items);
    counts =
        whole.fast_room || whole.sizes
            ? StepSizes(order, items, weights_of(whole), whole.sizes.get()).best_shares(workers)
            : sizes->best_shares(workers);
    counts.resize(static_cast<std::size_t>(workers), 0);
    cut.by_loads = workers > 1;
  } else {
    counts = equal_shares(whole.steps, workers,
                          even_pairs && alike ? steps_ahead(whole.room, change) : 0);
  }
  const auto relay = std::make_shared<OrderRelay>();
  std::uint64_t next = 1;
  for (std::uint64_t w = 0; w < workers; ++w) {
    WorkerFacts& worker = cut.workers.emplace_back();
    worker.steps = counts[static_cast<std::size_t>(w)];
    worker.first_step = worker.steps > 0 ? next : 0;
    next += worker.steps;
    if (worker.steps > 0 && alike) {
      worker.loads = first_loads + change * (worker.steps - 1);
    } else if (worker.steps > 0 && sizes) {
      worker.loads = sizes->loads(worker.first_step - 1, worker.steps);
    } else if (worker.steps > 0) {
      const auto stretch = stretch_steps(relay, order, worker.first_step, worker.steps, items, w);
      for (Step step; stretch->next(step);) {
        stop_if_asked();
        worker.loads += step.load.size();
      }
    }
  }
  return cut;
}

}  // namespace changeover
