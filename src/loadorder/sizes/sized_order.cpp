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
#include "core/words.hpp"
#include "loadorder/order/kept_steps.hpp"
#include "loadorder/pairs/starts.hpp"
#include "loadorder/sizes/byte_closing.hpp"
#include "loadorder/sizes/sized_pairs.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

using SizedMoves = std::vector<SizedMove>;

constexpr std::uint64_t most_closed_all = 2'000;  // number of items, if all pairs are wanted

std::uint64_t bytes_of(const ItemSizes& sizes, const std::vector<Element>& items) {
  std::uint64_t sum = 0;
  for (const Element x : items) {
    sum += sizes.bytes[x];
  }
  return sum;
}

struct SizedOffer {
  SizedMoves moves;
  std::uint64_t bytes = ~std::uint64_t{0};
  std::string method;
  std::string explanation;
};

/// Searches an order of closing items.
class ClosingSearch {
 public:
  ClosingSearch(const ItemSizes& sizes, const PairGraph& graph, std::uint64_t room,
                std::uint64_t least, const LoadOrderOptions& options)
      : sizes_(sizes),
        graph_(graph),
        room_(room),
        least_(least),
        options_(options),
        closing_(sizes, graph) {}

  SizedOffer result() {
    if (options_.search_pairs) {
      options_.search_pairs([this] { search(true); });
    } else {
      search(false);
    }
    if (best_.empty()) {
      try_start("numbered", numbered());
    }
    closing_.run(best_);
    return {closing_.moves(), bytes_, "closing, " + name_,
            "Items are closed one after another: what an item lacks is loaded while it stays; what "
            "is needed last is evicted, as much as makes room."};
  }

 private:
  static bool stop_wanted(bool until_stopped) {
    if (!until_stopped) {
      stop_if_asked();
      return false;
    }
    RunControl* const control = RunScope::current();
    return control != nullptr && control->stop_wanted();
  }

  [[nodiscard]] std::vector<Element> numbered() const {
    std::vector<Element> order(static_cast<std::size_t>(graph_.items()));
    std::iota(order.begin(), order.end(), 0U);
    return order;
  }

  void try_start(const std::string& name, std::vector<Element> order) {
    const std::uint64_t limit = best_.empty() ? ByteClosing::no_limit : bytes_ - 1;
    const std::uint64_t bytes = closing_.run(order, limit);
    if (best_.empty() || bytes <= limit) {
      bytes_ = bytes;
      best_ = std::move(order);
      name_ = name;
    }
    count_try();
  }

  // A load examines the items in memory, and the start examines all pairs.
  void count_try() {
    looked_ += closing_.moves().size() * (4 + std::min<std::uint64_t>(room_, 64)) + graph_.pairs();
    ++tries_;
  }

  void search(bool until_stopped) {
    std::vector<Element> order = numbered();
    try_start("numbered", order);
    std::stable_sort(order.begin(), order.end(),
                     [&](Element a, Element b) { return sizes_.bytes[a] > sizes_.bytes[b]; });
    try_start("largest first", order);
    std::reverse(order.begin(), order.end());
    try_start("smallest first", order);
    each_start(graph_, room_, [&](const std::string& name, std::vector<Element> start) {
      try_start(name, std::move(start));
      return bytes_ > least_ && !stop_wanted(until_stopped);
    });
    // Moves an item to another place of the order, as long as that helps.
    constexpr std::uint64_t work = 20'000'000;  // a second or so
    constexpr std::uint64_t most_tries = 10'000;
    Random random(options_.seed);
    const auto items = static_cast<std::uint32_t>(best_.size());
    const std::uint64_t first = tries_;
    while (items > 1 && bytes_ > least_ && !stop_wanted(until_stopped) &&
           (until_stopped || (looked_ < work && tries_ - first < most_tries))) {
      order = best_;
      const std::uint32_t from = random.below(items);
      const std::uint32_t to = random.below(items);
      if (random.one_in_two()) {
        std::swap(order[from], order[to]);
      } else if (from < to) {
        std::rotate(order.begin() + from, order.begin() + from + 1, order.begin() + to + 1);
      } else {
        std::rotate(order.begin() + to, order.begin() + from, order.begin() + from + 1);
      }
      // An equally good order is kept, since it may lead to a better one.
      const std::uint64_t bytes = closing_.run(order, bytes_);
      if (bytes <= bytes_) {
        name_ = bytes < bytes_ ? "improved" : name_;
        bytes_ = bytes;
        best_ = std::move(order);
      }
      count_try();
      if (progress_due()) {
        report_progress({.phase = "improving the load order",
                         .steps = tries_,
                         .unit = "orders",
                         .best = bytes_,
                         .lower_bound = least_});
      }
    }
  }

  const ItemSizes& sizes_;
  const PairGraph& graph_;
  std::uint64_t room_;
  std::uint64_t least_;
  const LoadOrderOptions& options_;
  ByteClosing closing_;
  std::vector<Element> best_;
  std::uint64_t bytes_ = 0;
  std::string name_;
  std::uint64_t looked_ = 0;
  std::uint64_t tries_ = 0;
};

/// Packs groups of at most `most` bytes: the largest items first, each into the first group with
/// room.
std::vector<std::vector<Element>> packed(const ItemSizes& sizes, const std::vector<Element>& items,
                                         std::uint64_t most) {
  std::vector<Element> order = items;
  std::stable_sort(order.begin(), order.end(),
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
      std::reverse(each.begin(), each.end());
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
            const auto goes =
                std::max_element(idle.begin(), idle.end(), [&](const auto& a, const auto& b) {
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
  std::uint64_t largest = 0;
  for (const Element x : items) {
    largest = std::max(largest, sizes.bytes[x]);
  }
  for (std::uint64_t room = 2; room <= most_room && best.bytes > least; ++room) {
    stop_if_asked();
    if (sizes.memory / room < largest) {
      return;
    }
    const auto groups = packed(sizes, items, sizes.memory / room);
    const LoadOrder order = plan_load_order(groups.size(), room, quick);
    SizedOffer offer = GroupedMoves(sizes, groups, order).result();
    if (offer.bytes < best.bytes) {
      best = std::move(offer);
      best.method = "packed, " + order.facts().method;
      best.explanation = fmt::format("Items are packed into {} groups, of which {} fit: {}",
                                     groups.size(), room, order.facts().explanation);
    }
  }
}

// The loads up to the first eviction are one step; each further load is a step.
std::vector<Step> steps_of_moves(const SizedMoves& moves) {
  std::vector<Step> steps;
  for (const SizedMove& move : moves) {
    if (steps.size() == 1 && move.evict.empty()) {
      steps.front().load.push_back(move.load);
    } else {
      steps.push_back({steps.size() + 1, move.evict, {move.load}});
    }
  }
  return steps;
}

// All wanted pairs as a list.
PairGraph graph_of(const WantedPairs& wanted, std::uint64_t items) {
  return {items,
          [&](const PairGraph::Visit& visit) {
            for (Element y = 1; y < items; ++y) {
              for (Element x = 0; x < y; ++x) {
                if (wanted.contains(x, y)) {
                  visit(x, y);
                }
              }
            }
          },
          {}};
}

}  // namespace

void check_sizes(const ItemSizes& sizes, const WantedPairs& wanted) {
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
  for (Element x = 0; x < items; ++x) {
    if (!wanted.needs(x)) {
      continue;
    }
    const std::uint64_t size = sizes.bytes[x];
    if (size == 0) {
      throw BadInput(fmt::format("item {} has no size; give at least 1 byte", name(x)));
    }
    std::uint64_t largest = 0;
    Element with = x;
    if (wanted.are_all()) {  // reported once, for the two largest items, below
      continue;
    }
    each_partner(wanted, items, x, [&](Element y) {
      if (sizes.bytes[y] > largest) {
        largest = sizes.bytes[y];
        with = y;
      }
    });
    if (size > sizes.memory || largest > sizes.memory - size) {
      throw BadInput(
          with == x
              ? fmt::format("item {} has {} bytes, more than the {} of memory; allow more", name(x),
                            size, sizes.memory)
              : fmt::format("items {} and {} have {} bytes together, more than the {} of memory; "
                            "allow more",
                            name(x), name(with), size + largest, sizes.memory));
    }
  }
  if (wanted.are_all()) {
    std::vector<Element> order(static_cast<std::size_t>(items));
    std::iota(order.begin(), order.end(), 0U);
    std::partial_sort(
        order.begin(),
        order.begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(2, items)), order.end(),
        [&](Element a, Element b) { return sizes.bytes[a] > sizes.bytes[b]; });
    const std::uint64_t first = sizes.bytes[order[0]];
    const std::uint64_t second = items > 1 ? sizes.bytes[order[1]] : 0;
    if (first > sizes.memory || second > sizes.memory - first) {
      throw BadInput(
          items == 1
              ? fmt::format("item 0 has {} bytes, more than the {} of memory; allow more", first,
                            sizes.memory)
              : fmt::format("items {} and {} have {} bytes together, more than the {} of memory; "
                            "allow more",
                            order[0], order[1], checked_add(first, second), sizes.memory));
    }
  }
}

std::uint64_t most_held(const ItemSizes& sizes, const WantedPairs& wanted) {
  std::vector<std::uint64_t> all;
  for (Element x = 0; x < sizes.bytes.size(); ++x) {
    if (wanted.needs(x)) {
      all.push_back(sizes.bytes[x]);
    }
  }
  std::sort(all.begin(), all.end());
  std::uint64_t count = 0;
  for (std::uint64_t left = sizes.memory; count < all.size() && all[count] <= left; ++count) {
    left -= all[count];
  }
  return std::max<std::uint64_t>(2, count);
}

LoadOrder plan_sized_order(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                           const LoadOrderOptions& options) {
  LoadOrderFacts facts;
  facts.byte_bound = sized_lower_bound(*sizes, wanted);
  facts.items = sizes->bytes.size();
  facts.room = most_held(*sizes, wanted);
  facts.sizes = sizes;
  facts.wanted = wanted;
  facts.bound = load_lower_bound(wanted.among(facts.items), facts.room);
  std::vector<Element> items;
  for (Element x = 0; x < facts.items; ++x) {
    if (wanted.needs(x)) {
      items.push_back(x);
    }
  }
  const std::uint64_t least = facts.byte_bound.loads;
  SizedOffer best;
  if (bytes_of(*sizes, items) <= sizes->memory) {
    best.method = "one-step";
    best.explanation = "All items fit.";
    for (const Element x : items) {
      best.moves.push_back({x, {}});
    }
  } else {
    if (wanted.are_all()) {
      consider_packed(*sizes, items, least, best);
    }
    if (best.bytes > least && (wanted.graph() != nullptr || facts.items <= most_closed_all)) {
      std::optional<PairGraph> made;
      if (wanted.graph() == nullptr) {
        made.emplace(graph_of(wanted, facts.items));
      }
      SizedOffer closing =
          ClosingSearch(*sizes, made ? *made : *wanted.graph(), facts.room, least, options)
              .result();
      if (closing.bytes < best.bytes) {
        best = std::move(closing);
      }
    } else if (!wanted.are_all()) {
      consider_packed(*sizes, items, least, best);
    }
  }
  if (best.moves.empty()) {
    throw BadInput(fmt::format(
        "{} items, some of them larger than half of memory; give at most {} for all pairs, or "
        "split the largest ones",
        facts.items, most_closed_all));
  }
  facts.method = best.method;
  facts.explanation = best.explanation;
  const auto steps = std::make_shared<const std::vector<Step>>(steps_of_moves(best.moves));
  LoadOrder::Maker maker = [steps] { return std::make_unique<KeptSteps>(steps); };
  const ScheduleVerdict verdict = check_schedule(*maker(), LoadOrder(facts, maker).rules());
  if (!verdict.valid() || verdict.bytes < least) {
    throw InternalError(
        fmt::format("the load order by sizes is wrong: {}{}", verdict.fault, verdict.example));
  }
  static_cast<ScheduleFacts&>(facts) = verdict;
  facts.every_step_read = true;
  facts.certificate = fmt::format("every step read, all {} pairs met, at most {} bytes in memory",
                                  wanted.among(facts.items).count(), verdict.most_bytes);
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover
