// Orders for items of different sizes.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/sizes/closing_search.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

/// Packs groups of at most `most` bytes: the largest items first, each into the first group with
/// room.
std::vector<std::vector<Element>> packed(const ItemSizes& sizes, const std::vector<Element>& items,
                                         std::uint64_t most) {
  std::vector<Element> order = items;
  std::ranges::stable_sort(order,
                           [&](Element a, Element b) { return sizes.bytes[a] > sizes.bytes[b]; });
  std::vector<std::vector<Element>> groups;
  std::vector<std::uint64_t> left;
  for (const Element x : order) {
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

/// An order of groups, item by item. Items of a group that are still in memory are not loaded
/// again. Evicted groups stay as long as there is room; the item that is needed last is evicted
/// first.
class GroupedMoves {
 public:
  GroupedMoves(const ItemSizes& sizes, const std::vector<std::vector<Element>>& groups,
               const LoadOrder& order)
      : sizes_(sizes), groups_(groups), uses_(groups.size()) {
    const auto steps = order.stream();
    for (Step step; steps->next(step);) {
      for (const Element g : step.load) {
        uses_[g].push_back(step.number);
      }
      steps_.push_back(step);
    }
    for (std::vector<std::uint64_t>& each : uses_) {
      std::ranges::reverse(each);
    }
  }

  SizedOffer result() {
    SizedOffer offer;
    offer.bytes = 0;
    std::vector<bool> wanted(groups_.size(), false);
    std::vector<bool> there(sizes_.bytes.size(), false);
    std::vector<std::pair<Element, Element>> idle;  // item and its group; may be evicted
    std::uint64_t held = 0;
    for (const Step& step : steps_) {
      stop_if_asked();
      for (const Element g : step.evict) {
        wanted[g] = false;
        for (const Element x : groups_[g]) {
          idle.emplace_back(x, g);
        }
      }
      for (const Element g : step.load) {
        wanted[g] = true;
        uses_[g].pop_back();
        std::erase_if(idle, [&](const auto& each) { return each.second == g; });
      }
      for (const Element g : step.load) {
        for (const Element x : groups_[g]) {
          if (there[x]) {
            continue;
          }
          SizedMove move{x, {}};
          while (held + sizes_.bytes[x] > sizes_.memory) {
            const auto goes = std::ranges::max_element(idle, [&](const auto& a, const auto& b) {
              return next_use(a.second) < next_use(b.second);
            });
            if (goes == idle.end()) {
              throw InternalError("groups of items do not fit into memory");
            }
            there[goes->first] = false;
            held -= sizes_.bytes[goes->first];
            move.evict.push_back(goes->first);
            idle.erase(goes);
          }
          there[x] = true;
          held += sizes_.bytes[x];
          offer.bytes += sizes_.bytes[x];
          offer.moves.push_back(std::move(move));
        }
      }
    }
    return offer;
  }

 private:
  [[nodiscard]] std::uint64_t next_use(Element group) const {
    return uses_[group].empty() ? ~std::uint64_t{0} : uses_[group].back();
  }

  const ItemSizes& sizes_;
  const std::vector<std::vector<Element>>& groups_;
  std::vector<std::vector<std::uint64_t>> uses_;  // by group: steps that load it, the next one last
  std::vector<Step> steps_;
};

// The best order for each number of groups that fit.
void consider_packed(const ItemSizes& sizes, const std::vector<Element>& items, std::uint64_t least,
                     SizedOffer& best) {
  constexpr std::uint64_t most_room = 64;
  LoadOrderOptions quick;
  quick.closure_rules = false;
  const std::uint64_t largest = largest_of(items, [&](const Element x) { return sizes.bytes[x]; });
  for (std::uint64_t room = 2; room <= most_room && best.bytes > least; ++room) {
    if (sizes.memory / room < largest || (must_hurry() && !best.moves.empty())) {
      return;
    }
    static_cast<void>(done(!best.moves.empty(), [&] {
      const auto groups = packed(sizes, items, sizes.memory / room);
      const LoadOrder order = plan_load_order(groups.size(), room, quick);
      SizedOffer offer = GroupedMoves(sizes, groups, order).result();
      if (offer.bytes < best.bytes) {
        best = std::move(offer);
        best.method = "packed, " + order.facts().method;
        best.explanation = fmt::format("Items are packed into {} groups, of which {} fit: {}",
                                       groups.size(), room, order.facts().explanation);
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

WantedPairs listed_among(const WantedPairs& wanted, std::uint64_t items) {
  return WantedPairs::listed(std::make_shared<const PairGraph>(
      items,
      [&](const PairGraph::Visit& visit) {
        for (Element y = 0; y < items; ++y) {
          visit(y, y);
          for (Element x = 0; x < y; ++x) {
            if (wanted.contains(x, y)) {
              visit(x, y);
            }
          }
        }
      },
      std::vector<std::string>()));
}

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
      const WantedPairs list =
          wanted.graph() != nullptr ? wanted : listed_among(wanted, facts.items);
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
  const ScheduleVerdict verdict = check_schedule(*maker(), LoadOrder(facts, maker).rules());
  if (!verdict.valid() || verdict.bytes < least) {
    throw InternalError(
        fmt::format("the load order by sizes is wrong: {}{}", verdict.fault, verdict.example));
  }
  static_cast<ScheduleFacts&>(facts) = static_cast<const ScheduleFacts&>(verdict);
  facts.every_step_read = true;
  facts.certificate =
      fmt::format("every step read, {} met, at most {} bytes in memory",
                  all_of(wanted.among(facts.items).count(), "pair"), verdict.most_bytes);
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover
