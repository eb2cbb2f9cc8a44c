// Items of different sizes for several workers.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/shares/few_workers.hpp"
#include "loadorder/shares/groups/known_shares.hpp"
#include "loadorder/shares/split_maker.hpp"
#include "loadorder/sizes/closing_search.hpp"
#include "loadorder/sizes/item_groups.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_own_pairs = 2'000'000;  // of which workers have orders of their own

/// Items in groups, of bytes as even as can be.
struct ByteGroups {
  ByteGroups(const ItemSizes& sizes, std::span<const Element> items, std::uint64_t groups)
      : of(even_groups(sizes, items, groups)),
        bytes(each_of<std::uint64_t>(
            of, [&](const auto& its) { return changeover::bytes_of(sizes, its); })),
        largest(each_of<std::uint64_t>(
            of, [&](const auto& its) { return its.empty() ? 0 : sizes.bytes[its.front()]; })) {}

  [[nodiscard]] std::uint64_t bytes_of(const std::vector<Element>& groups) const {
    return sum_of(groups, [&](const Element g) { return bytes[g]; });
  }

  Groups of;
  std::vector<std::uint64_t> bytes;
  std::vector<std::uint64_t> largest;
};

// Items that are held while others pass, which leave in the sequence in which they came.
std::vector<Move> held_and_streamed(const ItemSizes& sizes, const std::vector<Element>& held,
                                    const std::vector<Element>& streamed) {
  std::vector<SizedMove> moves;
  std::uint64_t bytes = 0;
  for (const Element x : held) {
    moves.push_back({x, {}});
    bytes += sizes.bytes[x];
  }
  std::size_t goes = 0;
  for (const Element x : streamed) {
    SizedMove& move = moves.emplace_back(SizedMove{x, {}});
    for (bytes += sizes.bytes[x]; bytes > sizes.memory; ++goes) {
      move.evict.push_back(streamed[goes]);
      bytes -= sizes.bytes[streamed[goes]];
    }
  }
  return in_steps(moves);
}

class SizedSplit {
 public:
  SizedSplit(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
             std::uint64_t workers, std::uint64_t spare, const LoadOrderOptions& options)
      : shared_(std::move(sizes)),
        sizes_(*shared_),
        wanted_(wanted),
        workers_(workers),
        spare_(spare),
        options_(options),
        items_(needed_among(wanted, sizes_.bytes.size())) {
    sizes_.memory -= spare;
    all_bytes_ = bytes_of(sizes_, items_);
  }

  WorkerSplit result() {
    LoadOrderOptions quick = options_;
    quick.search_pairs = nullptr;  // the time is for the workers' own orders
    LoadOrder order = plan_with_spare(shared_, wanted_, spare_, workers_ == 1 ? options_ : quick);
    const std::uint64_t room = order.facts().room;
    candidates_.push_back(
        SplitMaker::stretches(std::move(order), sizes_.bytes.size(), room, workers_));
    if (workers_ > 1) {
      add_shares();
      if (wanted_.kind() == WantedPairs::Kind::between) {
        add_blocks();
      }
    }
    // Leaving out needless loads may make the second best the best.
    keep_good();
    for (WorkerSplit& split : candidates_) {
      SplitMaker::give_pairs(split, options_);
    }
    const auto best = std::ranges::min_element(candidates_, {}, [](const WorkerSplit& split) {
      return std::pair(split.facts().makespan_bytes, split.facts().bytes);
    });
    WorkerSplit split = std::move(*best);
    if (workers_ > 1 && wanted_.among(sizes_.bytes.size()).count() <= most_own_pairs) {
      SplitMaker::own_orders(split, [&](const auto& pairs) { return own_moves(split, pairs); });
    }
    SplitMaker::verify(split, options_);
    return split;
  }

 private:
  void keep_good() {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (const WorkerSplit& split : candidates_) {
      least = std::min(least, split.facts().makespan_bytes);
    }
    std::erase_if(candidates_, [&](const WorkerSplit& split) {
      return split.facts().makespan_bytes / 3 > least / 2;
    });
  }

  const ByteGroups& in_groups(std::uint64_t groups) {
    return groups_.try_emplace(groups, sizes_, items_, groups).first->second;
  }

  // The best of the known shares.
  void add_shares() {
    std::uint64_t least = candidates_.front().facts().makespan_bytes;
    std::optional<GroupShares> best;
    const auto mean = [&](std::uint64_t groups, std::uint64_t of) {
      return static_cast<double>(all_bytes_) / static_cast<double>(of) *
             static_cast<double>(groups);
    };
    each_group_shares(
        workers_, items_.size(),
        [&](const ShareShape& shape) {
          return mean(shape.all, shape.groups) <= static_cast<double>(least) &&
                 mean(shape.held, shape.groups) <= static_cast<double>(sizes_.memory);
        },
        [&](GroupShares shares) {
          stop_if_asked();
          const ByteGroups& groups = in_groups(shares.groups);
          std::uint64_t makespan = 0;
          for (const GroupShare& share : shares.workers) {
            const std::uint64_t held = groups.bytes_of(share.held);
            const std::uint64_t streamed = groups.bytes_of(share.streamed);
            const std::uint64_t largest =
                largest_of(share.streamed, [&](const Element g) { return groups.largest[g]; });
            if (held > sizes_.memory || std::min(streamed, largest) > sizes_.memory - held) {
              return;
            }
            makespan = std::max(makespan, held + streamed);
          }
          if (makespan < least) {
            least = makespan;
            best = std::move(shares);
          }
        });
    if (!best) {
      return;
    }
    const ByteGroups& groups = in_groups(best->groups);
    const std::vector<std::vector<Move>> moves =
        each_of<std::vector<Move>>(best->workers, [&](const GroupShare& share) {
          return held_and_streamed(sizes_, items_in(groups.of, share.held),
                                   items_in(groups.of, share.streamed));
        });
    candidates_.push_back(
        SplitMaker::lists(candidates_.front(), moves, best->method,
                          fmt::format("The {} groups, of bytes as even as can be, are {}",
                                      best->groups, best->explanation)));
  }

  // Adds splits of two sets: each worker has a part of one with a part of the other.
  void add_blocks() {
    const std::uint64_t first = wanted_.first();
    const std::span<const Element> a(items_.begin(), static_cast<std::size_t>(first));
    const std::span<const Element> b(items_.begin() + static_cast<std::ptrdiff_t>(first),
                                     items_.end());
    const auto all_of_a = static_cast<double>(bytes_of(sizes_, a));
    const auto all_of_b = static_cast<double>(bytes_of(sizes_, b));
    double least = std::numeric_limits<double>::max();
    std::uint64_t parts = 0;
    const std::uint64_t most = std::min<std::uint64_t>(workers_, a.size());
    for (std::uint64_t p = 1; p <= most; ++p) {
      const std::uint64_t q = std::min<std::uint64_t>(workers_ / p, b.size());
      if (const double bytes =
              block_bytes(all_of_a / static_cast<double>(p), all_of_b / static_cast<double>(q));
          bytes < least) {
        least = bytes;
        parts = p;
      }
    }
    const std::uint64_t others = std::min<std::uint64_t>(workers_ / parts, b.size());
    const ByteGroups of_a(sizes_, a, parts);
    const ByteGroups of_b(sizes_, b, others);
    std::vector<std::vector<Move>> moves;
    for (const std::vector<Element>& some : of_a.of) {
      for (const std::vector<Element>& with : of_b.of) {
        moves.push_back(moves_of_block(some, with));
      }
    }
    candidates_.push_back(SplitMaker::lists(
        candidates_.front(), moves, "a block a worker",
        fmt::format("{} of the first set with {} of the other, of bytes as even as can be.",
                    count_of(parts, "part"), count_of(others, "part"))));
  }

  // An estimate: parts of the smaller set stay while the other one passes.
  [[nodiscard]] double block_bytes(double a, double b) const {
    const double memory = static_cast<double>(sizes_.memory);
    const auto with = [&](double stay, double pass) {
      return stay + std::max(1.0, stay / memory) * pass;
    };
    return a + b <= memory ? a + b : std::min(with(a, b), with(b, a));
  }

  // Parts of one set that fit stay while the other set passes, forth and back.
  [[nodiscard]] std::vector<Move> moves_of_block(const std::vector<Element>& some,
                                                 const std::vector<Element>& with) const {
    std::vector<ItemPair> pairs;
    for (const Element x : some) {
      for (const Element y : with) {
        pairs.emplace_back(x, y);
      }
    }
    Part part(*this, pairs, options_.seed);
    part.search.begin([] { return false; });
    return part.moves();
  }

  /// The pairs of one worker.
  struct Part {
    Part(const SizedSplit& split, const std::vector<ItemPair>& pairs, std::uint64_t seed)
        : items(items_of(pairs)),
          graph(items.size(), numbered(pairs, items)),
          sizes(sizes_of(split.sizes_, items)),
          search(sizes, graph, items.size(), changeover::bytes_of(split.sizes_, items), seed) {}

    [[nodiscard]] std::vector<Move> moves() {
      std::vector<SizedMove> found = search.offer().moves;
      give_names(found, items);
      return in_steps(found);
    }

    std::vector<Element> items;
    PairGraph graph;
    ItemSizes sizes;
    ClosingSearch search;
  };

  // The orders of workers for their pairs: the busiest one is improved as long as that is of use.
  std::vector<std::vector<Move>> own_moves(const WorkerSplit& split,
                                           const std::vector<std::vector<ItemPair>>& pairs) {
    std::deque<Part> parts;  // which stay where they are
    std::vector<std::uint64_t> bytes(pairs.size(), 0);
    const auto search = [&](std::uint64_t slice, std::uint64_t work, const auto& over) {
      for (std::size_t w = parts.size(); w < pairs.size() && !over(); ++w) {
        parts.emplace_back(*this, pairs[w], options_.seed + w);
        bytes[w] = split.facts().workers[w].bytes;
        if (!pairs[w].empty()) {
          parts[w].search.begin(over);
          bytes[w] = std::min(bytes[w], parts[w].search.bytes());
        }
      }
      while (parts.size() == pairs.size() && work > 0 && !over()) {
        const auto busiest =
            static_cast<std::size_t>(std::ranges::max_element(bytes) - bytes.begin());
        Part& part = parts[busiest];
        if (pairs[busiest].empty() || part.search.is_done() ||
            bytes[busiest] <= split.facts().makespan_bytes_bound.loads) {
          return;
        }
        part.search.improve(slice, over);
        bytes[busiest] = std::min(bytes[busiest], part.search.bytes());
        work -= std::min(work, slice);
      }
    };
    constexpr std::uint64_t slice = 200'000;
    constexpr double most_work = 150'000'000;  // a few seconds
    fixed_first(
        options_,
        [&] { search(slice, static_cast<std::uint64_t>(options_.effort * most_work), must_hurry); },
        [&](RunControl& control) {
          search(slice, std::numeric_limits<std::uint64_t>::max(),
                 [&] { return control.stop_wanted(); });
        });
    std::vector<std::vector<Move>> moves;
    for (std::size_t w = 0; w < pairs.size(); ++w) {
      const bool is_better = w < parts.size() && !pairs[w].empty() &&
                             parts[w].search.bytes() < split.facts().workers[w].bytes;
      moves.push_back(is_better ? parts[w].moves() : moves_of(*split.stream(w)));
    }
    return moves;
  }

  std::shared_ptr<const ItemSizes> shared_;
  ItemSizes sizes_;  // without the spare memory
  const WantedPairs& wanted_;
  std::uint64_t workers_;
  std::uint64_t spare_;
  const LoadOrderOptions& options_;
  std::vector<Element> items_;
  std::uint64_t all_bytes_ = 0;
  std::map<std::uint64_t, ByteGroups> groups_;
  std::vector<WorkerSplit> candidates_;
};

}  // namespace

WorkerSplit split_sized_order(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                              std::uint64_t workers, const LoadOrderOptions& options) {
  return split_with_spare(std::move(sizes), wanted, workers, 0, options);
}

WorkerSplit split_with_spare(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                             std::uint64_t workers, std::uint64_t spare,
                             const LoadOrderOptions& options) {
  check_workers(workers);
  check_sizes(*sizes, wanted);
  return SizedSplit(std::move(sizes), wanted, workers, spare, options).result();
}

}  // namespace changeover
