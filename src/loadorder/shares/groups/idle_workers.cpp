#include "loadorder/shares/groups/idle_workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "loadorder/shares/groups/changing_shares.hpp"
#include "loadorder/shares/owners/group_owners.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

/// Shares of idle workers, changed group by group. The objective is the number of pairs that busy
/// workers can give away, each at most what it has above the mean.
class IdleShares final : public ChangingShares {
 public:
  IdleShares(const GroupShares& busy, const ItemGroups& groups, std::uint64_t room,
             std::uint64_t makespan, std::uint64_t idle, Random& random)
      : ChangingShares(groups, room, makespan),
        owners_(owners_of(busy, groups.items, 1e-4)),
        random_(random),
        met_(static_cast<std::size_t>(groups.groups * groups.groups), 0),
        given_(busy.workers.size(), 0) {
    double mean = 0;
    for (const std::uint64_t pairs : owners_->pairs()) {
      mean += static_cast<double>(pairs);
    }
    mean /= static_cast<double>(busy.workers.size() + idle);
    // Slightly more than needed, since the pairs to give away cannot be chosen freely.
    constexpr double spare = 1.1;
    for (const std::uint64_t pairs : owners_->pairs()) {
      needed_.push_back(spare * std::max(0.0, static_cast<double>(pairs) - mean));
    }
    for (std::uint64_t i = 0; i < idle; ++i) {
      begin_share();
    }
  }

  [[nodiscard]] bool are_empty() const { return shares_.empty() || shares_[0].held == 0; }

  void improve(std::uint64_t moves) {
    double value = worth();
    try_exchanges(moves, random_, [&](std::uint64_t /*move*/) {
      const double now = worth();
      const bool keeps = now >= value;
      value = keeps ? now : value;
      return keeps;
    });
  }

 private:
  void begin_share() {
    Share share;
    share.order.resize(static_cast<std::size_t>(groups_.groups));
    for (std::size_t i = 0; i < share.order.size(); ++i) {
      const std::size_t j = random_.below(static_cast<std::uint32_t>(i + 1));
      share.order[i] = share.order[j];
      share.order[j] = static_cast<Element>(i);
    }
    const std::uint64_t streams = makespan_ > room_ ? 1 : 0;
    for (const Element group : share.order) {
      const std::uint64_t size = groups_.size(group);
      if (share.all_items + size > makespan_) {
        break;
      }
      if (share.streamed == 0 && share.held_items + size + streams <= room_) {
        ++share.held;
        share.held_items += size;
      } else {
        ++share.streamed;
      }
      share.all_items += size;
    }
    add(std::move(share));
  }

  void meet(std::size_t /*share*/, Element group, Element other, int by) override {
    const std::size_t at =
        static_cast<std::size_t>(std::max(group, other) * groups_.groups + std::min(group, other));
    const bool changes = by > 0 ? met_[at] == 0 : met_[at] == 1;
    met_[at] = static_cast<std::uint32_t>(static_cast<int>(met_[at]) + by);
    if (changes) {
      owners_->each_part(group, other, [&](std::uint32_t worker, std::uint64_t pairs) {
        given_[worker] += by * static_cast<double>(pairs);
      });
    }
  }

  [[nodiscard]] double worth() const {
    double sum = 0;
    for (std::size_t w = 0; w < given_.size(); ++w) {
      sum += std::min(given_[w], needed_[w]);
    }
    return sum;
  }

  std::shared_ptr<const GroupOwners> owners_;
  Random& random_;
  std::vector<std::uint32_t> met_;  // by pair of groups: number of idle workers that have it
  std::vector<double> given_;       // by busy worker: pairs that idle workers have, too
  std::vector<double> needed_;
};

}  // namespace

std::uint64_t pairs_of_the_fullest(const GroupShares& shares, std::uint64_t items) {
  constexpr double part = 1e-4;
  const auto owners = owners_of(shares, items, part);
  return *std::ranges::max_element(owners->pairs());
}

double unevenness(const GroupShares& shares, std::uint64_t items, std::uint64_t workers) {
  constexpr std::uint64_t most_groups = 600;
  if (shares.plane_order > 0 && (shares.workers.size() == workers || shares.groups > most_groups)) {
    return static_cast<double>(workers) / static_cast<double>(shares.workers.size());
  }
  return static_cast<double>(pairs_of_the_fullest(shares, items)) * static_cast<double>(workers) /
         (static_cast<double>(items) * static_cast<double>(items - 1) / 2);
}

GroupShares with_idle_workers(GroupShares shares, std::uint64_t items, std::uint64_t room,
                              std::uint64_t workers, std::uint64_t makespan) {
  constexpr std::uint64_t most_groups = 240;
  constexpr std::uint64_t most_parts = 4;
  constexpr std::uint64_t most_looks = 20'000'000;  // at a pair of groups: some tenths of a second
  constexpr int most_tries = 3;
  if (shares.workers.size() >= workers || shares.groups > most_groups) {
    return shares;
  }
  const std::uint64_t all_pairs = items * (items - 1) / 2;
  std::uint64_t best_pairs = pairs_of_the_fullest(shares, items);
  GroupShares best = shares;
  const std::uint64_t parts = std::clamp<std::uint64_t>(
      std::min(most_groups / shares.groups, items / shares.groups), 1, most_parts);
  refine(shares, parts);
  const ItemGroups groups{items, shares.groups};
  const std::uint64_t idle = workers - shares.workers.size();
  const std::uint64_t moves = most_looks / (2 * groups.groups + shares.workers.size());
  Random random(1);
  for (int i = 0; i < most_tries && 50 * best_pairs * workers > 51 * all_pairs; ++i) {
    IdleShares more(shares, groups, room, makespan, idle, random);
    if (more.are_empty()) {
      break;
    }
    more.improve(moves);
    GroupShares all = shares;
    for (GroupShare& share : more.result()) {
      all.workers.push_back(std::move(share));
    }
    if (const std::uint64_t pairs = pairs_of_the_fullest(all, items); pairs < best_pairs) {
      best_pairs = pairs;
      best = std::move(all);
    }
  }
  if (best.workers.size() > shares.workers.size()) {
    best.plane_order = 0;
    best.explanation += fmt::format(" {} more {} some of their pairs.", idle,
                                    idle == 1 ? "worker takes" : "workers take");
  }
  return best;
}

GroupShares with_more_held(const GroupShares& shares, std::uint64_t items, std::uint64_t room) {
  constexpr std::uint64_t most_groups = 240;
  constexpr std::uint64_t most_parts = 4;
  if (shares.groups > std::min(most_groups, items)) {
    return shares;
  }
  std::uint64_t best_pairs = pairs_of_the_fullest(shares, items);
  GroupShares best = shares;
  for (std::uint64_t parts = 1; parts <= most_parts; ++parts) {
    if (parts * shares.groups > std::min(most_groups, items)) {
      break;
    }
    GroupShares more = shares;
    refine(more, parts);
    const ItemGroups groups{items, more.groups};
    for (GroupShare& share : more.workers) {
      std::uint64_t held = groups.size(share.held);
      while (!share.streamed.empty()) {
        const std::uint64_t size = groups.size(share.streamed.front());
        const std::uint64_t passing = share.streamed.size() > 1 ? 1 : 0;
        if (held + size + passing > room) {
          break;
        }
        held += size;
        share.held.push_back(share.streamed.front());
        share.streamed.erase(share.streamed.begin());
      }
    }
    if (const std::uint64_t pairs = pairs_of_the_fullest(more, items); pairs < best_pairs) {
      best_pairs = pairs;
      best = std::move(more);
      best.plane_order = 0;
      best.explanation = shares.explanation + " What fits beside the held groups stays, too.";
    }
  }
  return best;
}

}  // namespace changeover
