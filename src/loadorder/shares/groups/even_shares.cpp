#include "loadorder/shares/groups/even_shares.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "loadorder/shares/groups/changing_shares.hpp"
#include "loadorder/shares/groups/idle_workers.hpp"
#include "loadorder/shares/owners/group_owners.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

/// Shares that are right, and stay so. Some workers are full: pairs that only full workers have
/// cannot be given away, so they should be few.
class EvenShares final : public ChangingShares {
 public:
  EvenShares(const GroupShares& shares, const ItemGroups& groups, std::uint64_t room,
             std::uint64_t makespan, Random& random)
      : ChangingShares(groups, room, makespan),
        random_(random),
        is_full_(shares.workers.size(), false),
        cells_(static_cast<std::size_t>(groups.groups * groups.groups)) {
    for (std::uint64_t g = 0; g < groups.groups; ++g) {
      for (std::uint64_t h = 0; h <= g; ++h) {
        Cell& cell = cell_of(static_cast<Element>(g), static_cast<Element>(h));
        cell.pairs = g == h ? binomial(groups.size(g), 2) : groups.size(g) * groups.size(h);
        missing_ += cell.pairs > 0 ? 1 : 0;
        stuck_ += cell.pairs;
      }
    }
    for (const GroupShare& share : shares.workers) {
      add(share_of(share));
    }
  }

  /// Workers with so many pairs or more are full.
  void set_full(const std::vector<std::uint64_t>& pairs, std::uint64_t full) {
    for (std::size_t w = 0; w < is_full_.size(); ++w) {
      is_full_[w] = pairs[w] >= full;
    }
    for (Cell& cell : cells_) {
      cell.others = 0;
    }
    const std::vector<GroupShare> all = result();
    for (std::size_t w = 0; w < all.size(); ++w) {
      if (is_full_[w]) {
        continue;
      }
      const GroupShare& share = all[w];
      for (std::size_t i = 0; i < share.held.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          ++cell_of(share.held[i], share.held[j]).others;
        }
        for (const Element streamed : share.streamed) {
          ++cell_of(share.held[i], streamed).others;
        }
      }
    }
    stuck_ = 0;
    for (const Cell& cell : cells_) {
      stuck_ += cell.others == 0 ? cell.pairs : 0;
    }
  }

  /// Moves may make it worse by a few pairs of groups at first.
  void improve(std::uint64_t moves) {
    const std::uint64_t cell = groups_.items * groups_.items / (groups_.groups * groups_.groups);
    const std::uint64_t heat = 2 * cell;
    std::uint64_t stuck = stuck_;
    try_exchanges(moves, random_, [&](std::uint64_t i) {
      const auto worse = static_cast<std::uint32_t>(heat * (moves - i) / moves);
      const bool keeps = missing_ == 0 && stuck_ <= stuck + random_.below(worse + 1);
      stuck = keeps ? stuck_ : stuck;
      return keeps;
    });
  }

 private:
  struct Cell {
    std::uint64_t pairs = 0;
    std::uint32_t workers = 0;  // that have it
    std::uint32_t others = 0;   // of these, not full
  };

  [[nodiscard]] Cell& cell_of(Element group, Element other) {
    return cells_[static_cast<std::size_t>(std::max(group, other) * groups_.groups +
                                           std::min(group, other))];
  }

  // As it is, with what else fits, streamed.
  [[nodiscard]] Share share_of(const GroupShare& from) {
    Share share;
    share.order = from.held;
    share.order.insert(share.order.end(), from.streamed.begin(), from.streamed.end());
    share.held = from.held.size();
    share.streamed = from.streamed.size();
    std::vector<bool> is_there(static_cast<std::size_t>(groups_.groups), false);
    for (const Element group : share.order) {
      is_there[group] = true;
    }
    std::vector<Element> rest;
    for (Element group = 0; group < groups_.groups; ++group) {
      if (!is_there[group]) {
        rest.push_back(group);
      }
    }
    for (std::size_t i = rest.size(); i > 1; --i) {
      std::swap(rest[i - 1], rest[random_.below(static_cast<std::uint32_t>(i))]);
    }
    std::uint64_t items = groups_.size(share.order);
    const bool has_place = groups_.size(from.held) < room_;
    for (const Element group : rest) {
      share.order.push_back(group);
      const std::uint64_t size = groups_.size(group);
      if (has_place && share.order.size() == share.size() + 1 && items + size <= makespan_) {
        ++share.streamed;
        items += size;
      }
    }
    return share;
  }

  void meet(std::size_t of, Element group, Element other, int by) override {
    Cell& cell = cell_of(group, other);
    const auto change = [by](std::uint32_t& count) {
      count += static_cast<std::uint32_t>(by);
      return count == (by > 0 ? 1U : 0U);  // first one, or none left
    };
    if (change(cell.workers) && cell.pairs > 0) {
      missing_ = by > 0 ? missing_ - 1 : missing_ + 1;
    }
    if (!is_full_[of] && change(cell.others)) {
      stuck_ = by > 0 ? stuck_ - cell.pairs : stuck_ + cell.pairs;
    }
  }

  Random& random_;
  std::vector<bool> is_full_;
  std::vector<Cell> cells_;
  std::uint64_t missing_ = 0;  // pairs of groups that no worker has
  std::uint64_t stuck_ = 0;    // pairs that only full workers have, or none
};

}  // namespace

GroupShares with_even_pairs(GroupShares shares, std::uint64_t items, std::uint64_t room,
                            std::uint64_t makespan) {
  constexpr std::uint64_t most_groups = 240;
  constexpr std::uint64_t most_looks = 20'000'000;  // at a pair of groups: some tenths of a second
  constexpr int rounds = 12;
  std::uint64_t best_pairs = pairs_of_the_fullest(shares, items);
  GroupShares best = shares;
  const std::uint64_t workers = shares.workers.size();
  const std::uint64_t mean = items * (items - 1) / 2 / workers;
  const std::uint64_t parts =
      std::max<std::uint64_t>(1, std::min(most_groups, items) / shares.groups);
  refine(shares, parts);
  const ItemGroups groups{items, shares.groups};
  std::uint64_t at_workers = 0;
  for (const GroupShare& share : shares.workers) {
    at_workers += share.held.size() + share.streamed.size();
  }
  const std::uint64_t at_each = std::max<std::uint64_t>(1, ceil_div(at_workers, workers));
  const std::uint64_t moves = most_looks / rounds / (4 * at_each);
  Random random(1);
  EvenShares search(shares, groups, room, makespan, random);
  for (int round = 0; round < rounds && 50 * best_pairs > 51 * mean; ++round) {
    shares.workers = search.result();
    const auto owners = owners_of(shares, items, 1e-4);
    const std::uint64_t pairs = *std::ranges::max_element(owners->pairs());
    if (pairs < best_pairs) {
      best_pairs = pairs;
      best = shares;
      best.plane_order = 0;
    }
    search.set_full(owners->pairs(), pairs - (pairs - std::min(mean, pairs)) / 4);
    search.improve(moves);
    stop_if_asked();
  }
  return best;
}

}  // namespace changeover
