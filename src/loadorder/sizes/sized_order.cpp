// Orders for items of different sizes.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/sizes/closing_search.hpp"
#include "loadorder/sizes/item_groups.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

/// Packs groups of at most `most` bytes: the largest items first, each into the first group with
/// room.
Groups packed(const ItemSizes& sizes, const std::vector<Element>& largest_first,
              std::uint64_t most) {
  Groups groups;
  std::vector<std::uint64_t> left;
  for (const Element x : largest_first) {
    std::size_t g = 0;
    while (g < groups.size() && left[g] < sizes.bytes[x]) {
      ++g;
    }
    if (g == groups.size()) {
      groups.emplace_back();
      left.push_back(most);
    }
    groups[g].push_back(x);
    left[g] -= sizes.bytes[x];
  }
  return groups;
}

// The best order for each number of groups that fit. Items of a group that are still in memory are
// not loaded again.
void consider_packed(const ItemSizes& given, const std::vector<Element>& items, std::uint64_t least,
                     SizedOffer& best) {
  constexpr std::uint64_t most_room = 64;
  LoadOrderOptions quick;
  quick.closure_rules = false;
  // Items are numbered by their sizes, since of those needed equally late the last number goes.
  std::vector<Element> names = largest_first(given, items);
  std::ranges::reverse(names);
  const ItemSizes sizes = sizes_of(given, names);
  std::vector<Element> numbers(names.size());
  std::iota(numbers.rbegin(), numbers.rend(), Element{0});
  for (std::uint64_t room = 2; room <= most_room && best.bytes > least; ++room) {
    if (sizes.memory / room < sizes.bytes.back() || (must_hurry() && !best.moves.empty())) {
      return;
    }
    static_cast<void>(done(!best.moves.empty(), [&] {
      const Groups groups = packed(sizes, numbers, sizes.memory / room);
      const LoadOrder order = plan_load_order(groups.size(), room, quick);
      const std::vector<Move> moves =
          lazily(of_items(*order.stream(), groups), sizes.memory, &sizes);
      const std::uint64_t bytes =
          sum_of(moves, [&](const Move& move) { return bytes_of(sizes, move.load); });
      if (bytes < best.bytes) {
        best = {one_by_one(moves, sizes), bytes, "packed, " + order.facts().method,
                fmt::format("Items are packed into {} groups, of which {} fit: {}", groups.size(),
                            room, order.facts().explanation)};
        give_names(best.moves, names);
      }
    }));
  }
}

// Calls visit(x, y) with the largest item y that x must meet, or with x twice if it meets none; of
// all pairs for the two largest items only.
template <typename Visit>
void each_with_largest(const ItemSizes& sizes, const WantedPairs& wanted, Visit&& visit) {
  const auto items = static_cast<Element>(sizes.bytes.size());
  const auto largest_but = [&](std::optional<Element> other) {
    std::optional<Element> largest;
    for (Element x = 0; x < items; ++x) {
      if (x != other && (!largest || sizes.bytes[x] > sizes.bytes[*largest])) {
        largest = x;
      }
    }
    return largest;
  };
  if (wanted.are_all()) {
    const Element first = *largest_but(std::nullopt);
    visit(first, largest_but(first).value_or(first));
    return;
  }
  for (Element x = 0; x < items; ++x) {
    if (wanted.needs(x)) {
      Element with = x;
      each_partner(wanted, items, x, [&](Element y) {
        with = with == x || sizes.bytes[y] > sizes.bytes[with] ? y : with;
      });
      visit(x, with);
    }
  }
}

}  // namespace

void refuse_large_items(std::uint64_t items) {
  throw BadInput(fmt::format(
      "{} items, some of them larger than half of memory; give at most {} for all pairs, or split "
      "the largest ones",
      items, most_closed_all));
}

std::uint64_t bytes_of(const ItemSizes& sizes, std::span<const Element> items) {
  std::uint64_t sum = 0;
  for (const Element x : items) {
    sum = checked_add(sum, sizes.bytes[x]);
  }
  return sum;
}

ItemSizes sizes_of(const ItemSizes& sizes, std::span<const Element> items) {
  return {each_of<std::uint64_t>(items, [&](const Element x) { return sizes.bytes[x]; }),
          sizes.memory, sizes.fast_memory};
}

void check_sizes(const ItemSizes& sizes, const WantedPairs& wanted, const SizePlace& place,
                 const std::string& where) {
  const std::uint64_t items = sizes.bytes.size();
  if (items == 0 || (!wanted.are_all() && wanted.items() != items)) {
    throw BadInput(fmt::format("{} for {}", count_of(items, "size"),
                               wanted.are_all() ? "no item" : wanted.describe()));
  }
  if (items > max_elements_in_memory) {
    throw ImpossibleParameters(
        fmt::format("{} items: with sizes there are at most {}; group items into larger ones",
                    items, max_elements_in_memory));
  }
  const auto name = [&](Element x) {
    return wanted.graph() != nullptr && !wanted.graph()->names().empty()
               ? wanted.graph()->names()[x]
               : std::to_string(x);
  };
  const auto refuse = [&](Element x, const std::string& line) {
    throw BadInput(place ? fmt::format("{}: {}", place(x), line) : line);
  };
  for (Element x = 0; x < items; ++x) {
    if (wanted.needs(x) && sizes.bytes[x] == 0) {
      refuse(x, fmt::format("item {} has no size; give at least 1 byte", name(x)));
    }
  }
  each_with_largest(sizes, wanted, [&](Element x, Element with) {
    const std::uint64_t size = sizes.bytes[x];
    if (size > sizes.memory || (with != x && sizes.bytes[with] > sizes.memory - size)) {
      refuse(x, with == x
                    ? fmt::format("item {} has {} bytes, more than the {} of {}; allow more",
                                  name(x), size, sizes.memory, where)
                    : fmt::format("items {} and {} have {} bytes together, more than the {} of {}; "
                                  "allow more",
                                  name(x), name(with), checked_add(size, sizes.bytes[with]),
                                  sizes.memory, where));
    }
  });
}

std::uint64_t largest_pair(const ItemSizes& sizes, const WantedPairs& wanted) {
  std::uint64_t most = 0;
  each_with_largest(sizes, wanted, [&](Element x, Element with) {
    most = std::max(most, sizes.bytes[x] + (with == x ? 0 : sizes.bytes[with]));
  });
  return most;
}

std::vector<Element> needed_among(const WantedPairs& wanted, std::uint64_t items) {
  std::vector<Element> needed;
  for (Element x = 0; x < items; ++x) {
    if (wanted.needs(x)) {
      needed.push_back(x);
    }
  }
  return needed;
}

std::uint64_t most_held(const ItemSizes& sizes, const WantedPairs& wanted) {
  std::vector<std::uint64_t> all = each_of<std::uint64_t>(
      needed_among(wanted, sizes.bytes.size()), [&](const Element x) { return sizes.bytes[x]; });
  std::ranges::sort(all);
  std::uint64_t count = 0;
  for (std::uint64_t left = sizes.memory; count < all.size() && all[count] <= left; ++count) {
    left -= all[count];
  }
  return std::max<std::uint64_t>(2, count);
}

LoadOrderFacts facts_before(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted) {
  LoadOrderFacts facts;
  facts.byte_bound = sized_lower_bound(*sizes, wanted);
  facts.items = sizes->bytes.size();
  facts.room = most_held(*sizes, wanted);
  facts.sizes = std::move(sizes);
  facts.wanted = wanted;
  facts.bound = load_lower_bound(wanted.among(facts.items), facts.room);
  return facts;
}

LoadOrderFacts with_levels(LoadOrderFacts facts, const ItemSizes& fast) {
  facts.transfer_byte_bound = sized_lower_bound(fast, facts.wanted);
  facts.fast_room = most_held(fast, facts.wanted);
  facts.transfer_bound = load_lower_bound(facts.wanted.among(facts.items), *facts.fast_room);
  return facts;
}

LoadOrder plan_sized_order(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                           const LoadOrderOptions& options) {
  return plan_with_spare(std::move(sizes), wanted, 0, options);
}

LoadOrder plan_with_spare(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                          std::uint64_t spare, const LoadOrderOptions& options) {
  LoadOrderFacts facts = facts_before(std::move(sizes), wanted);
  const ItemSizes& given = *facts.sizes;
  const std::vector<Element> items = needed_among(wanted, facts.items);
  const std::uint64_t least = facts.byte_bound.loads;
  ItemSizes used = given;
  used.memory -= spare;
  SizedOffer best;
  if (bytes_of(given, items) <= given.memory) {
    best.method = "one-step";
    best.explanation = "All items fit.";
    for (const Element x : items) {
      best.moves.push_back({x, {}});
    }
  } else {
    if (wanted.are_all()) {
      consider_packed(used, items, least, best);
    }
    if (best.bytes > least && (wanted.graph() != nullptr || facts.items <= most_closed_all)) {
      const WantedPairs list = as_list(wanted.among(facts.items));
      static_cast<void>(done(!best.moves.empty(), [&] {
        SizedOffer closing = best_closing(used, *list.graph(), facts.room, least, options);
        if (closing.bytes < best.bytes) {
          best = std::move(closing);
        }
      }));
    } else if (!wanted.are_all()) {
      consider_packed(used, items, least, best);
    }
  }
  if (best.moves.empty()) {
    refuse_large_items(facts.items);
  }
  facts.method = best.method;
  facts.explanation = best.explanation;
  LoadOrder::Maker maker = in_memory(in_steps(best.moves));
  const ScheduleVerdict verdict = read_order(maker, LoadOrder(facts, maker).rules(),
                                             count_of(facts.items, "item") + " by sizes", false);
  if (verdict.bytes < least) {
    throw InternalError("the load order by sizes moves fewer bytes than its bound");
  }
  static_cast<ScheduleFacts&>(facts) = static_cast<const ScheduleFacts&>(verdict);
  facts.every_step_read = true;
  facts.certificate = fmt::format("every step read, {}, at most {} bytes in memory",
                                  all_met(wanted.among(facts.items).count()), verdict.most_bytes);
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover
