#include "loadorder/shares/stretches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/bit_scan.hpp"
#include "loadorder/order/streamed_order.hpp"

namespace changeover {

bool OrderRelay::Place::next(Step& next_step) {
  if (!order->next(next_step)) {
    return false;
  }
  ++step;
  const auto mark = [](std::vector<std::uint64_t>& there, const Step& from, auto leave, auto come) {
    for (const Element x : from.*leave) {
      there[x / 64] &= ~(std::uint64_t{1} << x % 64);
    }
    for (const Element x : from.*come) {
      there[x / 64] |= std::uint64_t{1} << x % 64;
    }
  };
  mark(present, next_step, &Step::evict, &Step::load);
  mark(fast, next_step, &Step::fast_evict, &Step::fast_load);
  return true;
}

// Where reading can begin anywhere, the steps between are not read.
OrderRelay::Place OrderRelay::take(const LoadOrder& order, std::uint64_t before) {
  Place place;
  {
    const std::scoped_lock lock(mutex_);
    if (left_.order && left_.step < before) {
      place = std::exchange(left_, {});
    }
  }
  if (!place.order) {
    const std::vector<std::uint64_t> nothing(
        static_cast<std::size_t>(order.facts().items / 64 + 1));
    place = {order.stream(), 0, nothing, nothing};
  }
  std::vector<Element> held;
  if (place.step + 1 < before && place.order->jump(before, held)) {
    place.step = before - 1;
    std::fill(place.present.begin(), place.present.end(), 0);
    for (const Element x : held) {
      place.present[x / 64] |= std::uint64_t{1} << x % 64;
    }
  }
  return place;
}

void OrderRelay::give(Place place) {
  const std::scoped_lock lock(mutex_);
  left_ = std::move(place);
}

namespace {

/// Steps `first` to `first + count − 1` of an order of groups, as steps of items.
class Stretch final : public StepSource {
 public:
  Stretch(std::shared_ptr<OrderRelay> relay, const LoadOrder& order, std::uint64_t first,
          std::uint64_t count, std::uint64_t items, std::uint64_t worker)
      : worker_(worker),
        relay_(std::move(relay)),
        at_(count == 0 ? OrderRelay::Place() : relay_->take(order, first)),
        first_(first),
        count_(count),
        items_(items),
        groups_(order.facts().items),
        two_levels_(order.facts().fast_room) {}
  ~Stretch() override {
    if (done_ == count_ && at_.order) {
      relay_->give(std::move(at_));
    }
  }
  Stretch(const Stretch&) = delete;
  Stretch& operator=(const Stretch&) = delete;

  bool next(Step& step) override {
    if (done_ == count_ || !(done_ == 0 ? start() : at_.next(inner_))) {
      return false;
    }
    step.number = ++done_;
    step.worker = worker_;
    step.epoch = inner_.epoch;
    step.evict.clear();
    step.load.clear();
    for (const Element group : inner_.evict) {
      expand(group, step.evict);
    }
    for (const Element group : inner_.load) {
      expand(group, step.load);
    }
    if (two_levels_) {  // whose items are not grouped
      step.fast_evict = inner_.fast_evict;
      step.fast_load = inner_.fast_load;
    }
    return true;
  }

 private:
  // The first step loads what is in memory then.
  bool start() {
    while (at_.step < first_) {
      if (!at_.next(inner_)) {
        return false;
      }
    }
    for (std::vector<Element>* const list :
         {&inner_.evict, &inner_.load, &inner_.fast_evict, &inner_.fast_load}) {
      list->clear();
    }
    const auto put = [](const std::vector<std::uint64_t>& there, std::vector<Element>& into) {
      for (std::uint64_t x = next_bit(there, 0, 0); x < 64 * there.size();
           x = next_bit(there, x + 1, 0)) {
        into.push_back(static_cast<Element>(x));
      }
    };
    put(at_.present, inner_.load);
    put(at_.fast, inner_.fast_load);
    return true;
  }

  void expand(Element group, std::vector<Element>& out) const {
    const auto begin = static_cast<Element>(group * items_ / groups_);
    const auto end = static_cast<Element>((group + std::uint64_t{1}) * items_ / groups_);
    for (Element x = begin; x < end; ++x) {
      out.push_back(x);
    }
  }

  std::uint64_t worker_;
  std::shared_ptr<OrderRelay> relay_;
  OrderRelay::Place at_;
  std::uint64_t first_, count_, items_, groups_;
  bool two_levels_;
  std::uint64_t done_ = 0;
  Step inner_;
};

/// What a stretch of a streamed order computes.
class StreamedRule final : public PairRule {
 public:
  StreamedRule(const StreamedPairs& pairs, const WorkerFacts& facts, std::vector<Element> arrived)
      : pairs_(pairs), first_(facts.first_step), arrived_(std::move(arrived)) {}

  [[nodiscard]] bool computes(std::uint64_t step, Element x, Element y) const override {
    const std::uint64_t in_order = first_ + step - 1;
    if (x == y) {
      return pairs_.first_load(x) == in_order;
    }
    // What was there before the first step has met before it.
    const auto arrived = [&](Element z) {
      return std::find(arrived_.begin(), arrived_.end(), z) != arrived_.end();
    };
    return (step > 1 || first_ == 1 || arrived(x) || arrived(y)) &&
           pairs_.meet_first(in_order, x, y);
  }

 private:
  const StreamedPairs& pairs_;
  std::uint64_t first_;
  std::vector<Element> arrived_;  // by the first step
};

class StreamedOwners final : public PairOwners {
 public:
  StreamedOwners(const LoadOrder& order, std::vector<WorkerFacts> workers)
      : pairs_(best_streamed_shape(order.facts().items, order.facts().room)),
        order_(order.facts(), [order_maker = order.maker()] { return order_maker(); }),
        workers_(std::move(workers)) {}

  [[nodiscard]] std::unique_ptr<const PairRule> of(std::uint64_t worker) const override {
    const WorkerFacts& facts = workers_[static_cast<std::size_t>(worker)];
    Step step;
    if (facts.first_step > 1) {
      const auto steps = order_.stream();
      std::vector<Element> held;
      if (!steps->jump(facts.first_step, held) || !steps->next(step)) {
        throw InternalError("a streamed load order has no step where a worker begins");
      }
    }
    return std::make_unique<StreamedRule>(pairs_, facts, std::move(step.load));
  }

 private:
  StreamedPairs pairs_;
  LoadOrder order_;
  std::vector<WorkerFacts> workers_;
};

/// Steps under the numbers that they have in the order.
class Renumbered final : public StepSource {
 public:
  Renumbered(std::unique_ptr<StepSource> steps, std::uint64_t before)
      : steps_(std::move(steps)), before_(before) {}

  bool next(Step& step) override {
    if (!steps_->next(step)) {
      return false;
    }
    step.number += before_;
    return true;
  }

 private:
  std::unique_ptr<StepSource> steps_;
  std::uint64_t before_;
};

}  // namespace

std::unique_ptr<StepSource> stretch_steps(std::shared_ptr<OrderRelay> relay, const LoadOrder& order,
                                          std::uint64_t first, std::uint64_t count,
                                          std::uint64_t items, std::uint64_t worker) {
  return std::make_unique<Stretch>(std::move(relay), order, first, count, items, worker);
}

std::unique_ptr<StepSource> LoadOrder::stream_from(std::uint64_t step) const {
  if (step == 0 || step > facts_.steps || facts_.lockstep > 0) {
    throw BadInput(facts_.lockstep > 0
                       ? std::string("an order for workers in lockstep is read from its first step")
                       : fmt::format("there is no step {}: the order has {}; count from 1", step,
                                     facts_.steps));
  }
  return std::make_unique<Renumbered>(stretch_steps(std::make_shared<OrderRelay>(), *this, step,
                                                    facts_.steps - step + 1, facts_.items, 0),
                                      step - 1);
}

std::shared_ptr<const GroupOwners> owners_of_stretches(const LoadOrder& order,
                                                       const std::vector<WorkerFacts>& workers,
                                                       std::uint64_t items) {
  const std::uint64_t groups = order.facts().items;
  auto owners = std::make_shared<GroupOwners>(ItemGroups{items, groups}, workers.size());
  const auto relay = std::make_shared<OrderRelay>();
  std::vector<std::uint64_t> met(static_cast<std::size_t>(groups * groups), 0);  // by worker plus 1
  for (std::uint64_t w = 0; w < workers.size(); ++w) {
    const WorkerFacts& facts = workers[static_cast<std::size_t>(w)];
    const auto steps = stretch_steps(relay, order, facts.first_step, facts.steps, groups, w);
    std::vector<Element> memory;
    for (Step step; steps->next(step);) {
      for (const Element group : step.evict) {
        std::erase(memory, group);
      }
      for (const Element group : step.load) {
        memory.push_back(group);
        for (const Element other : memory) {
          const std::uint64_t place = std::max(group, other) * groups + std::min(group, other);
          if (std::exchange(met[static_cast<std::size_t>(place)], w + 1) != w + 1) {
            owners->add(w, group, other, step.number);
          }
        }
      }
    }
  }
  owners->balance();
  return owners;
}

std::shared_ptr<const PairOwners> owners_of_streamed_stretches(const LoadOrder& order,
                                                               std::vector<WorkerFacts> workers) {
  return std::make_shared<StreamedOwners>(order, std::move(workers));
}

StepSizes::StepSizes(const LoadOrder& order, std::uint64_t items, std::uint64_t load,
                     std::uint64_t transfer) {
  const LoadOrderFacts& whole = order.facts();
  const auto size = [&](const std::vector<Element>& groups, const std::vector<Element>& fast) {
    std::uint64_t sum = 0;
    for (const Element group : groups) {
      sum += (group + std::uint64_t{1}) * items / whole.items - group * items / whole.items;
    }
    return sum * load + fast.size() * transfer;
  };
  held_.reserve(static_cast<std::size_t>(whole.steps));
  loaded_.reserve(static_cast<std::size_t>(whole.steps) + 1);
  loaded_.push_back(0);
  std::uint64_t held = 0;
  const auto steps = order.stream();
  for (Step step; steps->next(step);) {
    stop_if_asked();
    const std::uint64_t loads = size(step.load, step.fast_load);
    held += loads - size(step.evict, step.fast_evict);
    held_.push_back(held);
    loaded_.push_back(loaded_.back() + loads);
  }
}

// The most steps from `first` on with at most so many loads.
std::uint64_t StepSizes::fitting(std::uint64_t first, std::uint64_t most) const {
  if (held_[first] > most) {
    return 0;
  }
  const auto begin = loaded_.begin() + static_cast<std::ptrdiff_t>(first + 1);
  const std::uint64_t left = most - held_[first] + *begin;
  return static_cast<std::uint64_t>(std::upper_bound(begin, loaded_.end(), left) - begin);
}

// As many shares as needed, so that none has more than `most` loads; nothing if a step alone has
// more.
std::vector<std::uint64_t> StepSizes::shares(std::uint64_t most) const {
  std::vector<std::uint64_t> counts;
  for (std::uint64_t first = 0; first < steps();) {
    const std::uint64_t count = fitting(first, most);
    if (count == 0) {
      return {};
    }
    counts.push_back(count);
    first += count;
  }
  return counts;
}

std::vector<std::uint64_t> StepSizes::best_shares(std::uint64_t workers) const {
  std::uint64_t low = 1;
  std::uint64_t high = loaded_.back();
  const auto fits = [&](const std::vector<std::uint64_t>& counts) {
    return !counts.empty() && counts.size() <= workers;
  };
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    fits(shares(middle)) ? high = middle : low = middle + 1;
  }
  return shares(high);
}

}  // namespace changeover
