// order_for_least_change: exactly for few blocks, by local search for many.
#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "run/random.hpp"
#include "search/order/ordering_bound.hpp"
#include "search/order/ordering_tour.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_exact_blocks = 20;
constexpr std::size_t fewest_for_local_search = 8;
constexpr std::uint64_t kicks_a_block = 50;

using City = std::uint32_t;
using Neighbours = std::vector<std::vector<City>>;

// The least cost for each set of blocks and its last block. O(2^b b²) time, O(2^b b) memory.
std::vector<std::size_t> least_order(const Overlaps& overlaps, const LeastChangeWanted& wanted) {
  const std::size_t n = overlaps.count();
  constexpr std::uint32_t unreached = std::numeric_limits<std::uint32_t>::max() / 2;
  const std::size_t sets = std::size_t{1} << n;
  std::vector<std::uint32_t> cost(sets * n, unreached);
  const bool circular = wanted.kind == Kind::circular;
  for (std::size_t i = 0; i < (circular ? 1 : n); ++i) {
    cost[(std::size_t{1} << i) * n + i] = !circular && wanted.first_counts ? overlaps.size(i) : 0;
  }
  const auto step = [&](std::size_t i, std::size_t j) { return overlaps.size(j) - overlaps(i, j); };
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t last = 0; last < n; ++last) {
      const std::uint32_t so_far = cost[set * n + last];
      if (so_far >= unreached) {
        continue;
      }
      for (std::size_t next = 0; next < n; ++next) {
        if ((set >> next & 1) == 0) {
          std::uint32_t& known = cost[(set | std::size_t{1} << next) * n + next];
          known = std::min(known, so_far + step(last, next));
        }
      }
    }
  }
  const auto whole = [&](std::size_t last) {
    return cost[(sets - 1) * n + last] + (circular ? step(last, 0) : 0);
  };
  std::size_t last = 0;
  for (std::size_t i = 1; i < n; ++i) {
    last = whole(i) < whole(last) ? i : last;
  }
  std::vector<std::size_t> order{last};
  for (std::size_t set = sets - 1; order.size() < n;) {
    const std::size_t before = set ^ std::size_t{1} << last;
    std::size_t previous = 0;
    while ((before >> previous & 1) == 0 || cost[before * n + previous] >= unreached ||
           cost[before * n + previous] + step(previous, last) != cost[set * n + last]) {
      ++previous;
    }
    set = before;
    last = previous;
    order.push_back(last);
  }
  std::ranges::reverse(order);
  return order;
}

/// Steps as symmetric weights: the size of the largest block less the overlap. In a linear order,
/// city b stands between the last and the first block. If the first block is free, city b stands
/// before it, at a cost of the largest size less its own; city b + 1 stands after the last block;
/// and the two are adjacent.
class StepWeight {
 public:
  StepWeight(const Overlaps& overlaps, std::size_t extra_cities)
      : overlaps_(overlaps), two_extra_(extra_cities == 2) {
    for (std::size_t i = 0; i < overlaps.count(); ++i) {
      largest_ = std::max<std::int64_t>(largest_, overlaps.size(i));
    }
  }

  std::int64_t operator()(City a, City b) const {
    const std::size_t n = overlaps_.count();
    const City low = std::min(a, b);
    const City high = std::max(a, b);
    if (high < n) {
      return largest_ - overlaps_(a, b);
    }
    if (low >= n) {
      return low == high ? 0 : together;
    }
    return two_extra_ && high == n ? largest_ - overlaps_.size(low) : 0;
  }

 private:
  static constexpr std::int64_t together = -(std::int64_t{1} << 40);

  const Overlaps& overlaps_;
  bool two_extra_;
  std::int64_t largest_ = 0;
};

/// The blocks that overlap most with each block; ties are broken at random, for there are many.
class NearBlocks {
 public:
  NearBlocks(std::span<const Block> blocks, std::uint64_t v, std::size_t how_many, Random& random)
      : blocks_(blocks), how_many_(how_many), random_(random), with_(static_cast<std::size_t>(v)) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      for (const Element x : blocks[i]) {
        with_[x].push_back(static_cast<City>(i));
      }
    }
  }

  // O(b²k²/v). If that takes more than half of the remaining time, the other blocks are compared
  // only with some of those that share an element; after Ctrl-C with none.
  Neighbours lists(RunControl& control) {
    Neighbours neighbours(blocks_.size());
    overlap_.assign(blocks_.size(), 0);
    const auto left = control.time_left();
    RunControl half(control, left ? *left / 2 : std::chrono::duration<double>(forever));
    std::size_t most = all;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (i % blocks_between_questions == 0) {
        if (control.stop_wanted()) {
          break;
        }
        most = most == all && half.stop_wanted() ? some : most;
        control.tell(
            {.phase = "looking for blocks that are near each other", .steps = i, .unit = "blocks"});
      }
      meet(i, most);
      choose(i, neighbours[i]);
    }
    return neighbours;
  }

 private:
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t some = 32;  // blocks with the same element
  static constexpr std::size_t blocks_between_questions = 4;
  static constexpr double forever = 1e12;  // seconds

  struct Near {
    std::uint32_t overlap;
    std::uint32_t tie;
    City block;
    bool operator<(const Near& other) const {
      return std::tie(other.overlap, tie, block) < std::tie(overlap, other.tie, other.block);
    }
  };

  // Counts the overlaps with block i, with at most `most` other blocks for each of its elements.
  void meet(std::size_t i, std::size_t most) {
    met_.clear();
    for (const Element x : blocks_[i]) {
      const std::vector<City>& with = with_[x];
      auto begin = with.begin();
      auto end = with.end();
      if (with.size() > most) {
        const auto here = std::lower_bound(begin, end, static_cast<City>(i)) - begin;
        const auto length = static_cast<std::ptrdiff_t>(most);
        begin += std::clamp<std::ptrdiff_t>(here - length / 2, 0, end - begin - length);
        end = begin + length;
      }
      for (; begin != end; ++begin) {
        if (overlap_[*begin]++ == 0) {
          met_.push_back(*begin);
        }
      }
    }
  }

  // Sorts only blocks that overlap at least as much as the last one taken; ties are drawn.
  void choose(std::size_t i, std::vector<City>& nearest) {
    with_overlap_.assign(blocks_[i].size() + 1, 0);
    for (const City j : met_) {
      ++with_overlap_[overlap_[j]];
    }
    std::size_t least = with_overlap_.size();
    for (std::size_t enough = 0; least > 0 && enough <= how_many_; enough += with_overlap_[least]) {
      --least;
    }
    list_.clear();
    for (const City j : met_) {
      if (j != i) {
        const std::uint32_t tie = random_.next32();
        if (overlap_[j] >= least) {
          list_.push_back({overlap_[j], tie, j});
        }
      }
      overlap_[j] = 0;
    }
    const std::size_t count = std::min(how_many_, list_.size());
    std::partial_sort(list_.begin(), list_.begin() + static_cast<std::ptrdiff_t>(count),
                      list_.end());
    for (std::size_t at = 0; at < count; ++at) {
      nearest.push_back(list_[at].block);
    }
  }

  std::span<const Block> blocks_;
  std::size_t how_many_;
  Random& random_;
  std::vector<std::vector<City>> with_;  // by element
  std::vector<std::uint32_t> overlap_;   // with the current block
  std::vector<City> met_;
  std::vector<std::size_t> with_overlap_;  // number of blocks with each overlap
  std::vector<Near> list_;
};

// Goes from each block to the nearest free one. If no neighbour is free, takes the next block of a
// list of all free blocks; when stopped, takes the free blocks in that order.
std::vector<City> nearest_first(const Overlaps& overlaps, const Neighbours& neighbours,
                                RunControl& control) {
  const std::size_t n = overlaps.count();
  std::vector<City> free(n);
  std::iota(free.begin(), free.end(), City{0});
  std::vector<City> place = free;
  std::vector<City> order;
  City at = 0;
  while (true) {
    order.push_back(at);
    free[place[at]] = free.back();
    place[free.back()] = place[at];
    free.pop_back();
    place[at] = static_cast<City>(n);
    if (free.empty()) {
      return order;
    }
    City best = static_cast<City>(n);
    for (const City j : neighbours[at]) {
      if (place[j] < n) {
        best = j;
        break;
      }
    }
    if (best == n) {
      if (control.stop_wanted()) {
        std::ranges::sort(free);
        order.insert(order.end(), free.begin(), free.end());
        return order;
      }
      best = free.front();
      std::uint32_t most = overlaps(at, best);
      for (const City j : free) {
        const std::uint32_t overlap = overlaps(at, j);
        if (overlap > most) {
          most = overlap;
          best = j;
        }
      }
    }
    at = best;
  }
}

std::vector<std::size_t> searched_order(std::span<const Block> blocks, const Overlaps& overlaps,
                                        const LeastChangeWanted& wanted,
                                        const LeastChangeOptions& options, RunControl& control,
                                        std::uint64_t& kicks) {
  Random random(control.seed());
  const std::size_t n = blocks.size();
  const bool linear = wanted.kind == Kind::linear;
  Neighbours neighbours = NearBlocks(blocks, wanted.v, options.neighbours, random).lists(control);
  std::vector<City> begin = nearest_first(overlaps, neighbours, control);
  const std::size_t extra_cities = !linear ? 0 : wanted.first_counts ? 1 : 2;
  for (std::size_t extra = n; extra < n + extra_cities; ++extra) {
    begin.push_back(static_cast<City>(extra));
    std::vector<City>& beside = neighbours.emplace_back();
    for (std::size_t i = 0; i < options.neighbours; ++i) {
      beside.push_back(random.below(static_cast<City>(n)));
    }
    std::ranges::sort(beside, [&](City a, City b) {
      return std::pair(overlaps.size(b), a) < std::pair(overlaps.size(a), b);
    });
    if (extra_cities == 2) {
      beside.insert(beside.begin(), static_cast<City>(extra == n ? n + 1 : n));
    }
  }
  if (extra_cities == 2) {  // … last, n+1, n, first …
    std::swap(begin[n], begin[n + 1]);
  }
  const StepWeight weight(overlaps, extra_cities);
  Tour<StepWeight> tour(weight, std::move(begin), neighbours, random);
  tour.descend([&] { return control.stop_wanted(); });
  const std::uint64_t most = options.kicks.value_or(kicks_a_block * n);
  for (; kicks < most; ++kicks) {
    if (kicks % 64 == 0) {
      if (control.stop_wanted()) {
        break;
      }
      if (control.progress_due()) {
        control.tell({.phase = "ordering blocks", .steps = kicks, .unit = "kicks"});
      }
    }
    (void)tour.kick();
  }
  std::vector<std::size_t> order(tour.cities().begin(), tour.cities().end());
  if (linear) {
    const auto extra = std::ranges::find(order, n);
    std::rotate(order.begin(), extra, order.end());
    if (order[1] == n + 1) {  // read backwards
      std::reverse(order.begin() + 1, order.end());
    }
    std::erase_if(order, [n](std::size_t city) { return city >= n; });
  }
  return order;
}

}  // namespace

LeastChangeOrder order_for_least_change(std::span<const Block> blocks,
                                        const LeastChangeWanted& wanted,
                                        const LeastChangeOptions& options, RunControl& control) {
  if (blocks.empty()) {
    throw BadInput("there are no blocks to order");
  }
  const RunScope scope(control);
  const Overlaps overlaps(blocks, wanted.v);
  const std::size_t n = blocks.size();
  LeastChangeOrder result;
  result.order.resize(n);
  std::iota(result.order.begin(), result.order.end(), std::size_t{0});
  result.cost = result.first_cost = change_cost(blocks, result.order, wanted);
  const auto offer = [&](std::vector<std::size_t> order) {
    const std::uint64_t cost = change_cost(blocks, order, wanted);
    if (cost < result.cost) {
      result.cost = cost;
      result.order = std::move(order);
    }
  };
  const bool exact =
      n <= std::min(std::max(options.exact_blocks, fewest_for_local_search), most_exact_blocks);
  if (exact) {
    offer(least_order(overlaps, wanted));
    result.lower_bound = result.cost;
    result.why_stopped = WhyStopped::exhausted;
    return result;
  }
  offer(searched_order(blocks, overlaps, wanted, options, control, result.kicks));
  result.lower_bound =
      order_lower_bound(blocks, overlaps, wanted, result.cost, options.bound_effort, control);
  result.why_stopped = result.least()                                 ? WhyStopped::exhausted
                       : control.why_stopped() != WhyStopped::running ? control.why_stopped()
                                                                      : WhyStopped::step_limit;
  return result;
}

}  // namespace changeover
