#include "loadorder/pairs/small_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <type_traits>
#include <utility>

#include "run/portable_math.hpp"

namespace changeover {
namespace {

using Order = std::vector<Element>;

/// A set of items, each given by its place in the order.
template <std::size_t Words>
class Places {
 public:
  void insert(std::uint32_t x) { words_[x / 64] |= std::uint64_t{1} << x % 64; }
  void erase(std::uint32_t x) { words_[x / 64] &= ~(std::uint64_t{1} << x % 64); }
  [[nodiscard]] bool holds(std::uint32_t x) const { return (words_[x / 64] >> x % 64 & 1) != 0; }

  static constexpr std::uint32_t none = ~std::uint32_t{0};
  [[nodiscard]] std::uint32_t first() const {
    for (std::size_t i = 0; i < Words; ++i) {
      if (words_[i] != 0) {
        return static_cast<std::uint32_t>(64 * i) +
               static_cast<std::uint32_t>(std::countr_zero(words_[i]));
      }
    }
    return none;
  }
  [[nodiscard]] bool empty() const { return first() == none; }

  /// Removes the members of `others` and returns them.
  Places take(const Places& others) {
    Places taken;
    for (std::size_t i = 0; i < Words; ++i) {
      taken.words_[i] = words_[i] & others.words_[i];
      words_[i] &= ~others.words_[i];
    }
    return taken;
  }

  template <typename Visit>
  void each(Visit&& visit) const {
    for (std::size_t i = 0; i < Words; ++i) {
      for (std::uint64_t word = words_[i]; word != 0; word &= word - 1) {
        visit(static_cast<std::uint32_t>(64 * i) +
              static_cast<std::uint32_t>(std::countr_zero(word)));
      }
    }
  }

 private:
  std::array<std::uint64_t, Words> words_{};
};

/// Computes the loads of orders.
template <std::size_t Words>
class Player {
 public:
  Player(const std::vector<std::vector<Element>>& partners, std::uint64_t room)
      : partners_(partners), room_(room), place_(partners.size()), open_(partners.size()) {
    const std::size_t n = partners.size();
    at_.resize(n);
    memory_.reserve(n);
    closed_.reserve(n);
    missing_.reserve(n);
  }

  /// The number of loads of this order. Stops early if there are more than `limit`, which the
  /// result then exceeds. Stores the moves if `moves` is given.
  std::uint64_t play(const Order& order, std::uint64_t limit, std::vector<LoadMove>* moves) {
    const auto n = static_cast<std::uint32_t>(order.size());
    order_ = &order;
    moves_ = moves;
    for (std::uint32_t i = 0; i < n; ++i) {
      place_[order[i]] = i;
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      open_[i] = {};
      for (const Element y : partners_[order[i]]) {
        open_[i].insert(place_[y]);
      }
    }
    there_ = {};
    memory_.clear();
    closed_.clear();
    loads_ = 0;
    for (std::uint32_t x = 0; x < n && loads_ <= limit; ++x) {
      if (!open_[x].empty() || partners_[order[x]].empty()) {
        close(x, limit);
      }
    }
    return loads_;
  }

 private:
  static constexpr std::uint32_t nothing = Places<Words>::none;

  /// An open item in memory, and the place at which it is needed next.
  struct Held {
    std::uint32_t needed;
    std::uint32_t item;
  };

  void close(std::uint32_t x, std::uint64_t limit) {
    if (!there_.holds(x)) {
      load(x, nothing);
    }
    missing_.clear();
    open_[x].each([&](std::uint32_t y) {
      Places<Words> others = open_[y];
      others.erase(x);
      // Items that are needed for this pair only pass first; items that are needed soon stay. What
      // is needed last comes first, and of those needed at once the first.
      const std::uint32_t next = others.first();
      const std::uint32_t needed = next == nothing ? nothing : std::min(y, next);
      missing_.push_back(std::uint64_t{~needed} << 32 | y);
    });
    std::ranges::sort(missing_);
    for (std::size_t i = 0; i < missing_.size() && loads_ <= limit; ++i) {
      load(static_cast<std::uint32_t>(missing_[i]), x);
    }
  }

  // Chooses the item to evict for the next load.
  std::uint32_t make_room(std::uint32_t keep) {
    if (memory_.size() + closed_.size() < room_) {
      return nothing;
    }
    std::uint32_t last = nothing;
    if (!closed_.empty()) {
      last = closed_.back();
      closed_.pop_back();
      return last;
    }
    std::uint32_t when = 0;
    for (const Held& held : memory_) {
      if (held.item != keep && (last == nothing || held.needed > when)) {
        when = held.needed;
        last = held.item;
      }
    }
    there_.erase(last);
    forget(last);
    return last;
  }

  void forget(std::uint32_t y) {
    memory_[at_[y]] = memory_.back();
    at_[memory_.back().item] = at_[y];
    memory_.pop_back();
  }

  [[nodiscard]] std::uint32_t needed(std::uint32_t y) const {
    return std::min(y, open_[y].first());
  }

  void load(std::uint32_t x, std::uint32_t keep) {
    const std::uint32_t went = make_room(keep);
    if (moves_ != nullptr) {
      moves_->push_back({(*order_)[x], went == nothing ? LoadMove::nothing : (*order_)[went]});
    }
    ++loads_;
    open_[x].take(there_).each([&](std::uint32_t y) {
      open_[y].erase(x);
      if (open_[y].empty()) {
        there_.erase(y);
        forget(y);
        closed_.push_back(y);
      } else if (Held& held = memory_[at_[y]]; held.needed == x) {
        held.needed = needed(y);
      }
    });
    if (open_[x].empty()) {
      closed_.push_back(x);
    } else {
      there_.insert(x);
      at_[x] = static_cast<std::uint32_t>(memory_.size());
      memory_.push_back({needed(x), x});
    }
  }

  const std::vector<std::vector<Element>>& partners_;
  std::uint64_t room_;
  std::vector<std::uint32_t> place_;  // by item
  std::vector<Places<Words>> open_;   // by place: pairs that have not met
  Places<Words> there_;               // items in memory that are open
  std::vector<Held> memory_;
  std::vector<std::uint32_t> at_;  // by place, if it is in memory and open: where in memory_
  std::vector<std::uint32_t> closed_;
  std::vector<std::uint64_t> missing_;  // ~needed, then the item
  const Order* order_ = nullptr;
  std::vector<LoadMove>* moves_ = nullptr;
  std::uint64_t loads_ = 0;
};

// Moves a run of items elsewhere, mostly near a partner of its first item, and sometimes reverses
// it.
void change(const Order& order, const std::vector<std::vector<Element>>& partners, Random& random,
            Order& other) {
  constexpr std::uint32_t longest = 8;
  const auto n = static_cast<std::uint32_t>(order.size());
  const std::uint32_t most = std::min(longest, n / 2);
  const std::uint32_t length = 1 + (random.one_in_two() ? 0 : random.below(most));
  const std::uint32_t from = random.below(n - length + 1);
  std::uint32_t to = random.below(n - length + 1);
  const std::vector<Element>& near = partners[order[from]];
  if (!near.empty() && random.below(4) != 0) {
    const Element y = near[random.below(static_cast<std::uint32_t>(near.size()))];
    const auto at =
        static_cast<std::uint32_t>(std::ranges::find(order, y) - order.begin()) + random.below(7);
    if (at >= 3 && at - 3 + length <= n) {
      to = at - 3;
    }
  }
  other = order;
  const auto at = [&](std::uint32_t i) { return other.begin() + static_cast<std::ptrdiff_t>(i); };
  if (length > 1 && random.below(4) == 0) {
    std::reverse(at(from), at(from + length));
  }
  if (from < to) {
    std::rotate(at(from), at(from + length), at(to + length));
  } else {
    std::rotate(at(to), at(from), at(from + length));
  }
}

}  // namespace

bool SmallSearch::serves(const PairGraph& graph) {
  std::size_t items = 0;
  for (Element x = 0; x < graph.items() && items <= most_items; ++x) {
    items += graph.is_needed(x) ? std::size_t{1} : 0;
  }
  return items <= most_items;
}

SmallSearch::SmallSearch(const PairGraph& graph, std::uint64_t room)
    : room_(room), pairs_(graph.pairs()) {
  std::vector<Element> ours(static_cast<std::size_t>(graph.items()), 0);
  for (Element x = 0; x < graph.items(); ++x) {
    if (graph.is_needed(x)) {
      ours[x] = static_cast<Element>(names_.size());
      names_.push_back(x);
    }
  }
  for (const Element x : names_) {
    std::vector<Element>& partners = partners_.emplace_back();
    for (const Element y : graph.partners(x)) {
      partners.push_back(ours[y]);
    }
  }
}

std::uint64_t SmallSearch::work_of_look() const { return 2 * pairs_ + names_.size() * (room_ + 8); }

template <std::size_t Words>
SmallSearch::Found SmallSearch::anneal_words(Order order, std::uint64_t enough, std::uint64_t work,
                                             Random& random,
                                             const std::function<bool()>& stop_wanted) {
  constexpr double hot = 0.6;
  constexpr double cold = 0.1;
  const double octaves = natural_log(cold / hot) / natural_log(2);
  Player<Words> player(partners_, room_);
  std::uint64_t now = player.play(order, Closing::no_limit, nullptr);
  std::uint64_t best = now;
  Order best_order = order;
  const std::uint64_t looks = work / work_of_look();
  double heat = hot;
  Order other;
  for (std::uint64_t i = 0; i < looks && best > enough && order.size() > 2; ++i) {
    constexpr std::uint64_t looks_between = 64;
    if (i % looks_between == 0) {
      if (stop_wanted()) {
        break;
      }
      heat = hot * power_of_two(octaves * static_cast<double>(i) / static_cast<double>(looks));
    }
    change(order, partners_, random, other);
    const double u = (static_cast<double>(random.next32()) + 1) / 4294967296.0;
    const std::uint64_t limit = now + static_cast<std::uint64_t>(-heat * natural_log(u));
    const std::uint64_t loads = player.play(other, limit, nullptr);
    if (loads <= limit) {
      now = loads;
      order.swap(other);
      if (now < best) {
        best = now;
        best_order = order;
      }
    }
  }
  Found found;
  player.play(best_order, Closing::no_limit, &found.moves);
  for (LoadMove& move : found.moves) {
    move.load = names_[move.load];
    move.evict = move.evict == LoadMove::nothing ? move.evict : names_[move.evict];
  }
  for (const Element x : best_order) {
    found.order.push_back(names_[x]);
  }
  return found;
}

SmallSearch::Found SmallSearch::anneal(const std::vector<Element>& order, std::uint64_t enough,
                                       std::uint64_t work, Random& random,
                                       const std::function<bool()>& stop_wanted) {
  Order ours;
  for (const Element x : order) {
    const auto found = std::ranges::lower_bound(names_, x);
    if (found != names_.end() && *found == x) {
      ours.push_back(static_cast<Element>(found - names_.begin()));
    }
  }
  const auto anneal = [&]<std::size_t Words>(std::integral_constant<std::size_t, Words>) {
    return anneal_words<Words>(std::move(ours), enough, work, random, stop_wanted);
  };
  constexpr std::size_t most_words = most_items / 64;
  return names_.size() <= most_items / 4
             ? anneal(std::integral_constant<std::size_t, most_words / 4>())
         : names_.size() <= most_items / 2
             ? anneal(std::integral_constant<std::size_t, most_words / 2>())
             : anneal(std::integral_constant<std::size_t, most_words>());
}

}  // namespace changeover
