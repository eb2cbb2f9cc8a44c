#include "changeover/loadorder/load_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/scope.hpp"
#include "loadorder/pairs/wanted_set.hpp"
#include "run/random.hpp"

namespace changeover {

LoadCheck::LoadCheck(std::uint64_t items, std::uint64_t room, const LoadCheckOptions& options)
    : items_(items), room_(room), wanted_(options.wanted) {
  if (items == 0 || room == 0) {
    throw BadInput(fmt::format("a load order of {} items with room for {}: give at least 1 of both",
                               items, room));
  }
  if (!wanted_.are_all() && wanted_.items() != items) {
    throw BadInput(fmt::format("pairs of {} items are wanted of {}", wanted_.items(), items));
  }
  place_.assign(static_cast<std::size_t>(items), 0);
  if (wanted_.graph() != nullptr) {
    loaded_.assign(static_cast<std::size_t>(items), false);
    some_ = std::make_unique<WantedSet>(wanted_, items);
    verdict_.watched_items = items;
    return;
  }
  if (options.all_pairs) {
    if (items > max_elements_in_memory) {
      throw MissingResource(
          fmt::format("{} items have too many pairs to be followed one by one; {} is the most",
                      items, max_elements_in_memory));
    }
    if (!wanted_.are_all()) {
      some_ = std::make_unique<WantedSet>(wanted_, items);
      verdict_.watched_items = items;
      return;
    }
    name_pairs(options.kept_as);
    pairs_ = std::make_unique<PairSet>(items);
    verdict_.watched_items = items;
    return;
  }
  row_.assign(static_cast<std::size_t>(items), 0);
  Random random(options.seed);
  const auto watch = [&](Element x) {
    if (row_[x] == 0) {
      watched_.push_back(x);
      row_[x] = static_cast<std::uint32_t>(watched_.size());
    }
  };
  // The ends are where a construction would go wrong.
  watch(0);
  watch(static_cast<Element>(items - 1));
  const std::uint64_t wanted = std::min(options.watched, items);
  while (watched_.size() < wanted) {
    watch(random.below(static_cast<std::uint32_t>(items)));
  }
  met_.assign(watched_.size(), std::vector<bool>(static_cast<std::size_t>(items), false));
  verdict_.watched_items = watched_.size();
}

LoadCheck::~LoadCheck() = default;
LoadCheck::LoadCheck(LoadCheck&&) noexcept = default;

void LoadCheck::name_pairs(const std::vector<Element>& kept_as) {
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

void LoadCheck::fail(std::string fault) {
  if (verdict_.fault.empty()) {
    verdict_.fault = std::move(fault);
  }
}

void LoadCheck::evict(Element x) {
  const std::uint32_t place = place_[x] - 1;
  const Element moved = memory_.back();
  memory_[place] = moved;
  place_[moved] = place + 1;
  memory_.pop_back();
  if (pairs_) {
    kept_[place] = kept_.back();
    kept_.pop_back();
  }
  place_[x] = 0;
  if (!row_.empty() && row_[x] != 0) {
    std::erase(watched_now_, x);
  }
}

void LoadCheck::load(Element x) {
  if (pairs_) {
    const Element name = kept_as_.empty() ? x : kept_as_[x];
    for (const Element other : kept_) {
      pairs_->insert(name, other);
    }
    kept_.push_back(name);
  } else if (some_) {
    some_->insert_all(
        x, memory_, [&](Element y) { return place_[y] != 0; }, [](Element) {});
    if (!loaded_.empty()) {
      loaded_[x] = true;
    }
  } else {
    for (const Element y : watched_now_) {
      met_[row_[y] - 1][x] = true;
    }
    if (row_[x] != 0) {
      std::vector<bool>& met = met_[row_[x] - 1];
      for (const Element y : memory_) {
        met[y] = true;
      }
      watched_now_.push_back(x);
    }
  }
  memory_.push_back(x);
  place_[x] = static_cast<std::uint32_t>(memory_.size());
}

void LoadCheck::read(const LoadStep& step) {
  if (!verdict_.fault.empty()) {
    return;
  }
  ++verdict_.steps;
  if (step.number != ++number_) {
    return fail(fmt::format("step {} is numbered {}", number_, step.number));
  }
  for (const Element x : step.evict) {
    if (x >= items_ || place_[x] == 0) {
      return fail(fmt::format("step {} evicts {}, which is not in memory", step.number, x));
    }
    evict(x);
  }
  for (const Element x : step.load) {
    if (x >= items_) {
      return fail(fmt::format("step {} loads {}, which is not an item", step.number, x));
    }
    if (place_[x] != 0) {
      return fail(fmt::format("step {} loads {}, which is in memory", step.number, x));
    }
    if (memory_.size() == room_) {
      return fail(fmt::format("step {} loads {} when memory is full", step.number, x));
    }
    load(x);
  }
  verdict_.loads += step.load.size();
  verdict_.most_in_memory = std::max<std::uint64_t>(verdict_.most_in_memory, memory_.size());
}

void LoadCheck::start_over() {
  for (const Element x : memory_) {
    place_[x] = 0;
  }
  memory_.clear();
  kept_.clear();
  watched_now_.clear();
  number_ = 0;
}

LoadVerdict LoadCheck::finish() const {
  LoadVerdict verdict = verdict_;
  const auto say = [&](Element x, Element y) {
    if (verdict.uncovered_example.empty()) {
      verdict.uncovered_example = fmt::format("{{{},{}}}", std::min(x, y), std::max(x, y));
    }
  };
  if (pairs_) {
    verdict.uncovered = pairs_->missing();
    const auto item = [&](Element name) {
      const auto found = std::find(kept_as_.begin(), kept_as_.end(), name);
      return found == kept_as_.end() ? name : static_cast<Element>(found - kept_as_.begin());
    };
    pairs_->for_each_missing(1, [&](Element x, Element y) { say(item(x), item(y)); });
    return verdict;
  }
  if (some_) {
    verdict.uncovered = some_->missing();
    if (const auto pair = some_->example()) {
      say(pair->first, pair->second);
    }
    // An item without a partner is missed like a pair.
    for (Element x = 0; x < loaded_.size(); ++x) {
      if (wanted_.needs(x) && !loaded_[x] && wanted_.graph()->partners(x).empty()) {
        ++verdict.uncovered;
        say(x, x);
      }
    }
    return verdict;
  }
  for (std::size_t i = 0; i < watched_.size(); ++i) {
    for (Element y = 0; y < items_; ++y) {
      if (!met_[i][y] && y != watched_[i] && wanted_.contains(y, watched_[i])) {
        ++verdict.uncovered;
        say(watched_[i], y);
      }
    }
  }
  return verdict;
}

LoadVerdict check_loads(StepSource& steps, std::uint64_t items, std::uint64_t room,
                        const LoadCheckOptions& options) {
  LoadCheck check(items, room, options);
  LoadStep step;
  constexpr std::uint64_t steps_between_looks = 4096;
  for (std::uint64_t count = 0; steps.next(step); ++count) {
    check.read(step);
    if (count % steps_between_looks == 0) {
      stop_if_asked();
      if (progress_due()) {
        report_progress({.phase = "checking the load order", .steps = count, .unit = "steps"});
      }
    }
  }
  return check.finish();
}

}  // namespace changeover
