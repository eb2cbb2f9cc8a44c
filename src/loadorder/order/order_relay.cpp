#include "loadorder/order/order_relay.hpp"

#include <algorithm>
#include <utility>

#include "core/bit_scan.hpp"

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
    std::ranges::fill(place.present, 0);
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

}  // namespace

std::unique_ptr<StepSource> stretch_steps(std::shared_ptr<OrderRelay> relay, const LoadOrder& order,
                                          std::uint64_t first, std::uint64_t count,
                                          std::uint64_t items, std::uint64_t worker) {
  return std::make_unique<Stretch>(std::move(relay), order, first, count, items, worker);
}

}  // namespace changeover
