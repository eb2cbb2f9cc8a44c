#include "loadorder/order/met_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "core/checked.hpp"
#include "run/random.hpp"

namespace changeover {

SeenPairs::SeenPairs(const WantedPairs& wanted, std::uint64_t items)
    : wanted_(wanted),
      items_(items),
      wanted_count_(wanted.are_all() ? binomial(items, 2) : wanted.count()) {
  if (wanted.graph() == nullptr && items > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("{} items have too many pairs to be followed one by one; {} is the most", items,
                    max_elements_in_memory));
  }
  seen_.assign(static_cast<std::size_t>(wanted.graph() != nullptr ? 2 * wanted.graph()->pairs()
                                                                  : binomial(items, 2)),
               false);
}

std::optional<ItemPair> SeenPairs::example() const {
  for (Element y = 0; y < items_ && missing() > 0; ++y) {
    const auto is_missing = [&](Element x) {
      return !seen_[static_cast<std::size_t>(
          wanted_.graph() != nullptr ? *wanted_.graph()->place(x, y) : PairSet::rank(x, y))];
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

MetInWords::MetInWords(std::uint64_t items)
    : words_(static_cast<std::size_t>(items / 64 + 1)),
      held_(words_, 0),
      since_(static_cast<std::size_t>(items), 0) {}

void MetInWords::arrive(Element name, PairSet& pairs) {
  pairs.insert_below(name, held_);
  held_[name / 64] |= std::uint64_t{1} << (name % 64);
  arrivals_.push_back(name);
  since_[name] = arrivals_.size();
  if (arrivals_.size() % arrivals_of_a_set == 0) {
    Set& set = sets_.emplace_back(words_, 0);
    for (std::size_t i = arrivals_.size() - arrivals_of_a_set; i < arrivals_.size(); ++i) {
      set[arrivals_[i] / 64] |= std::uint64_t{1} << (arrivals_[i] % 64);
    }
  }
}

void MetInWords::take_since_arrival(Element name, PairSet& pairs) const {
  const auto take_one_by_one = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (arrivals_[i] < name) {
        pairs.insert(name, arrivals_[i]);
      }
    }
  };
  const auto from = static_cast<std::size_t>(since_[name]);
  const std::size_t first = (from + arrivals_of_a_set - 1) / arrivals_of_a_set;
  if (first >= sets_.size()) {
    take_one_by_one(from, arrivals_.size());
    return;
  }
  take_one_by_one(from, first * arrivals_of_a_set);
  for (std::size_t s = first; s < sets_.size(); ++s) {
    pairs.insert_below(name, sets_[s]);
  }
  take_one_by_one(sets_.size() * arrivals_of_a_set, arrivals_.size());
}

void MetInWords::leave(Element name, PairSet& pairs) {
  take_since_arrival(name, pairs);
  held_[name / 64] &= ~(std::uint64_t{1} << (name % 64));
}

void MetInWords::settle(PairSet& pairs) {
  for (std::size_t i = 0; i < words_; ++i) {
    for (std::uint64_t rest = held_[i]; rest != 0; rest &= rest - 1) {
      take_since_arrival(
          static_cast<Element>(64 * i + static_cast<std::size_t>(std::countr_zero(rest))), pairs);
    }
  }
}

void MetInWords::clear(PairSet& pairs) {
  settle(pairs);
  std::fill(held_.begin(), held_.end(), 0);
  arrivals_.clear();
  sets_.clear();
}

MetPairs::MetPairs(const ScheduleRules& rules, const CheckOptions& options)
    : items_(rules.items), wanted_(rules.wanted) {
  if (wanted_.graph() != nullptr) {
    loaded_.assign(static_cast<std::size_t>(items_), false);
  }
  if (wanted_.graph() != nullptr || (options.all_pairs && !wanted_.are_all())) {
    some_.emplace(wanted_, items_);
  } else if (!options.all_pairs) {
    watch(options);
  } else if (items_ > max_elements_in_memory) {
    throw MissingResource(
        fmt::format("{} items have too many pairs to be followed one by one; {} is the most",
                    items_, max_elements_in_memory));
  } else {
    name_pairs(options.kept_as);
    pairs_.emplace(items_);
    // A row costs its words; without them an arrival costs a bit for each item that is there.
    constexpr std::uint64_t words_for_a_bit = 16;
    if (rules.room > items_ / words_for_a_bit) {
      words_.emplace(items_);
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
  // The ends are where a construction would go wrong.
  watch(0);
  watch(static_cast<Element>(items_ - 1));
  const std::uint64_t wanted = std::min(options.watched, items_);
  while (watched_.size() < wanted) {
    watch(random.below(static_cast<std::uint32_t>(items_)));
  }
  met_.assign(watched_.size(), std::vector<bool>(static_cast<std::size_t>(items_), false));
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

void MetPairs::leave(Element x, std::size_t place) {
  if (words_) {
    words_->leave(kept_as_.empty() ? x : kept_as_[x], *pairs_);
  } else if (pairs_) {
    kept_[place] = kept_.back();
    kept_.pop_back();
  } else if (!row_.empty() && row_[x] != 0) {
    std::erase(watched_now_, x);
  }
}

void MetPairs::arrive(Element x, const std::vector<Element>& memory,
                      const std::vector<std::uint32_t>& place) {
  if (pairs_) {
    const Element name = kept_as_.empty() ? x : kept_as_[x];
    if (words_) {
      words_->arrive(name, *pairs_);
      return;
    }
    for (const Element other : kept_) {
      pairs_->insert(name, other);
    }
    kept_.push_back(name);
    return;
  }
  if (some_) {
    const PairGraph* const graph = wanted_.graph();
    if (graph != nullptr && graph->partners(x).size() < memory.size()) {
      for (const Element y : graph->partners(x)) {
        if (place[y] != 0) {
          some_->insert(x, y);
        }
      }
    } else {
      for (const Element y : memory) {
        if (wanted_.contains(x, y)) {
          some_->insert(x, y);
        }
      }
    }
    if (!loaded_.empty()) {
      loaded_[x] = true;
    }
    return;
  }
  for (const Element y : watched_now_) {
    met_[row_[y] - 1][x] = true;
  }
  if (row_[x] != 0) {
    std::vector<bool>& met = met_[row_[x] - 1];
    for (const Element y : memory) {
      met[y] = true;
    }
    watched_now_.push_back(x);
  }
}

void MetPairs::clear() {
  if (words_) {
    words_->clear(*pairs_);
  }
  kept_.clear();
  watched_now_.clear();
}

void MetPairs::report(ScheduleVerdict& verdict) {
  if (words_) {
    words_->settle(*pairs_);
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
      const auto found = std::find(kept_as_.begin(), kept_as_.end(), name);
      return found == kept_as_.end() ? name : static_cast<Element>(found - kept_as_.begin());
    };
    pairs_->for_each_missing(1, [&](Element x, Element y) { say(item(x), item(y)); });
    return;
  }
  if (some_) {
    verdict.missing = some_->missing();
    if (const auto pair = some_->example()) {
      say(pair->first, pair->second);
    }
    // An item without a partner is missed like a pair.
    for (Element x = 0; x < loaded_.size(); ++x) {
      if (wanted_.needs(x) && !loaded_[x] && wanted_.graph()->partners(x).empty()) {
        ++verdict.missing;
        say(x, x);
      }
    }
    return;
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
