#include "loadorder/pairs/held/held_list.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "core/checked.hpp"
#include "loadorder/pairs/bucket_queue.hpp"

namespace changeover {
namespace {

using Groups = std::vector<std::vector<Element>>;

// Which items are done: in an earlier group, so that all their pairs have met.
class Passing {
 public:
  explicit Passing(const PairGraph& graph)
      : graph_(graph),
        done_(static_cast<std::size_t>(graph.items()), false),
        seen_(static_cast<std::size_t>(graph.items()), 0) {}

  /// Calls pass(y) for each item that has a pair with the group, is not in it and not done. Then
  /// the group is done.
  template <typename Pass>
  void each(const std::vector<Element>& group, Pass&& pass) {
    ++round_;
    for (const Element x : group) {
      seen_[x] = round_;
    }
    for (const Element x : group) {
      for (const Element y : graph_.partners(x)) {
        if (seen_[y] != round_ && !done_[y]) {
          seen_[y] = round_;
          pass(y);
        }
      }
    }
    for (const Element x : group) {
      done_[x] = true;
    }
  }

 private:
  const PairGraph& graph_;
  std::vector<bool> done_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t round_ = 0;
};

// Calls load(move) for each load. Of the items that pass, one that is in the next group comes last,
// if there is one: it stays.
template <typename Load>
void play(const PairGraph& graph, const Groups& groups, std::uint64_t room, Load&& load) {
  Passing passing(graph);
  std::vector<Element> may_go;  // what is in memory for nothing; the last one goes first
  std::uint64_t held = 0;
  const auto come = [&](Element x) {
    LoadMove move{x, LoadMove::nothing};
    if (held < room) {
      ++held;
    } else {
      move.evict = may_go.back();
      may_go.pop_back();
    }
    load(move);
  };
  std::vector<Element> pass;
  Element stayed = LoadMove::nothing;
  for (auto group = groups.begin(); group != groups.end(); ++group) {
    for (const Element x : *group) {
      if (x != stayed) {
        come(x);
      }
    }
    pass.clear();
    passing.each(*group, [&](Element y) { pass.push_back(y); });
    stayed = LoadMove::nothing;
    if (const auto next = group + 1; next != groups.end()) {
      const std::unordered_set<Element> members(next->begin(), next->end());
      const auto stays = std::ranges::find_if(pass, [&](Element y) { return members.contains(y); });
      if (stays != pass.end()) {
        std::iter_swap(stays, pass.end() - 1);
        stayed = pass.back();
      }
    }
    for (const Element y : pass) {
      come(y);
      if (y != stayed) {
        may_go.push_back(y);
      }
    }
    may_go.insert(may_go.begin(), group->begin(), group->end());
  }
}

// Groups in that order. Items whose pairs have all met when their turn comes are left out.
Groups cut(const PairGraph& graph, const std::vector<Element>& order, std::uint64_t room) {
  std::vector<std::uint32_t> open(static_cast<std::size_t>(graph.items()));
  for (const Element x : order) {
    open[x] = static_cast<std::uint32_t>(graph.partners(x).size());
  }
  const auto is_over = [&](Element x) { return open[x] == 0 && !graph.partners(x).empty(); };
  Groups groups;
  std::vector<Element> left(order.rbegin(), order.rend());  // the next one last
  while (!left.empty()) {
    std::vector<Element> group;
    while (!left.empty() && group.size() + 1 < room) {
      if (!is_over(left.back())) {
        group.push_back(left.back());
      }
      left.pop_back();
    }
    if (left.size() == 1 && !is_over(left.back())) {
      group.push_back(left.back());  // There is nothing to pass.
      left.pop_back();
    }
    for (const Element x : group) {
      for (const Element y : graph.partners(x)) {
        --open[y];
      }
    }
    if (!group.empty()) {
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

// A group begins with the item that has most pairs left, and takes the item with most partners
// among those that are in the group or pass it already. O(pairs) for each group.
std::vector<Element> by_shared_partners(const PairGraph& graph, std::uint64_t room,
                                        std::vector<Element> by_degree,
                                        const std::function<bool()>& give_up) {
  const auto items = static_cast<std::size_t>(graph.items());
  std::uint32_t most = 0;
  for (const Element x : by_degree) {
    most = std::max(most, static_cast<std::uint32_t>(graph.partners(x).size()));
  }
  std::vector<Element> order;
  std::vector<bool> done(items, false);
  std::vector<std::uint32_t> shared(items, 0);
  std::vector<std::uint32_t> seen(items, 0);
  std::uint32_t round = 0;
  auto first = by_degree.begin();
  while (order.size() < by_degree.size()) {
    while (done[*first]) {
      ++first;
    }
    ++round;
    std::ranges::fill(shared, 0U);
    BucketQueue queue(items);
    const auto take = [&](Element x) {
      queue.remove(x);
      done[x] = true;
      order.push_back(x);
      const auto come = [&](Element y) {
        if (seen[y] == round) {
          return;
        }
        seen[y] = round;
        for (const Element z : graph.partners(y)) {
          if (!done[z]) {
            queue.put(z, most - ++shared[z]);
          }
        }
      };
      come(x);
      for (const Element y : graph.partners(x)) {
        if (!done[y]) {
          come(y);
        }
      }
    };
    take(*first);
    for (std::uint64_t taken = 1; taken + 1 < room && order.size() < by_degree.size(); ++taken) {
      if (give_up()) {
        return {};
      }
      const auto next = queue.take_lowest();
      if (next) {
        take(*next);
        continue;
      }
      while (done[*first]) {
        ++first;
      }
      take(*first);
    }
  }
  return order;
}

}  // namespace

std::vector<LoadMove> HeldList::moves(const PairGraph& graph) const {
  std::vector<LoadMove> moves;
  moves.reserve(static_cast<std::size_t>(loads));
  play(graph, groups, room, [&](const LoadMove& move) { moves.push_back(move); });
  return moves;
}

HeldList held_list(const PairGraph& graph, std::uint64_t room,
                   const std::function<bool()>& give_up) {
  constexpr std::uint64_t most_work = 300'000'000;  // partners looked at
  std::vector<Element> numbered;
  for (Element x = 0; x < graph.items(); ++x) {
    if (graph.is_needed(x)) {
      numbered.push_back(x);
    }
  }
  std::vector<Element> by_degree = numbered;
  std::ranges::stable_sort(by_degree, [&](Element a, Element b) {
    return graph.partners(a).size() > graph.partners(b).size();
  });
  HeldList best{.room = room, .groups = {}, .loads = ~std::uint64_t{0}};
  const auto consider = [&](const std::vector<Element>& order) {
    Groups groups = cut(graph, order, room);
    std::uint64_t loads = 0;
    play(graph, groups, room, [&](const LoadMove&) { ++loads; });
    if (loads < best.loads) {
      best.groups = std::move(groups);
      best.loads = loads;
    }
  };
  consider(numbered);
  consider(by_degree);
  const std::uint64_t rounds = ceil_div(numbered.size(), room - 1);
  if (rounds <= most_work / (2 * graph.pairs() + graph.items() + 1) && !give_up()) {
    const std::vector<Element> shared = by_shared_partners(graph, room, by_degree, give_up);
    if (!shared.empty()) {
      consider(shared);
    }
  }
  return best;
}

}  // namespace changeover
