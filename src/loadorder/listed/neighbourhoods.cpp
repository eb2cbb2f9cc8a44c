#include "loadorder/listed/neighbourhoods.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

using PartNumber = std::uint32_t;
constexpr PartNumber no_part = std::numeric_limits<PartNumber>::max();

// Counts looks at pairs and parts; too many end it.
class LookLimit {
 public:
  explicit LookLimit(std::uint64_t most) : left_(most) {}
  void spend(std::uint64_t looks) {
    left_ -= std::min(left_, looks);
    since_ += looks;
    if (since_ >= often) {
      since_ = 0;
      stop_if_asked();
    }
  }
  [[nodiscard]] bool is_over() const { return left_ == 0; }

 private:
  static constexpr std::uint64_t often = 1'000'000;
  std::uint64_t left_;
  std::uint64_t since_ = 0;
};

/// One end of a pair: the other item, and the number of the pair.
struct PairEnd {
  Element item = 0;
  std::uint32_t pair = 0;
};

/// The pairs of a list by item, with what they cost and the part that has each.
class PartedPairs {
 public:
  PartedPairs(const PairGraph& graph, std::uint64_t parts,
              const std::function<double(Element, Element)>& cost)
      : ends_(static_cast<std::size_t>(graph.items())), amounts_(parts, 0) {
    const auto items = static_cast<Element>(graph.items());
    for (Element x = 0; x < items; ++x) {
      ends_[x].reserve(graph.partners(x).size());
    }
    for (Element x = 0; x < items; ++x) {
      for (const Element y : graph.partners(x)) {
        if (x < y) {
          const auto pair = static_cast<std::uint32_t>(part_of_.size());
          ends_[x].push_back({y, pair});
          ends_[y].push_back({x, pair});
          part_of_.push_back(no_part);
          if (cost) {
            costs_.push_back(cost(x, y));
          }
        }
      }
    }
    for (std::uint32_t pair = 0; pair < part_of_.size(); ++pair) {
      all_ += cost_of(pair);
    }
  }

  [[nodiscard]] Element items() const { return static_cast<Element>(ends_.size()); }
  [[nodiscard]] const std::vector<PairEnd>& ends(Element x) const { return ends_[x]; }
  [[nodiscard]] PartNumber part_of(std::uint32_t pair) const { return part_of_[pair]; }
  [[nodiscard]] double cost_of(std::uint32_t pair) const {
    return costs_.empty() ? 1 : costs_[pair];
  }
  [[nodiscard]] double all() const { return all_; }
  [[nodiscard]] double amount(PartNumber part) const { return amounts_[part]; }

  void give(std::uint32_t pair, PartNumber part) {
    if (part_of_[pair] != no_part) {
      amounts_[part_of_[pair]] -= cost_of(pair);
    }
    part_of_[pair] = part;
    amounts_[part] += cost_of(pair);
  }

 private:
  std::vector<std::vector<PairEnd>> ends_;
  std::vector<PartNumber> part_of_;
  std::vector<double> costs_;
  std::vector<double> amounts_;  // of the parts
  double all_ = 0;
};

/// Grows parts one after another. All pairs among the items of a part are given to it, so what an
/// item of it still lacks are partners outside.
class PartGrowth {
 public:
  PartGrowth(PartedPairs& pairs, LookLimit& effort)
      : pairs_(pairs),
        effort_(effort),
        lacks_(pairs.items()),
        ends_(pairs.items()),
        inside_(pairs.items(), no_part),
        near_(pairs.items(), 0) {
    for (Element x = 0; x < pairs.items(); ++x) {
      ends_[x] = pairs.ends(x);
      lacks_[x] = static_cast<std::uint32_t>(ends_[x].size());
      wait(x);
    }
  }

  void grow(std::uint64_t parts) {
    double given = 0;
    for (PartNumber part = 0; part < parts; ++part) {
      goal_ = (pairs_.all() - given) / static_cast<double>(parts - part);
      is_last_ = part + 1 == parts;
      grow_one(part);
      given += pairs_.amount(part);
      if (effort_.is_over()) {
        return;
      }
    }
  }

 private:
  using Waiting = std::pair<std::uint32_t, Element>;  // what it lacks, and the item
  using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

  void wait(Element x) {
    if (lacks_[x] > 0) {
      waiting_.emplace(lacks_[x], x);
    }
  }

  // The item that lacks least of those in the queue, if any lacks something.
  [[nodiscard]] bool take(Queue& queue, Element& x) const {
    while (!queue.empty()) {
      const auto [lacks, item] = queue.top();
      queue.pop();
      if (lacks > 0 && lacks == lacks_[item]) {
        x = item;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool is_full(PartNumber part) const {
    return !is_last_ && pairs_.amount(part) >= goal_;
  }

  void grow_one(PartNumber part) {
    members_.clear();
    open_ = {};
    Queue beside;  // where the part before ended
    for (const Element x : before_) {
      beside.emplace(lacks_[x], x);
    }
    while (!is_full(part) && !effort_.is_over()) {
      Element x = 0;
      if (!take(open_, x)) {
        if (!take(beside, x) && !take(waiting_, x)) {
          break;
        }
        join(x, part);
      }
      close(x, part);
    }
    before_ = members_;
    std::erase_if(before_, [&](Element x) { return lacks_[x] == 0; });
    std::ranges::for_each(before_, [&](Element x) { wait(x); });
  }

  // All partners that it lacks join, first those that bring most pairs and lack fewest.
  void close(Element x, PartNumber part) {
    std::vector<Element> partners;
    for (const PairEnd& end : open_ends(x)) {
      if (inside_[end.item] != part) {
        partners.push_back(end.item);
      }
    }
    std::ranges::sort(partners, [&](Element a, Element b) {
      return std::pair(near(b, part), lacks_[a]) < std::pair(near(a, part), lacks_[b]);
    });
    for (const Element y : partners) {
      if (is_full(part)) {
        return;
      }
      join(y, part);
    }
  }

  // Those of its pairs that no part has.
  const std::vector<PairEnd>& open_ends(Element x) {
    effort_.spend(ends_[x].size());
    std::erase_if(ends_[x],
                  [&](const PairEnd& end) { return pairs_.part_of(end.pair) != no_part; });
    return ends_[x];
  }

  // How many of the part's items are partners.
  [[nodiscard]] std::uint32_t near(Element x, PartNumber part) const {
    return near_of_[x] == part ? near_[x] : 0;
  }

  void join(Element x, PartNumber part) {
    if (inside_[x] == part) {
      return;
    }
    inside_[x] = part;
    members_.push_back(x);
    for (const PairEnd& end : open_ends(x)) {
      const Element y = end.item;
      if (inside_[y] != part) {
        near_[y] = near(y, part) + 1;
        near_of_[y] = part;
      } else if (!is_full(part)) {
        pairs_.give(end.pair, part);
        --lacks_[x];
        if (--lacks_[y] > 0) {
          open_.emplace(lacks_[y], y);
        }
      }
    }
    if (lacks_[x] > 0) {
      open_.emplace(lacks_[x], x);
    }
  }

  PartedPairs& pairs_;
  LookLimit& effort_;
  std::vector<std::uint32_t> lacks_;
  std::vector<std::vector<PairEnd>> ends_;  // without some that a part has
  std::vector<PartNumber> inside_;          // the last part that an item joined
  std::vector<std::uint32_t> near_;
  std::vector<PartNumber> near_of_ = std::vector<PartNumber>(inside_.size(), no_part);
  std::vector<Element> members_;
  std::vector<Element> before_;
  Queue open_, waiting_;
  double goal_ = 0;
  bool is_last_ = false;
};

/// Gives pairs of parts with many items to others.
class PairExchange {
 public:
  PairExchange(PartedPairs& pairs, LookLimit& effort, std::uint64_t parts)
      : pairs_(pairs), effort_(effort), at_(pairs.items()), items_(parts, 0) {
    // Five per cent more than the mean, or a pair.
    const double mean = pairs.all() / static_cast<double>(parts);
    most_ = std::max(mean * 1.05, std::ceil(mean));
    for (Element x = 0; x < pairs.items(); ++x) {
      for (const PairEnd& end : pairs.ends(x)) {
        change(x, pairs.part_of(end.pair), 1);
      }
    }
  }

  void improve() {
    constexpr int most_rounds = 8;
    std::vector<PartNumber> parts(items_.size());
    for (PartNumber part = 0; part < parts.size(); ++part) {
      parts[part] = part;
    }
    for (int round = 0; round < most_rounds && !effort_.is_over(); ++round) {
      const std::vector<std::vector<Element>> members = members_of_parts();
      std::ranges::stable_sort(parts, std::greater<>(),
                               [&](PartNumber part) { return items_[part]; });
      bool moved = false;
      for (const PartNumber part : parts) {
        for (const Element x : members[part]) {
          moved = (!effort_.is_over() && goes(x, part)) || moved;
        }
      }
      if (!moved) {
        return;
      }
    }
  }

 private:
  static constexpr std::uint32_t most_pairs_moved = 6;

  struct At {
    PartNumber part = 0;
    std::uint32_t pairs = 0;
  };
  struct Moved {
    Element other = 0;
    std::uint32_t pair = 0;
    PartNumber to = 0;
  };

  // What so many items of a part count.
  static double weight(std::uint64_t items) {
    const auto x = static_cast<double>(items);
    return x * x * x * x * x * x;
  }

  // By part, the items with few pairs there; those with the fewest first.
  [[nodiscard]] std::vector<std::vector<Element>> members_of_parts() const {
    std::vector<std::vector<Element>> members(items_.size());
    for (std::uint32_t count = 1; count <= most_pairs_moved; ++count) {
      for (Element x = 0; x < pairs_.items(); ++x) {
        for (const At& at : at_[x]) {
          if (at.pairs == count) {
            members[at.part].push_back(x);
          }
        }
      }
    }
    return members;
  }

  void change(Element x, PartNumber part, int by) {
    const auto found = std::ranges::find(at_[x], part, &At::part);
    effort_.spend(static_cast<std::uint64_t>(found - at_[x].begin()) + 1);
    if (found == at_[x].end()) {
      at_[x].push_back({part, 1});
      ++items_[part];
      return;
    }
    found->pairs += static_cast<std::uint32_t>(by);
    if (found->pairs == 0) {
      *found = at_[x].back();
      at_[x].pop_back();
      --items_[part];
    }
  }

  [[nodiscard]] bool is_at(Element x, PartNumber part) const {
    return std::ranges::find(at_[x], part, &At::part) != at_[x].end();
  }

  void move(Element x, const Moved& moved, PartNumber from, PartNumber to) {
    pairs_.give(moved.pair, to);
    for (const Element item : {x, moved.other}) {
      change(item, from, -1);
      change(item, to, 1);
    }
  }

  // The part where a pair costs least; no_part if all are full.
  [[nodiscard]] PartNumber best_for(Element x, Element y, std::uint32_t pair, PartNumber from) {
    PartNumber best = no_part;
    std::pair<double, double> least;
    for (const auto& [item, other] : {std::pair(x, y), std::pair(y, x)}) {
      for (const At& at : at_[item]) {
        if (at.part == from || pairs_.amount(at.part) + pairs_.cost_of(pair) > most_) {
          continue;
        }
        effort_.spend(at_[other].size());
        const std::uint64_t more = is_at(other, at.part) ? 0 : 1;
        const std::uint64_t items = items_[at.part];
        const std::pair cost(weight(items + more) - weight(items), pairs_.amount(at.part));
        if (best == no_part || cost < least) {
          best = at.part;
          least = cost;
        }
      }
    }
    return best;
  }

  // Gives all pairs of the item in this part to others, if that makes the sum of weights less.
  bool goes(Element x, PartNumber from) {
    std::vector<Moved> moved;
    double before = weight(items_[from]);
    double after = 0;
    std::vector<std::pair<PartNumber, std::uint64_t>> touched;
    const std::vector<PairEnd>& ends = pairs_.ends(x);
    effort_.spend(ends.size());
    for (const PairEnd& end : ends) {
      if (pairs_.part_of(end.pair) == from) {
        moved.push_back({end.item, end.pair, no_part});
      }
    }
    bool all = !moved.empty() && moved.size() <= most_pairs_moved;
    std::size_t done = 0;
    for (; all && done < moved.size(); ++done) {
      Moved& one = moved[done];
      one.to = best_for(x, one.other, one.pair, from);
      if (one.to == no_part) {
        all = false;
        break;
      }
      if (std::ranges::find(touched, one.to, &std::pair<PartNumber, std::uint64_t>::first) ==
          touched.end()) {
        touched.emplace_back(one.to, items_[one.to]);
      }
      move(x, one, from, one.to);
    }
    for (const auto& [part, items] : touched) {
      before += weight(items);
      after += weight(items_[part]);
    }
    after += weight(items_[from]);
    if (all && after < before) {
      return true;
    }
    while (done > 0) {
      --done;
      move(x, moved[done], moved[done].to, from);
    }
    return false;
  }

  PartedPairs& pairs_;
  LookLimit& effort_;
  std::vector<std::vector<At>> at_;   // by item, where its pairs are
  std::vector<std::uint64_t> items_;  // by part
  double most_ = 0;                   // of what the pairs of a part cost
};

}  // namespace

std::vector<std::vector<ItemPair>> neighbourhoods(
    const PairGraph& graph, std::uint64_t workers,
    const std::function<double(Element, Element)>& cost) {
  constexpr std::uint64_t most_pairs = 10'000'000;
  constexpr std::uint64_t looks_a_pair = 200;
  if (graph.pairs() > most_pairs) {
    return {};
  }
  const std::uint64_t parts = std::clamp<std::uint64_t>(graph.pairs(), 1, workers);
  LookLimit effort(looks_a_pair * (graph.pairs() + parts));
  PartedPairs pairs(graph, parts, cost);
  PartGrowth(pairs, effort).grow(parts);
  if (effort.is_over()) {
    return {};
  }
  PairExchange(pairs, effort, parts).improve();
  std::vector<std::vector<ItemPair>> result(static_cast<std::size_t>(workers));
  for (Element x = 0; x < pairs.items(); ++x) {
    for (const PairEnd& end : pairs.ends(x)) {
      if (x < end.item) {
        result[pairs.part_of(end.pair)].emplace_back(x, end.item);
      }
    }
    if (graph.is_needed(x) && pairs.ends(x).empty()) {
      std::ranges::min_element(result, {}, &std::vector<ItemPair>::size)->emplace_back(x, x);
    }
  }
  return result;
}

}  // namespace changeover
