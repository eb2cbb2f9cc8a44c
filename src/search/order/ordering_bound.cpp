#include "search/order/ordering_bound.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"

namespace changeover {
namespace {

constexpr std::int64_t scale =
    1024;  // multipliers are whole 1024ths, so that rounding has no influence
constexpr int most_rounds = 400;
constexpr std::int64_t infinite = std::numeric_limits<std::int64_t>::max() / 4;

/// An order is a cycle through the blocks and, if it is linear, one more vertex between the last
/// and the first. A 1-tree (a spanning tree of all vertices but one, and two edges at that one) is
/// no longer than any cycle. This also holds if every edge at a vertex costs π more, and the sum of
/// 2π is subtracted again [HeldKarp1970]. Edges cost −|A∩B|; those of the extra vertex cost 0, or
/// −|A| on one side if the first block is free.
class OneTrees {
 public:
  OneTrees(const Overlaps& overlaps, const LeastChangeWanted& wanted)
      : overlaps_(overlaps),
        n_(overlaps.count()),
        linear_(wanted.kind == Kind::linear),
        first_free_(!wanted.first_counts),
        multipliers_(n_, 0),
        degrees_(n_, 0) {}

  // The bound in 1024ths of −(overlaps in an order, and the first block if it is free).
  std::int64_t round() {
    std::ranges::fill(degrees_, 0);
    // The vertex outside the tree: the extra one, or block 0.
    const std::size_t begin = linear_ ? 0 : 1;
    std::int64_t length = tree(begin);
    std::size_t one = 0;
    std::size_t two = 0;
    if (linear_) {
      // Edges to two different blocks, a first and a last one.
      const auto to_first = [&](std::size_t i) {
        return multipliers_[i] - (first_free_ ? scale * std::int64_t{overlaps_.size(i)} : 0);
      };
      const auto to_last = [&](std::size_t i) { return multipliers_[i]; };
      one = cheapest(to_first, n_);
      two = cheapest(to_last, one);
      const std::size_t last = cheapest(to_last, n_);
      const std::size_t first = cheapest(to_first, last);
      if (to_first(first) + to_last(last) < to_first(one) + to_last(two)) {
        one = first;
        two = last;
      }
      length += to_first(one) + to_last(two);
    } else {
      const auto to_zero = [&](std::size_t i) {
        return i == 0 ? infinite
                      : multipliers_[0] + multipliers_[i] - scale * std::int64_t{overlaps_(0, i)};
      };
      one = cheapest(to_zero, n_);
      two = cheapest(to_zero, one);
      length += to_zero(one) + to_zero(two);
      degrees_[0] = 2;
    }
    ++degrees_[one];
    ++degrees_[two];
    for (const std::int64_t multiplier : multipliers_) {
      length -= 2 * multiplier;
    }
    return length;
  }

  // Moves the multipliers towards a tree in which every vertex has two edges, by a step for a gap
  // of `gap` 1024ths. Returns false if the last tree is a cycle.
  bool adjust(std::int64_t gap) {
    const std::int64_t wrong = sum_of<std::int64_t>(
        degrees_, [&](const std::int64_t degree) { return (degree - 2) * (degree - 2); });
    if (wrong == 0) {
      return false;
    }
    const std::int64_t step = std::max<std::int64_t>(1, gap / wrong);
    for (std::size_t i = 0; i < n_; ++i) {
      multipliers_[i] += step * (degrees_[i] - 2);
    }
    return true;
  }

 private:
  template <typename Cost>
  std::size_t cheapest(Cost&& cost, std::size_t except) const {
    std::size_t best = n_;
    for (std::size_t i = 0; i < n_; ++i) {
      if (i != except && (best == n_ || cost(i) < cost(best))) {
        best = i;
      }
    }
    return best;
  }

  // The length of a minimum spanning tree of the blocks from `begin` on, by Prim's algorithm.
  std::int64_t tree(std::size_t begin) {
    struct Open {
      std::uint32_t block;
      std::uint32_t beside;
      std::int64_t cost;
    };
    std::vector<Open> open;
    for (std::size_t i = begin + 1; i < n_; ++i) {
      open.push_back({static_cast<std::uint32_t>(i), 0, infinite});
    }
    std::size_t newest = begin;
    std::int64_t length = 0;
    while (!open.empty()) {
      stop_if_asked();
      std::size_t best = 0;
      for (std::size_t at = 0; at < open.size(); ++at) {
        Open& each = open[at];
        const std::int64_t cost = multipliers_[newest] + multipliers_[each.block] -
                                  scale * std::int64_t{overlaps_(newest, each.block)};
        if (cost < each.cost) {
          each.cost = cost;
          each.beside = static_cast<std::uint32_t>(newest);
        }
        if (each.cost < open[best].cost) {
          best = at;
        }
      }
      length += open[best].cost;
      newest = open[best].block;
      ++degrees_[newest];
      ++degrees_[open[best].beside];
      open[best] = open.back();
      open.pop_back();
    }
    return length;
  }

  const Overlaps& overlaps_;
  std::size_t n_;
  bool linear_;
  bool first_free_;
  std::vector<std::int64_t> multipliers_;  // in 1024ths
  std::vector<std::int64_t> degrees_;      // in the last tree
};

// Every element is introduced somewhere, except those of a free first block and, in a circular
// order, those in every block.
std::uint64_t element_bound(std::span<const Block> blocks, const LeastChangeWanted& wanted) {
  std::vector<std::uint32_t> in_blocks(static_cast<std::size_t>(wanted.v), 0);
  std::size_t largest = 0;
  for (const Block& block : blocks) {
    largest = std::max(largest, block.size());
    for (const Element x : block) {
      ++in_blocks[x];
    }
  }
  std::uint64_t bound = sum_of(in_blocks, [&](const std::uint32_t count) {
    return count > 0 && (wanted.kind == Kind::linear || count < blocks.size()) ? 1U : 0U;
  });
  if (wanted.kind == Kind::linear && !wanted.first_counts) {
    bound -= largest;
  }
  return bound;
}

}  // namespace

std::uint64_t order_lower_bound(std::span<const Block> blocks, const Overlaps& overlaps,
                                const LeastChangeWanted& wanted, std::uint64_t cost,
                                std::uint64_t effort, RunControl& control) {
  std::uint64_t bound = element_bound(blocks, wanted);
  const std::uint64_t n = blocks.size();
  const std::uint64_t a_round = checked_multiply(n * n / 2, overlaps.words());
  if (n < 4 || a_round / 10 > effort) {
    return bound;
  }
  std::int64_t sizes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sizes += overlaps.size(i);
  }
  OneTrees trees(overlaps, wanted);
  const std::uint64_t rounds = std::clamp<std::uint64_t>(effort / a_round, 1, most_rounds);
  const auto longest =
      static_cast<std::int64_t>(cost) - sizes;  // of that order, in the units of the trees
  std::int64_t best = -infinite;
  std::int64_t share = 2 * scale;  // part of the gap that a step tries to close, in 1024ths
  std::uint64_t since = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    std::int64_t length = 0;
    try {
      length = trees.round();
    } catch (const Stopped&) {
      break;
    }
    since = length > best ? 0 : since + 1;
    best = std::max(best, length);
    const std::int64_t in_whole = best >= 0 ? (best + scale - 1) / scale : -(-best / scale);
    bound =
        std::max(bound, static_cast<std::uint64_t>(std::max<std::int64_t>(0, sizes + in_whole)));
    if (since == 10) {
      since = 0;
      share /= 2;
    }
    const std::int64_t gap = longest * scale - length;
    if (bound >= cost || control.stop_wanted() || share == 0 ||
        !trees.adjust(gap / scale * share + gap % scale * share / scale)) {
      break;
    }
  }
  return std::min(bound, cost);
}

}  // namespace changeover
