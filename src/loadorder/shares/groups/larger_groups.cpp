#include "loadorder/shares/groups/larger_groups.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/checked.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

/// Which groups have an item more than the others, and what workers load then.
class LargerGroups {
 public:
  LargerGroups(const GroupShares& shares, std::uint64_t items, std::uint64_t room)
      : is_large_(static_cast<std::size_t>(shares.groups), false),
        has_(is_large_.size()),
        workers_(shares.workers.size()) {
    const ItemGroups groups{items, shares.groups};
    const std::uint64_t small = items / shares.groups;
    for (std::size_t g = 0; g < is_large_.size(); ++g) {
      is_large_[g] = groups.size(g) > small;
      (is_large_[g] ? large_ : small_).push_back(static_cast<Element>(g));
    }
    std::uint64_t all = 0;
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      const GroupShare& share = shares.workers[w];
      for (const Element g : share.held) {
        has_[g].push_back({static_cast<std::uint32_t>(w), true});
      }
      for (const Element g : share.streamed) {
        has_[g].push_back({static_cast<std::uint32_t>(w), false});
      }
      Worker& its = workers_[w];
      its.held = groups.size(share.held);
      its.loads = its.held + groups.size(share.streamed);
      its.room = room - (share.streamed.empty() ? 0 : 1);
      all += its.loads;
    }
    // The mean changes with the numbers where some groups have more workers than others: nearly.
    mean_ = ceil_div(all, workers_.size());
    for (const Worker& worker : workers_) {
      cost_ += cost_of(worker);
    }
  }

  [[nodiscard]] bool are_alike() const { return large_.empty(); }

  /// Whether no worker has more than the mean, and all fit.
  [[nodiscard]] bool is_best() const {
    return std::ranges::all_of(workers_, [&](const Worker& worker) {
      return worker.loads <= mean_ && worker.held <= worker.room;
    });
  }

  /// Items beyond the room, then the loads of the busiest worker.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> busiest() const {
    std::pair<std::uint64_t, std::uint64_t> most;
    for (const Worker& worker : workers_) {
      most.first = std::max(most.first, worker.held - std::min(worker.held, worker.room));
      most.second = std::max(most.second, worker.loads);
    }
    return most;
  }

  void exchange(std::size_t large, std::size_t small) {
    change(large_[large], -1);
    change(small_[small], 1);
    std::swap(large_[large], small_[small]);
  }

  [[nodiscard]] std::size_t large() const { return large_.size(); }
  [[nodiscard]] std::size_t small() const { return small_.size(); }
  [[nodiscard]] double cost() const { return cost_; }
  [[nodiscard]] const std::vector<bool>& is_large() const { return is_large_; }

 private:
  struct Worker {
    std::uint64_t held = 0;
    std::uint64_t loads = 0;
    std::uint64_t room = 0;  // for what is held
  };
  struct Share {
    std::uint32_t worker = 0;
    bool is_held = false;
  };

  // An item more at a busy worker counts more than all that others may have less.
  [[nodiscard]] double cost_of(const Worker& worker) const {
    constexpr int least = -3;
    constexpr int most = 8;
    constexpr double too_much = 1 << 26;  // sums are exact: some 50 bits
    const auto over = static_cast<std::int64_t>(worker.loads - mean_);
    const int eights = static_cast<int>(std::clamp<std::int64_t>(over, least, most));
    const std::uint64_t beyond = worker.held - std::min(worker.held, worker.room);
    return std::ldexp(1, 3 * eights) + too_much * static_cast<double>(beyond);
  }

  void change(Element group, int by) {
    for (const Share& share : has_[group]) {
      Worker& worker = workers_[share.worker];
      cost_ -= cost_of(worker);
      worker.loads += static_cast<std::uint64_t>(by);
      worker.held += share.is_held ? static_cast<std::uint64_t>(by) : 0;
      cost_ += cost_of(worker);
    }
    is_large_[group] = by > 0;
  }

  std::vector<bool> is_large_;
  std::vector<Element> large_, small_;
  std::vector<std::vector<Share>> has_;  // by group
  std::vector<Worker> workers_;
  std::uint64_t mean_ = 0;
  double cost_ = 0;
};

// New numbers: groups of the required sizes.
std::vector<Element> numbers_of(const std::vector<bool>& is_large, const ItemGroups& groups) {
  std::vector<Element> free[2];
  const std::uint64_t small = groups.items / groups.groups;
  for (std::uint64_t g = groups.groups; g-- > 0;) {
    free[groups.size(g) > small ? 1 : 0].push_back(static_cast<Element>(g));
  }
  std::vector<Element> numbers;
  for (const bool large : is_large) {
    std::vector<Element>& of = free[large ? 1 : 0];
    numbers.push_back(of.back());
    of.pop_back();
  }
  return numbers;
}

}  // namespace

GroupShares with_larger_spread(GroupShares shares, std::uint64_t items, std::uint64_t room) {
  constexpr std::uint64_t most_groups = 600;
  constexpr std::uint64_t most_changes = 300'000;  // of a worker
  if (shares.groups > most_groups || shares.workers.empty()) {
    return shares;
  }
  LargerGroups larger(shares, items, room);
  if (larger.are_alike() || larger.is_best()) {
    return shares;
  }
  const auto before = larger.busiest();
  std::uint64_t at_workers = 0;
  for (const GroupShare& share : shares.workers) {
    at_workers += share.held.size() + share.streamed.size();
  }
  const std::uint64_t tries = most_changes / (2 * ceil_div(at_workers, shares.groups) + 1);
  Random random(1);
  double cost = larger.cost();
  for (std::uint64_t i = 0; i < tries && (i % 64 != 0 || !larger.is_best()); ++i) {
    const std::size_t large = random.below(static_cast<std::uint32_t>(larger.large()));
    const std::size_t small = random.below(static_cast<std::uint32_t>(larger.small()));
    larger.exchange(large, small);
    if (larger.cost() <= cost) {
      cost = larger.cost();
    } else {
      larger.exchange(large, small);
    }
  }
  if (larger.busiest() >= before) {
    return shares;
  }
  const std::vector<Element> numbers = numbers_of(larger.is_large(), {items, shares.groups});
  for (GroupShare& share : shares.workers) {
    for (std::vector<Element>* const list : {&share.held, &share.streamed}) {
      for (Element& group : *list) {
        group = numbers[group];
      }
      std::ranges::sort(*list);
    }
  }
  shares.plane_order = 0;  // lines are no longer those of the plane as it is numbered
  return shares;
}

}  // namespace changeover
