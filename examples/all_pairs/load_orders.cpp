#include "load_orders.hpp"

#include <algorithm>
#include <list>
#include <memory>
#include <numeric>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {
namespace {

using Steps = std::vector<Step>;

class ListedSteps final : public StepSource {
 public:
  explicit ListedSteps(std::shared_ptr<const Steps> steps) : steps_(std::move(steps)) {}

  bool next(Step& step) override {
    if (position_ == steps_->size()) {
      return false;
    }
    step = (*steps_)[position_++];
    return true;
  }

 private:
  std::shared_ptr<const Steps> steps_;
  std::size_t position_ = 0;
};

LoadOrder listed(std::uint64_t items, std::uint64_t room, std::string method,
                 std::string explanation, Steps list) {
  LoadOrderFacts facts;
  facts.items = items;
  facts.room = room;
  facts.bound = load_lower_bound(items, room);
  facts.method = std::move(method);
  facts.explanation = std::move(explanation);
  facts.steps = list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].number = i + 1;
    facts.loads += list[i].load.size();
  }
  auto steps = std::make_shared<const Steps>(std::move(list));
  return {std::move(facts), [steps] { return std::make_unique<ListedSteps>(steps); }};
}

void check(std::uint64_t items, std::uint64_t room) {
  static_cast<void>(load_lower_bound(items, room));
  if (items > max_elements_in_memory) {
    throw ImpossibleParameters("orders for comparison are made for at most 65535 items");
  }
}

Step first_step(std::uint64_t count) {
  Step step;
  step.load.resize(static_cast<std::size_t>(count));
  std::iota(step.load.begin(), step.load.end(), 0U);
  return step;
}

Step exchange(Element in, Element out) { return {0, {out}, {in}}; }

// Rounds of C−1 held items, the last place being the last entry of `memory`. With `hold_the_last`,
// what passed last counts among those to be held next and one of the old ones becomes the place to
// pass.
Steps rounds(std::uint64_t items, std::uint64_t room, bool hold_the_last) {
  Steps steps{first_step(std::min(items, room))};
  if (items <= room) {
    return steps;
  }
  const auto held = static_cast<std::size_t>(room - 1);
  std::vector<Element> memory = steps.front().load;
  std::vector<Element> rest;  // not done, not in memory
  for (auto x = static_cast<Element>(room); x < items; ++x) {
    rest.push_back(x);
  }
  while (true) {
    // Pass all that is not done through the last place.
    std::vector<Element> passed;
    for (const Element x : rest) {
      steps.push_back(exchange(x, memory.back()));
      passed.push_back(memory.back());
      memory.back() = x;
    }
    // Those held are done. Others take their places.
    rest = std::move(passed);
    if (rest.empty()) {
      return steps;
    }
    if (hold_the_last) {
      std::rotate(memory.begin(), memory.end() - 1, memory.end());
    }
    const std::size_t from = hold_the_last ? 1 : 0;
    for (std::size_t i = from; i < held + from && !rest.empty(); ++i) {
      steps.push_back(exchange(rest.front(), memory[i]));
      memory[i] = rest.front();
      rest.erase(rest.begin());
    }
    if (rest.empty()) {
      return steps;
    }
  }
}

/// Items asked for two at a time through a cache that evicts what was used longest ago.
class LeastRecentlyUsed {
 public:
  LeastRecentlyUsed(std::uint64_t items, std::uint64_t room)
      : room_(room), where_(static_cast<std::size_t>(items), order_.end()) {}

  void ask(Element x, Element y) {
    Step step;
    touch(x, step);
    touch(y, step);
    if (!step.load.empty()) {
      steps_.push_back(std::move(step));
    }
  }

  [[nodiscard]] Steps take() { return std::move(steps_); }

 private:
  void touch(Element x, Step& step) {
    if (where_[x] != order_.end()) {
      order_.splice(order_.begin(), order_, where_[x]);
      return;
    }
    if (order_.size() == room_) {
      step.evict.push_back(order_.back());
      where_[order_.back()] = order_.end();
      order_.pop_back();
    }
    order_.push_front(x);
    where_[x] = order_.begin();
    step.load.push_back(x);
  }

  std::uint64_t room_;
  std::list<Element> order_;  // most recently used first
  std::vector<std::list<Element>::iterator> where_;
  Steps steps_;
};

Steps single_item() { return {first_step(1)}; }

}  // namespace

LoadOrder beta_order(std::uint64_t items, std::uint64_t room) {
  check(items, room);
  return listed(items, room, "beta",
                "Keep C-1 items, pass all others, replace the C-1, repeat on the rest.",
                rounds(items, room, false));
}

LoadOrder hold_order(std::uint64_t items, std::uint64_t room) {
  check(items, room);
  return listed(items, room, "hold",
                "Hold C-1 items, stream the rest, hold the last one and others, repeat.",
                rounds(items, room, true));
}

LoadOrder tiles_order(std::uint64_t items, std::uint64_t room) {
  check(items, room);
  const std::uint64_t side = room / 2;
  LeastRecentlyUsed cache(items, room);
  for (std::uint64_t row = 0; row < items; row += side) {
    for (std::uint64_t column = row; column < items; column += side) {
      for (std::uint64_t x = row; x < std::min(row + side, items); ++x) {
        for (std::uint64_t y = std::max(column, x + 1); y < std::min(column + side, items); ++y) {
          cache.ask(static_cast<Element>(x), static_cast<Element>(y));
        }
      }
    }
  }
  return listed(items, room, "tiles", "Square tiles of C/2 by C/2, least recently used goes.",
                items == 1 ? single_item() : cache.take());
}

LoadOrder exhaustive_order(std::uint64_t items, std::uint64_t room) {
  check(items, room);
  const std::uint64_t side = room / 2;
  LeastRecentlyUsed cache(items, room);
  for (std::uint64_t first = 0; first < items; first += side) {
    for (std::uint64_t second = 0; second < items; second += side) {
      for (std::uint64_t x = first; x < std::min(first + side, items); ++x) {
        for (std::uint64_t y = second; y < std::min(second + side, items); ++y) {
          // Each pair in one of the two orders of its blocks, half of them each time.
          if ((x > y && x % side <= y % side) || (x < y && x % side < y % side)) {
            cache.ask(static_cast<Element>(x), static_cast<Element>(y));
          }
        }
      }
    }
  }
  return listed(items, room, "exhaustive",
                "Every block of C/2 against every block, least recently used goes.",
                items == 1 ? single_item() : cache.take());
}

LoadOrder comet_order(std::uint64_t items, std::uint64_t room, std::uint64_t group) {
  check(items, room);
  if (group == 0 || items % group != 0 || room % group != 0 || room / group < 2) {
    throw BadInput("COMET has groups that divide all items and the room, which has two or more");
  }
  const auto members = [group](const std::vector<Element>& groups) {
    std::vector<Element> all;
    for (const Element each : groups) {
      for (std::uint64_t i = 0; i < group; ++i) {
        all.push_back(static_cast<Element>(each * group + i));
      }
    }
    return all;
  };
  LoadOrder of_groups = beta_order(items / group, room / group);
  Steps steps;
  for (Step step; of_groups.next(step);) {
    step.load = members(step.load);
    step.evict = members(step.evict);
    steps.push_back(step);
  }
  return listed(items, room, "comet", "BETA of groups of items.", std::move(steps));
}

LoadOrder cover_order(std::uint64_t items) {
  constexpr std::uint64_t room = 4;
  check(items, room);
  unsigned dimension = 0;
  for (std::uint64_t count = 1; count < items; count *= 4) {
    ++dimension;
  }
  if (dimension == 0 || items != std::uint64_t{1} << (2 * dimension)) {
    throw BadInput("COVER has 4, 16, 64, ... partitions");
  }
  // In the field of 4 elements sums are those of bits, and 2 is a root of x^2 + x + 1.
  const auto times = [&](unsigned scalar, std::uint64_t point) {
    std::uint64_t product = 0;
    for (unsigned i = 0; i < dimension; ++i) {
      const auto digit = static_cast<unsigned>(point >> (2 * i) & 3U);
      const unsigned by_two = digit == 0 ? 0 : digit == 3 ? 1 : digit + 1;
      const unsigned its = scalar == 0   ? 0
                           : scalar == 1 ? digit
                           : scalar == 2 ? by_two
                                         : digit ^ by_two;
      product |= std::uint64_t{its} << (2 * i);
    }
    return product;
  };
  Steps steps;
  for (std::uint64_t direction = 1; direction < items; ++direction) {
    if (times(2, direction) < direction || times(3, direction) < direction) {
      continue;  // the same lines as of another one
    }
    for (std::uint64_t point = 0; point < items; ++point) {
      Step step;
      for (unsigned scalar = 0; scalar < 4; ++scalar) {
        step.load.push_back(static_cast<Element>(point ^ times(scalar, direction)));
      }
      if (*std::min_element(step.load.begin(), step.load.end()) == point) {
        step.evict = steps.empty() ? std::vector<Element>() : steps.back().load;
        steps.push_back(std::move(step));
      }
    }
  }
  return listed(items, room, "cover", "The lines of an affine space over the field of 4 elements.",
                std::move(steps));
}

std::vector<LoadOrder> baseline_orders(std::uint64_t items, std::uint64_t room) {
  std::vector<LoadOrder> orders;
  orders.push_back(beta_order(items, room));
  orders.push_back(hold_order(items, room));
  orders.push_back(tiles_order(items, room));
  orders.push_back(exhaustive_order(items, room));
  return orders;
}

}  // namespace changeover
