#include "loadorder/order/met_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "core/checked.hpp"
#include "run/random.hpp"

namespace changeover {

SeenPairs::SeenPairs(const WantedPairs& wanted, std::uint64_t items)
    : wanted_(wanted), items_(items), wanted_count_(wanted.among(items).count()) {
  if (wanted.graph() == nullptr && items > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("{} items have too many pairs to track; give at most {}, or watch some items",
                    items, max_elements_in_memory));
  }
  const std::uint64_t bits =
      wanted.graph() != nullptr ? 2 * wanted.graph()->pairs() : binomial(items, 2);
  seen_.assign(static_cast<std::size_t>(bits / 64 + 1), 0);
}

std::optional<ItemPair> SeenPairs::example() const {
  for (Element y = 0; y < items_ && missing() > 0; ++y) {
    const auto is_missing = [&](Element x) {
      const std::uint64_t bit =
          wanted_.graph() != nullptr ? *wanted_.graph()->place(x, y) : PairSet::rank(x, y);
      return (seen_[static_cast<std::size_t>(bit / 64)] >> bit % 64 & 1) == 0;
    };
    if (wanted_.graph() != nullptr) {
      for (const Element x : wanted_.graph()->partners(y)) {
        if (y < x && is_missing(x)) {
          return ItemPair{y, x};
        }
      }
      continue;
    }
    for (Element x = 0; x < y; ++x) {
      if (wanted_.contains(x, y) && is_missing(x)) {
        return ItemPair{x, y};
      }
    }
  }
  return std::nullopt;
}

void MetInWords::add_below(PairSet& pairs, Element x, const WordSet& set) const {
  for (const auto& [word, bits] : set.words()) {
    if (64 * std::uint64_t{word} >= x) {
      return;
    }
    if (count_ != nullptr) {
      const std::uint64_t before = pairs.below(x, word);
      pairs.insert_below(x, word, bits);
      *count_ += static_cast<std::uint64_t>(std::popcount(pairs.below(x, word) & ~before));
    } else {
      pairs.insert_below(x, word, bits);
    }
  }
}

MetInWords::MetInWords(std::uint64_t room, std::vector<std::uint32_t>& since)
    : most_arrivals_(static_cast<std::size_t>(arrivals_of_a_large_set + 4 * room)),
      since_(&since) {}

void MetInWords::arrive(Element name, PairSet& pairs) {
  if (arrivals_.size() == most_arrivals_) {
    settle(pairs);
  }
  add_below(pairs, name, held_);
  held_.insert(name);
  arrivals_.push_back(name);
  (*since_)[name] = static_cast<std::uint32_t>(arrivals_.size());
  if (arrivals_.size() % arrivals_of_a_set == 0) {
    WordSet& set = sets_.emplace_back();
    for (std::size_t i = arrivals_.size() - arrivals_of_a_set; i < arrivals_.size(); ++i) {
      set.insert(arrivals_[i]);
    }
  }
  if (arrivals_.size() % arrivals_of_a_large_set == 0) {
    constexpr std::size_t sets = arrivals_of_a_large_set / arrivals_of_a_set;
    WordSet& large = large_sets_.emplace_back();
    for (std::size_t i = sets_.size() - sets; i < sets_.size(); ++i) {
      for (const WordSet::Word& word : sets_[i].words()) {
        large.insert(word);
      }
    }
  }
}

void MetInWords::take_since_arrival(Element name, PairSet& pairs) const {
  for (std::size_t i = (*since_)[name]; i < arrivals_.size();) {
    const std::size_t left = arrivals_.size() - i;
    if (i % arrivals_of_a_large_set == 0 && left >= arrivals_of_a_large_set) {
      add_below(pairs, name, large_sets_[i / arrivals_of_a_large_set]);
      i += arrivals_of_a_large_set;
    } else if (i % arrivals_of_a_set == 0 && left >= arrivals_of_a_set) {
      add_below(pairs, name, sets_[i / arrivals_of_a_set]);
      i += arrivals_of_a_set;
    } else {
      if (arrivals_[i] < name) {
        if (count_ != nullptr) {
          *count_ += pairs.contains(name, arrivals_[i]) ? 0U : 1U;
        }
        pairs.insert(name, arrivals_[i]);
      }
      ++i;
    }
  }
}

void MetInWords::leave(Element name, PairSet& pairs) {
  take_since_arrival(name, pairs);
  held_.erase(name);
}

void MetInWords::settle(PairSet& pairs) {
  held_.for_each([&](Element name) {
    take_since_arrival(name, pairs);
    (*since_)[name] = 0;
  });
  arrivals_.clear();
  sets_.clear();
  large_sets_.clear();
}

void MetInWords::clear(PairSet& pairs) {
  settle(pairs);
  held_.clear();
}

namespace {

// Whether one bit for every pair takes no more memory than the list itself: then no pair is looked
// up in the list.
bool is_dense(const PairGraph& graph) {
  constexpr std::uint64_t bits_of_a_listed_pair = 64;
  return graph.items() <= max_elements_in_memory &&
         binomial(graph.items(), 2) <= bits_of_a_listed_pair * graph.pairs();
}

}  // namespace

MetPairs::MetPairs(const ScheduleRules& rules, const CheckOptions& options)
    : items_(rules.items),
      wanted_(rules.wanted),
      lockstep_(rules.lockstep > 0),
      by_worker_(options.by_worker),
      memories_(static_cast<std::size_t>(std::max<std::uint64_t>(1, rules.lockstep))) {
  const PairGraph* const graph = wanted_.graph();
  if (graph != nullptr) {
    loaded_.assign(static_cast<std::size_t>(items_), false);
  }
  if (graph != nullptr && !is_dense(*graph)) {
    some_.emplace(wanted_, items_);
  } else if (graph == nullptr && !options.all_pairs) {
    watch(options);
  } else if (items_ > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("{} items have too many pairs to track; give at most {}, or watch some items",
                    items_, max_elements_in_memory));
  } else {
    pairs_.emplace(items_);
    if (wanted_.are_all()) {
      name_pairs(options.kept_as);
    } else {
      leave_out_unwanted();
    }
    // With few items a word contains only one or two of them.
    constexpr std::uint64_t room_for_words = 32;
    const std::uint64_t room = std::min(rules.fast_room.value_or(rules.room), items_);
    if (room >= room_for_words) {
      since_.assign(static_cast<std::size_t>(items_), 0);
      for (Memory& memory : memories_) {
        memory.words.emplace(room, since_);
        if (by_worker_) {
          memory.words->count_in(count_);
        }
      }
    }
  }
}

void MetPairs::watch(const CheckOptions& options) {
  row_.assign(static_cast<std::size_t>(items_), 0);
  Random random(options.seed);
  const auto watch = [&](Element x) {
    if (row_[x] == 0) {
      watched_.push_back(x);
      row_[x] = static_cast<std::uint32_t>(watched_.size());
    }
  };
  // Constructions are most likely to be wrong at the ends.
  watch(0);
  watch(static_cast<Element>(items_ - 1));
  const std::uint64_t wanted = std::min(options.watched, items_);
  while (watched_.size() < wanted) {
    watch(random.below(static_cast<std::uint32_t>(items_)));
  }
  met_.assign(watched_.size(), std::vector<bool>(static_cast<std::size_t>(items_), false));
}

// Pairs that are not wanted are not missing. Where sets are wanted, an item has at most two runs of
// unwanted partners.
void MetPairs::leave_out_unwanted() {
  if (const PairGraph* const graph = wanted_.graph()) {
    std::vector<std::uint64_t> unwanted;
    for (Element x = 1; x < items_; ++x) {
      unwanted.assign((x + std::size_t{63}) / 64, ~std::uint64_t{0});
      for (const Element y : graph->partners(x)) {
        if (y >= x) {
          break;
        }
        unwanted[y / 64] &= ~(std::uint64_t{1} << y % 64);
      }
      for (std::size_t word = 0; word < unwanted.size(); ++word) {
        pairs_->insert_below(x, word, unwanted[word]);
      }
    }
    return;
  }
  for (Element x = 1; x < items_; ++x) {
    for (Element first = 0; first < x; first += 64) {
      const Element last = std::min(first + 63, x - 1);
      std::uint64_t bits = 0;
      if (wanted_.contains(first, x) == wanted_.contains(last, x)) {
        bits = wanted_.contains(first, x) ? 0 : ~std::uint64_t{0};
      } else {
        for (Element y = first; y <= last; ++y) {
          bits |= std::uint64_t{!wanted_.contains(y, x)} << (y - first);
        }
      }
      pairs_->insert_below(x, first / 64, bits);
    }
  }
}

void MetPairs::name_pairs(const std::vector<Element>& kept_as) {
  if (kept_as.empty()) {
    return;
  }
  std::vector<bool> seen(static_cast<std::size_t>(items_), false);
  for (const Element name : kept_as) {
    if (kept_as.size() != items_ || name >= items_ || seen[name]) {
      throw BadInput("the other names of the items are not a permutation of them");
    }
    seen[name] = true;
  }
  kept_as_ = kept_as;
}

void MetPairs::leave(std::size_t worker, Element x, std::size_t place) {
  Memory& own = memories_[worker];
  if (own.words) {
    own.words->leave(kept_as_.empty() ? x : kept_as_[x], *pairs_);
  } else if (pairs_) {
    own.kept[place] = own.kept.back();
    own.kept.pop_back();
  } else if (!row_.empty() && row_[x] != 0) {
    std::erase(own.watched, x);
  }
}

void MetPairs::see_wanted(Element x, const std::vector<Element>& memory,
                          const std::vector<std::uint32_t>& place) {
  const PairGraph* const graph = wanted_.graph();
  if (graph != nullptr && !lockstep_ && graph->partners(x).size() < memory.size()) {
    for (const Element y : graph->partners(x)) {
      if (place[y] != 0) {
        count_ += some_->insert(x, y) ? 1U : 0U;
      }
    }
  } else {
    for (const Element y : memory) {
      if (wanted_.contains(x, y)) {
        count_ += some_->insert(x, y) ? 1U : 0U;
      }
    }
  }
}

void MetPairs::arrive(std::size_t worker, Element x, const std::vector<Element>& memory,
                      const std::vector<std::uint32_t>& place) {
  Memory& own = memories_[worker];
  if (!loaded_.empty()) {
    loaded_[x] = true;
  }
  if (pairs_) {
    const Element name = kept_as_.empty() ? x : kept_as_[x];
    if (own.words) {
      own.words->arrive(name, *pairs_);
      return;
    }
    for (const Element other : own.kept) {
      if (by_worker_) {
        count_ += pairs_->contains(name, other) ? 0U : 1U;
      }
      pairs_->insert(name, other);
    }
    own.kept.push_back(name);
    return;
  }
  if (some_) {
    see_wanted(x, memory, place);
    return;
  }
  for (const Element y : own.watched) {
    met_[row_[y] - 1][x] = true;
  }
  if (row_[x] != 0) {
    std::vector<bool>& met = met_[row_[x] - 1];
    for (const Element y : memory) {
      met[y] = true;
    }
    own.watched.push_back(x);
  }
}

void MetPairs::clear(std::size_t worker) {
  Memory& own = memories_[worker];
  if (own.words) {
    own.words->clear(*pairs_);
  }
  own.kept.clear();
  own.watched.clear();
}

std::uint64_t MetPairs::take_count() {
  for (Memory& memory : memories_) {
    if (memory.words) {
      memory.words->settle(*pairs_);
    }
  }
  return std::exchange(count_, 0);
}

void MetPairs::report(ScheduleVerdict& verdict) {
  for (Memory& memory : memories_) {
    if (memory.words) {
      memory.words->settle(*pairs_);
    }
  }
  verdict.watched_items = row_.empty() ? items_ : watched_.size();
  const auto say = [&](Element x, Element y) {
    if (verdict.example.empty()) {
      verdict.example = fmt::format("{{{},{}}}", std::min(x, y), std::max(x, y));
    }
  };
  if (pairs_) {
    verdict.missing = pairs_->missing();
    const auto item = [&](Element name) {
      const auto found = std::ranges::find(kept_as_, name);
      return found == kept_as_.end() ? name : static_cast<Element>(found - kept_as_.begin());
    };
    pairs_->for_each_missing(1, [&](Element x, Element y) { say(item(x), item(y)); });
  }
  if (some_) {
    verdict.missing = some_->missing();
    if (const auto pair = some_->example()) {
      say(pair->first, pair->second);
    }
  }
  // An item without a partner counts as missing like a pair.
  for (Element x = 0; x < loaded_.size(); ++x) {
    if (wanted_.needs(x) && !loaded_[x] && wanted_.graph()->partners(x).empty()) {
      ++verdict.missing;
      say(x, x);
    }
  }
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    for (Element y = 0; y < items_; ++y) {
      if (!met_[i][y] && y != watched_[i] && wanted_.contains(y, watched_[i])) {
        ++verdict.missing;
        say(watched_[i], y);
      }
    }
  }
}

}  // namespace changeover
