#include "loadorder/order/lockstep/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/levels/group_levels.hpp"
#include "loadorder/order/lockstep/check_disjoint.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/shares/few_workers.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

class LockstepLevels final : public StepSource {
 public:
  LockstepLevels(const LevelShape& shape, std::unique_ptr<StepSource> groups, std::size_t workers,
                 const std::shared_ptr<InnerOrders>& inner_orders)
      : assigner_(shape.groups(), shape.group_room(), shape.wanted_groups(), workers, false,
                  nullptr, shape.sizes),
        groups_(workers),
        steps_(workers) {
    workers_.reserve(workers);
    for (std::size_t w = 0; w < workers; ++w) {
      workers_.emplace_back(shape, inner_orders);
    }
    assigner_.start(std::move(groups));
  }

  bool next(Step& step) override {
    while (at_ == most_) {
      if (!assigner_.next_round(groups_)) {
        return false;
      }
      take_round();
    }
    const std::vector<Step>& its = steps_[worker_];
    step = at_ < its.size() ? its[at_] : Step{};
    step.number = number_;
    step.worker = worker_;
    if (++worker_ == workers_.size()) {
      worker_ = 0;
      ++at_;
      ++number_;
    }
    return true;
  }

 private:
  void take_round() {
    at_ = most_ = 0;
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      workers_[w].take(groups_[w]);
      steps_[w].clear();
      for (Step step; workers_[w].next(step);) {
        steps_[w].push_back(step);
      }
      most_ = std::max(most_, steps_[w].size());
    }
  }

  PairAssigner assigner_;
  std::vector<AssignedStep> groups_;  // by worker: its step in the order of groups
  std::vector<LevelWorker> workers_;
  std::vector<std::vector<Step>> steps_;  // by worker: what that step takes
  std::size_t most_ = 0;                  // of one worker
  std::size_t at_ = 0;
  std::size_t worker_ = 0;
  std::uint64_t number_ = 1;
};

// Sizes of groups whose orders do not take too long to make.
std::vector<std::uint64_t> group_sizes(const WantedPairs& wanted, std::uint64_t room,
                                       std::uint64_t fast_room) {
  if (wanted.graph() != nullptr) {
    return {1};
  }
  constexpr std::size_t most_tried = 6;
  constexpr std::uint64_t most_pairs = 1'000'000;  // of groups, listed
  std::vector<std::uint64_t> sizes = sizes_to_try(wanted.items(), room, fast_room);
  std::erase_if(sizes, [&](std::uint64_t size) {
    return !wanted.are_all() &&
           LevelShape{wanted, room, fast_room, size}.wanted_groups().count() > most_pairs;
  });
  sizes.resize(std::min(sizes.size(), most_tried));
  return sizes.empty() ? std::vector<std::uint64_t>{1} : sizes;
}

}  // namespace

std::unique_ptr<StepSource> levels_in_lockstep(const LevelShape& shape,
                                               std::unique_ptr<StepSource> groups,
                                               std::uint64_t workers,
                                               const std::shared_ptr<InnerOrders>& inner_orders) {
  return std::make_unique<LockstepLevels>(shape, std::move(groups),
                                          static_cast<std::size_t>(workers), inner_orders);
}

LevelSpans spans_of(StepSource& steps, std::uint64_t workers, const ItemSizes* sizes) {
  LevelSpans spans;
  LevelSpans slowest;
  const auto moved = [&](const std::vector<Element>& items) {
    return sizes != nullptr ? bytes_of(*sizes, items) : items.size();
  };
  for (Step step; steps.next(step);) {
    slowest.loads = std::max(slowest.loads, moved(step.load));
    slowest.transfers = std::max(slowest.transfers, moved(step.fast_load));
    if (step.worker + 1 == workers) {
      spans.loads += std::exchange(slowest.loads, 0);
      spans.transfers += std::exchange(slowest.transfers, 0);
    }
  }
  return spans;
}

namespace {

/// An order in lockstep for groups, and what each of its steps is on the accelerators.
struct BestGroups {
  double cost = std::numeric_limits<double>::max();
  std::uint64_t group_items = 0;
  LoadOrder::Maker maker = {};
  std::string method = {};
  std::string explanation = {};
};

BestGroups best_groups(const LoadOrderFacts& facts, const WantedPairs& wanted,
                       const LoadOrderOptions& options) {
  const std::uint64_t fast_room = *facts.fast_room;
  const std::uint64_t workers = facts.lockstep;
  const std::uint64_t least_transfers = makespan_lower_bound(wanted, fast_room, workers).loads;
  const auto inner = std::make_shared<InnerOrders>(fast_room);
  BestGroups best;
  for (const std::uint64_t size : group_sizes(wanted, facts.room, fast_room)) {
    if (best.maker && must_hurry()) {
      break;
    }
    const LevelShape shape{wanted, facts.room, fast_room, size};
    const auto groups = std::make_shared<const LoadOrder>(
        plan_disjoint_order(shape.wanted_groups(), shape.group_room(), workers, options));
    LoadOrder::Maker its = [shape, groups, workers, inner] {
      return levels_in_lockstep(shape, groups->stream(), workers, inner);
    };
    const double cost = spans_of(*its(), workers).over(facts.makespan_bound.loads, least_transfers);
    if (cost < best.cost) {
      const bool is_list = wanted.graph() != nullptr;
      best = {cost, is_list ? 0 : size, std::move(its), groups->facts().method,
              (is_list ? "What items meet is done at once. " : shape.explain() + " ") +
                  groups->facts().explanation};
    }
  }
  return best;
}

}  // namespace

LoadOrder plan_disjoint_levels(const WantedPairs& wanted, std::uint64_t room,
                               std::uint64_t fast_room, std::uint64_t workers,
                               const LoadOrderOptions& options) {
  check_workers(workers);
  check_disjoint(wanted);
  LoadOrderFacts facts = facts_before(wanted, room, fast_room);
  facts.lockstep = workers;
  facts.makespan_bound = makespan_lower_bound(wanted, room, workers);
  BestGroups best = best_in_rounds(
      options, [&](const LoadOrderOptions& its) { return best_groups(facts, wanted, its); },
      [](const BestGroups& its, const BestGroups& others) { return its.cost < others.cost; });
  facts.group_items = best.group_items;
  facts.method = std::move(best.method);
  facts.explanation = std::move(best.explanation);
  const std::string memory =
      fmt::format("for {} workers with room for {} and {}", workers, room, fast_room);
  return read_in_full(std::move(facts), std::move(best.maker), memory, [&](const auto& verdict) {
    return "no item held twice at once, " + levels_read(verdict, wanted.count(), false);
  });
}

}  // namespace changeover
