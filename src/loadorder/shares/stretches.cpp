#include "loadorder/shares/stretches.hpp"

#include <algorithm>
#include <utility>

#include "changeover/run/control.hpp"
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

StepSizes::StepSizes(const LoadOrder& order, std::uint64_t items, std::uint64_t load,
                     std::uint64_t transfer) {
  const LoadOrderFacts& whole = order.facts();
  const auto size = [&](const std::vector<Element>& groups, const std::vector<Element>& fast) {
    std::uint64_t sum = 0;
    for (const Element group : groups) {
      sum += (group + std::uint64_t{1}) * items / whole.items - group * items / whole.items;
    }
    return sum * load + fast.size() * transfer;
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

// The most steps from `first` on with at most so many loads.
std::uint64_t StepSizes::fitting(std::uint64_t first, std::uint64_t most) const {
  if (held_[first] > most) {
    return 0;
  }
  const auto begin = loaded_.begin() + static_cast<std::ptrdiff_t>(first + 1);
  const std::uint64_t left = most - held_[first] + *begin;
  return static_cast<std::uint64_t>(std::upper_bound(begin, loaded_.end(), left) - begin);
}

// As many shares as needed, so that none has more than `most` loads; nothing if a step alone has
// more.
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
  std::uint64_t low = 1;
  std::uint64_t high = loaded_.back();
  const auto fits = [&](const std::vector<std::uint64_t>& counts) {
    return !counts.empty() && counts.size() <= workers;
  };
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    fits(shares(middle)) ? high = middle : low = middle + 1;
  }
  return shares(high);
}

}  // namespace changeover
