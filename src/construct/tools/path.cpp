#include "construct/tools/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t unreached = std::numeric_limits<std::uint64_t>::max();

}  // namespace

Distances::Distances(std::uint64_t k, std::uint64_t change, std::uint64_t v)
    : k_(k), change_(change), v_(v) {
  if (v < k || change < 1 || change > k) {
    return;
  }
  const std::uint64_t farthest = std::min(k, v - k);
  steps_.assign(static_cast<std::size_t>(farthest) + 1, unreached);
  // unseen[d] leads to the least distance from d on that was not reached, farthest + 1 if there is
  // none.
  std::vector<std::uint64_t> unseen(static_cast<std::size_t>(farthest) + 2);
  std::iota(unseen.begin(), unseen.end(), std::uint64_t{0});
  const auto first_unseen = [&unseen](std::uint64_t d) {
    while (unseen[static_cast<std::size_t>(d)] != d) {
      std::uint64_t& next = unseen[static_cast<std::size_t>(d)];
      next = unseen[static_cast<std::size_t>(next)];
      d = next;
    }
    return d;
  };
  const auto reach = [&](std::uint64_t d, std::uint64_t steps) {
    steps_[static_cast<std::size_t>(d)] = steps;
    unseen[static_cast<std::size_t>(d)] = d + 1;
  };
  reach(0, 0);
  // A step can be made backwards, so distances are reached from 0 outwards.
  std::vector<std::uint64_t> frontier{0};
  for (std::uint64_t count = 1; !frontier.empty(); ++count) {
    std::vector<std::uint64_t> next;
    for (const std::uint64_t d : frontier) {
      const auto [a, h] = moves_at(d, k, change, v);
      if (a.empty() || h.empty()) {
        continue;
      }
      const std::uint64_t last = std::min(farthest, d - a.low + h.high);
      for (std::uint64_t to = first_unseen(d - a.high + h.low); to <= last; to = first_unseen(to)) {
        reach(to, count);
        next.push_back(to);
      }
    }
    frontier = std::move(next);
  }
}

std::optional<std::uint64_t> Distances::steps(std::uint64_t distance) const {
  if (distance >= steps_.size() || steps_[static_cast<std::size_t>(distance)] == unreached) {
    return std::nullopt;
  }
  return steps_[static_cast<std::size_t>(distance)];
}

Way::Way(std::shared_ptr<const Distances> distances, Block from, Block to)
    : distances_(std::move(distances)), here_(std::move(from)), to_(std::move(to)) {
  const auto v = static_cast<std::size_t>(distances_->v());
  is_here_.assign(v, false);
  is_goal_.assign(v, false);
  for (const Element x : here_) {
    is_here_[x] = true;
  }
  std::uint64_t distance = to_.size();
  for (const Element x : to_) {
    is_goal_[x] = true;
    distance -= is_here_[x] ? 1U : 0U;
  }
  const std::optional<std::uint64_t> steps = distances_->steps(distance);
  if (!steps || distance == 0) {
    throw ImpossibleParameters(
        fmt::format("no way from a block to another by changes of {} for v = {}, k = {}",
                    distances_->change(), distances_->v(), distances_->k()));
  }
  left_ = *steps - 1;
}

bool Way::next(std::span<Element> block) {
  if (left_ == 0) {
    return false;
  }
  const std::uint64_t m = distances_->change();
  const auto d = static_cast<std::uint64_t>(
      std::ranges::count_if(here_, [this](Element x) { return !is_goal_[x]; }));
  // The first of the moves that come nearer: few wrong elements go, few others come.
  const auto [a_range, h_range] = moves_at(d, distances_->k(), m, distances_->v());
  std::uint64_t a = a_range.low;
  std::uint64_t h = h_range.low;
  for (bool found = false; !found;) {
    if (distances_->steps(d - a + h) == left_) {
      found = true;
    } else if (h < h_range.high) {
      ++h;
    } else {
      h = h_range.low;
      if (++a > a_range.high) {
        throw InternalError("a distance from which no step leads on was reached");
      }
    }
  }
  take_step(a, h);
  --left_;
  std::ranges::copy(here_, block.begin());
  return true;
}

void Way::take_step(std::uint64_t wrong_going, std::uint64_t others_coming) {
  const std::uint64_t m = distances_->change();
  Block coming;
  for (std::size_t i = 0; coming.size() < m - others_coming; ++i) {
    if (!is_here_[to_[i]]) {
      coming.push_back(to_[i]);
    }
  }
  for (Element x = 0; coming.size() < m; ++x) {
    if (!is_here_[x] && !is_goal_[x]) {
      coming.push_back(x);
    }
  }
  std::uint64_t right_going = m - wrong_going;
  std::size_t kept = 0;
  for (const Element x : here_) {
    std::uint64_t& going = is_goal_[x] ? right_going : wrong_going;
    if (going > 0) {
      --going;
      is_here_[x] = false;
    } else {
      here_[kept++] = x;
    }
  }
  for (const Element x : coming) {
    here_[kept++] = x;
    is_here_[x] = true;
  }
}

std::optional<std::uint64_t> connecting_steps(std::uint64_t distance, std::uint64_t k,
                                              std::uint64_t change, std::uint64_t v) {
  return Distances(k, change, v).steps(distance);
}

std::vector<Block> connecting_blocks(const Block& from, const Block& to, std::uint64_t change,
                                     std::uint64_t v) {
  Way way(std::make_shared<const Distances>(from.size(), change, v), from, to);
  std::vector<Block> between;
  for (Block block(from.size()); way.next(block);) {
    between.push_back(block);
  }
  return between;
}

}  // namespace changeover
