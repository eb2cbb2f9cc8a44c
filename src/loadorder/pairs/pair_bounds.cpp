#include "loadorder/pairs/pair_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "core/least_number.hpp"
#include "core/words.hpp"
#include "loadorder/pairs/bucket_queue.hpp"

namespace changeover {
namespace {

/// The numbers of one component while the items with the fewest partners are removed from it one by
/// one.
struct Component {
  std::uint64_t items = 0;  // remaining items
  std::uint64_t pairs = 0;
  std::uint64_t all_items = 0;
  std::uint64_t all_pairs = 0;
  std::uint64_t bound = 0;
  std::uint64_t core_items = 0;  // the part that gives the bound
  std::uint64_t core_pairs = 0;
};

std::vector<std::uint32_t> components_of(const PairGraph& graph, std::uint32_t& count) {
  constexpr std::uint32_t none = ~std::uint32_t{0};
  std::vector<std::uint32_t> component(static_cast<std::size_t>(graph.items()), none);
  std::vector<Element> reached;
  count = 0;
  for (Element x = 0; x < graph.items(); ++x) {
    if (component[x] != none || !graph.is_needed(x)) {
      continue;
    }
    component[x] = count;
    reached.assign(1, x);
    while (!reached.empty()) {
      const Element y = reached.back();
      reached.pop_back();
      for (const Element z : graph.partners(y)) {
        if (component[z] == none) {
          component[z] = count;
          reached.push_back(z);
        }
      }
    }
    ++count;
  }
  return component;
}

// Items in order of fewest remaining partners; calls visit(x, partners).
template <typename Visit>
void peel(const PairGraph& graph, Visit&& visit) {
  const auto n = static_cast<std::size_t>(graph.items());
  std::vector<std::uint32_t> degree(n);
  BucketQueue queue(n);
  for (Element x = 0; x < n; ++x) {
    degree[x] = static_cast<std::uint32_t>(graph.partners(x).size());
    if (graph.is_needed(x)) {
      queue.put(x, degree[x]);
    }
  }
  while (const auto x = queue.take_lowest()) {
    visit(*x, degree[*x]);
    for (const Element y : graph.partners(*x)) {
      if (queue.holds(y)) {
        queue.put(y, --degree[y]);
      }
    }
  }
}

std::string all_are_loaded(std::uint64_t items) {
  return items == 1 ? "the item is loaded" : fmt::format("each of {} items is loaded", items);
}

LoadBound bound_of_all(std::uint64_t items, std::uint64_t room) {
  if (items <= room) {
    return {items, all_are_loaded(items)};
  }
  const Parameters p{.v = items, .k = room, .change = 1, .kind = Kind::linear};
  const Bound bound = lower_bound(p);
  return {checked_add(room, bound.blocks - 1),
          fmt::format("loads from number {} on make blocks of a linear SCCD({},{}), {}: {}", room,
                      items, room, bound.name, bound.reason)};
}

LoadBound bound_of_list(const PairGraph& graph, std::uint64_t room) {
  std::uint32_t count = 0;
  const std::vector<std::uint32_t> component = components_of(graph, count);
  std::vector<Component> parts(count);
  for (Element x = 0; x < graph.items(); ++x) {
    if (graph.is_needed(x)) {
      Component& part = parts[component[x]];
      ++part.all_items;
      part.all_pairs += graph.partners(x).size();
    }
  }
  std::string complete;
  const auto consider = [&](Component& part) {
    const std::uint64_t loads =
        part.all_items - part.items + std::max(part.items, least_loads(part.pairs, room));
    if (loads > part.bound) {
      part.bound = loads;
      part.core_items = part.items;
      part.core_pairs = part.pairs;
    }
  };
  for (Component& part : parts) {
    part.items = part.all_items;
    part.pairs = part.all_pairs /= 2;
    part.bound = part.all_items;
    consider(part);
    if (part.all_items > room && part.all_pairs == binomial(part.all_items, 2)) {
      const LoadBound all = bound_of_all(part.all_items, room);
      if (all.loads > part.bound) {
        part.bound = all.loads;
        complete =
            fmt::format("where all pairs of {} items are listed, {}; ", part.all_items, all.reason);
      }
    }
  }
  peel(graph, [&](Element x, std::size_t degree) {
    Component& part = parts[component[x]];
    --part.items;
    part.pairs -= degree;
    consider(part);
  });
  LoadBound bound;
  const Component* largest = nullptr;
  std::uint64_t items = 0;
  for (const Component& part : parts) {
    bound.loads += part.bound;
    items += part.all_items;
    if (part.core_items > 0 && (largest == nullptr || part.core_pairs > largest->core_pairs)) {
      largest = &part;
    }
  }
  bound.reason = complete;
  if (largest != nullptr) {
    const std::uint64_t needed = least_loads(largest->core_pairs, room);
    bound.reason += fmt::format(
        "{} items have {} pairs with each other, and {} loads of them bring at most {} together; ",
        largest->core_items, largest->core_pairs, needed - 1, most_pairs(needed - 1, room));
  }
  bound.reason += bound.reason.empty() ? all_are_loaded(items) : "each other item is loaded";
  if (!complete.empty() || largest != nullptr) {
    bound.reason += count > 1 ? fmt::format(", in {} components", count) : std::string();
  }
  return bound;
}

LoadBound bound_between(const WantedPairs& wanted, std::uint64_t room) {
  const std::uint64_t items = wanted.items();
  const std::uint64_t by_pairs = least_between(wanted.count(), room);
  if (by_pairs <= items) {
    return {items, all_are_loaded(items)};
  }
  return {by_pairs,
          fmt::format("the first {} loads bring at most {} together, each further one {}, and {} "
                      "are wanted",
                      room, count_of(most_between(room, room), "pair"), room - 1, wanted.count())};
}

LoadBound bound_beyond(const WantedPairs& wanted, std::uint64_t room) {
  const std::uint64_t fresh = wanted.items() - wanted.first();
  const std::uint64_t by_pairs = least_loads(wanted.count(), room);
  const LoadBound among = bound_of_all(fresh, room);
  const std::uint64_t apart = checked_add(wanted.first(), among.loads);
  if (by_pairs > apart) {
    return {by_pairs, fmt::format("{} pairs are wanted, and {} loads bring at most {} together",
                                  wanted.count(), by_pairs - 1, most_pairs(by_pairs - 1, room))};
  }
  return {apart, fmt::format("each old item is loaded, {} in all, and the new ones {}: {}",
                             wanted.first(), count_of(among.loads, "time"), among.reason)};
}

}  // namespace

std::uint64_t most_pairs(std::uint64_t loads, std::uint64_t room) {
  return loads <= room ? binomial(loads, 2)
                       : checked_add(binomial(room, 2), checked_multiply(loads - room, room - 1));
}

std::uint64_t least_loads(std::uint64_t pairs, std::uint64_t room) {
  if (const std::uint64_t first = binomial(room, 2); pairs > first) {
    return checked_add(room, ceil_div(pairs - first, room - 1));
  }
  return least_number(0, room, [&](std::uint64_t loads) { return binomial(loads, 2) >= pairs; });
}

std::uint64_t most_between(std::uint64_t loads, std::uint64_t room) {
  const std::uint64_t first = std::min(loads, room);
  return checked_add(first / 2 * (first - first / 2), checked_multiply(loads - first, room - 1));
}

std::uint64_t least_between(std::uint64_t pairs, std::uint64_t room) {
  if (const std::uint64_t first = most_between(room, room); pairs > first) {
    return checked_add(room, ceil_div(pairs - first, room - 1));
  }
  std::uint64_t loads = 0;
  while (most_between(loads, room) < pairs) {
    ++loads;
  }
  return loads;
}

std::uint64_t needed_items(const WantedPairs& wanted) {
  std::uint64_t count = wanted.items();
  for (Element x = 0; wanted.graph() != nullptr && x < wanted.items(); ++x) {
    count -= wanted.needs(x) ? 0U : 1U;
  }
  return count;
}

LoadBound load_lower_bound(const WantedPairs& wanted, std::uint64_t room) {
  const std::uint64_t items = wanted.items();
  if (items == 0) {
    throw BadInput("a load order of 0 items: give at least 1 item");
  }
  if (room < 2) {
    throw BadInput(fmt::format("room for {}: no two items could meet; give room for at least 2",
                               count_of(room, "item")));
  }
  // More room than items changes nothing.
  room = std::min(room, std::max<std::uint64_t>(2, items));
  switch (wanted.kind()) {
    case WantedPairs::Kind::between:
      return bound_between(wanted, room);
    case WantedPairs::Kind::beyond:
      return bound_beyond(wanted, room);
    case WantedPairs::Kind::listed:
      return bound_of_list(*wanted.graph(), room);
    default:
      if (items > most_items) {
        throw ImpossibleParameters(
            fmt::format("{} items: a load order has at most {}; group items into larger ones",
                        items, most_items));
      }
      return bound_of_all(items, room);
  }
}

}  // namespace changeover
