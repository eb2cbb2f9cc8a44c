#include "loadorder/shares/groups/changing_shares.hpp"

#include <algorithm>
#include <utility>

namespace changeover {
namespace {

// 0 held, 1 streamed, 2 not there
std::size_t part_of(std::size_t held, std::size_t all, std::size_t at) {
  return at < held ? 0 : at < all ? 1 : 2;
}

}  // namespace

std::vector<GroupShare> ChangingShares::result() const {
  std::vector<GroupShare> all;
  for (const Share& share : shares_) {
    const auto middle = share.order.begin() + static_cast<std::ptrdiff_t>(share.held);
    GroupShare one{{share.order.begin(), middle},
                   {middle, middle + static_cast<std::ptrdiff_t>(share.streamed)}};
    std::ranges::sort(one.held);
    std::ranges::sort(one.streamed);
    all.push_back(std::move(one));
  }
  return all;
}

void ChangingShares::add(Share share) {
  share.held_items = share.all_items = 0;
  for (std::size_t at = 0; at < share.size(); ++at) {
    const std::uint64_t size = groups_.size(share.order[at]);
    share.held_items += at < share.held ? size : 0;
    share.all_items += size;
  }
  shares_.push_back(std::move(share));
  const Share& last = shares_.back();
  for (std::size_t i = 0; i < last.held; ++i) {
    for (std::size_t j = i; j < last.size(); ++j) {
      meet(shares_.size() - 1, last.order[i], last.order[j], 1);
    }
  }
}

bool ChangingShares::can_exchange(std::size_t of, std::size_t a, std::size_t b) const {
  const Share& share = shares_[of];
  const std::size_t part_a = part_of(share.held, share.size(), a);
  const std::size_t part_b = part_of(share.held, share.size(), b);
  if (part_a == part_b) {
    return false;
  }
  const std::uint64_t size_a = groups_.size(share.order[a]);
  const std::uint64_t size_b = groups_.size(share.order[b]);
  const auto after = [&](std::uint64_t before, std::size_t parts) {
    const std::uint64_t come = (part_a <= parts ? size_b : 0) + (part_b <= parts ? size_a : 0);
    const std::uint64_t go = (part_a <= parts ? size_a : 0) + (part_b <= parts ? size_b : 0);
    return before + come - go;
  };
  return after(share.held_items, 0) + (share.streamed > 0 ? 1 : 0) <= room_ &&
         after(share.all_items, 1) <= makespan_;
}

// Tells what meets because of one position.
void ChangingShares::place(std::size_t of, std::size_t at, std::size_t besides, int by) {
  const Share& share = shares_[of];
  const std::size_t part = part_of(share.held, share.size(), at);
  const std::size_t end = part == 0 ? share.size() : part == 1 ? share.held : 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (i != besides && (i != at || part == 0)) {
      meet(of, share.order[at], share.order[i], by);
    }
  }
}

void ChangingShares::exchange(std::size_t of, std::size_t a, std::size_t b) {
  Share& share = shares_[of];
  const auto count = [&](bool adds) {
    for (const std::size_t at : {a, b}) {
      const std::uint64_t size = groups_.size(share.order[at]);
      const std::size_t part = part_of(share.held, share.size(), at);
      share.held_items += part == 0 ? (adds ? size : 0 - size) : 0;
      share.all_items += part <= 1 ? (adds ? size : 0 - size) : 0;
    }
  };
  count(false);
  place(of, a, b, -1);
  place(of, b, a, -1);
  std::swap(share.order[a], share.order[b]);
  place(of, a, b, 1);
  place(of, b, a, 1);
  count(true);
}

}  // namespace changeover
