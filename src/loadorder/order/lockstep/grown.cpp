#include "loadorder/order/lockstep/grown.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace changeover {
namespace {

constexpr std::uint32_t no_holder = ~std::uint32_t{0};

class Growth {
 public:
  Growth(std::uint64_t items, std::uint64_t room, std::uint64_t workers, GrowthRule rule,
         Random& random)
      : items_(static_cast<std::size_t>(items)),
        room_(static_cast<std::size_t>(room)),
        rule_(rule),
        random_(random),
        open_(items_ * items_, 1),
        open_pairs_(items_, static_cast<std::uint32_t>(items - 1)),
        holder_(items_, no_holder),
        arrival_(items_, 0),
        memory_(static_cast<std::size_t>(workers)),
        gain_(memory_.size(), std::vector<std::uint32_t>(items_, 0)),
        moved_(memory_.size(), false),
        left_(items * (items - 1) / 2) {
    for (std::size_t x = 0; x < items_; ++x) {
      open_[x * items_ + x] = 0;
    }
    Element next = 0;
    for (std::uint32_t w = 0; w < memory_.size(); ++w) {
      for (std::size_t i = 0; i < room_; ++i) {
        load(w, next++);
      }
    }
  }

  [[nodiscard]] bool done() const { return left_ == 0; }
  GrownOrder& order() { return order_; }

  void repeat(const std::vector<LockstepChange>& step) {
    order_.steps.emplace_back();
    for (const LockstepChange& change : step) {
      evict(change.worker, change.out);
    }
    for (const LockstepChange& change : step) {
      load(change.worker, change.in);
      note(change);
    }
  }

  void step() {
    order_.steps.emplace_back();
    std::fill(moved_.begin(), moved_.end(), false);
    const std::uint64_t before = left_;
    const auto workers = static_cast<std::uint32_t>(memory_.size());
    const auto first = static_cast<std::uint32_t>(order_.steps.size() % workers);
    for (std::uint32_t i = 0; i < workers; ++i) {
      const std::uint32_t w = (first + i) % workers;
      if (!moved_[w]) {
        move(w, before, i + 1 == workers);
      }
    }
  }

 private:
  [[nodiscard]] bool is_open(Element x, Element y) const { return open_[x * items_ + y] != 0; }

  void note(const LockstepChange& change) {
    order_.steps.back().push_back(change);
    ++order_.changes;
  }

  void load(std::uint32_t w, Element x) {
    for (const Element y : memory_[w]) {
      if (is_open(x, y)) {
        open_[x * items_ + y] = open_[y * items_ + x] = 0;
        --open_pairs_[x];
        --open_pairs_[y];
        --gain_[w][x];
        --left_;
      }
    }
    const std::uint8_t* row = &open_[x * items_];
    for (std::size_t y = 0; y < items_; ++y) {
      gain_[w][y] += row[y];
    }
    memory_[w].push_back(x);
    holder_[x] = w;
    arrival_[x] = ++clock_;
  }

  void evict(std::uint32_t w, Element x) {
    const std::uint8_t* row = &open_[x * items_];
    for (std::size_t y = 0; y < items_; ++y) {
      gain_[w][y] -= row[y];
    }
    std::erase(memory_[w], x);
    holder_[x] = no_holder;
  }

  void change(std::uint32_t w, Element out, Element in) {
    evict(w, out);
    load(w, in);
    note({w, out, in});
    moved_[w] = true;
  }

  // Of the items that no worker holds, one that brings most pairs to worker w; nullopt if all are
  // held.
  std::optional<Element> best_to_come(std::uint32_t w) {
    std::optional<Element> best;
    std::uint64_t best_key = 0;
    for (Element y = 0; y < items_; ++y) {
      if (holder_[y] != no_holder) {
        continue;
      }
      using Comes = GrowthRule::Comes;
      const std::uint64_t order = rule_.comes == Comes::any               ? 0
                                  : rule_.comes == Comes::most_open_pairs ? open_pairs_[y]
                                                                          : items_ - open_pairs_[y];
      const std::uint64_t key =
          (std::uint64_t{gain_[w][y]} << 48) | (order << 24) | (random_.next32() >> 8);
      if (!best || key > best_key) {
        best = y;
        best_key = key;
      }
    }
    return best;
  }

  // The most pairs that any item would bring to w after `in` has replaced `out`.
  [[nodiscard]] std::uint64_t gain_afterwards(std::uint32_t w, Element out, Element in) const {
    std::uint32_t most = 0;
    const std::uint8_t* gone = &open_[out * items_];
    const std::uint8_t* come = &open_[in * items_];
    for (std::size_t y = 0; y < items_; ++y) {
      if (holder_[y] == no_holder && y != in) {
        most = std::max<std::uint32_t>(most, gain_[w][y] + come[y] - gone[y]);
      }
    }
    return most;
  }

  Element best_to_go(std::uint32_t w, Element in) {
    using Goes = GrowthRule::Goes;
    Element best = memory_[w].front();
    std::uint64_t best_key = std::numeric_limits<std::uint64_t>::max();
    for (const Element x : memory_[w]) {
      std::uint64_t order = 0;
      switch (rule_.goes) {
        case Goes::fewest_open_pairs:
          order = open_pairs_[x];
          break;
        case Goes::last_come:
          order = open_pairs_[x] == 0 ? 0 : clock_ + 1 - arrival_[x];
          break;
        case Goes::first_come:
          order = arrival_[x];
          break;
        case Goes::best_afterwards:
          order = ((items_ - gain_afterwards(w, x, in)) << 16) | open_pairs_[x];
          break;
      }
      const std::uint64_t key =
          (std::uint64_t{is_open(x, in)} << 62) | (order << 16) | (random_.next32() >> 16);
      if (key < best_key) {
        best = x;
        best_key = key;
      }
    }
    return best;
  }

  struct Exchange {
    std::uint32_t with = no_holder;
    Element theirs = 0;
    Element mine = 0;
    std::uint64_t pairs = 0;
  };

  // The exchange with a worker that has not moved yet that brings most pairs to both.
  [[nodiscard]] Exchange best_exchange(std::uint32_t w) const {
    Exchange best;
    for (std::uint32_t v = 0; v < memory_.size(); ++v) {
      if (v == w || moved_[v]) {
        continue;
      }
      const Element theirs = *std::ranges::max_element(
          memory_[v], [&](Element a, Element b) { return gain_[w][a] < gain_[w][b]; });
      for (const Element mine : memory_[w]) {
        // Each side counts the pair of the two exchanged items, which does not meet.
        const std::uint64_t pairs =
            gain_[w][theirs] + gain_[v][mine] - (is_open(mine, theirs) ? 2U : 0U);
        if (pairs > best.pairs) {
          best = {v, theirs, mine, pairs};
        }
      }
    }
    return best;
  }

  void move(std::uint32_t w, std::uint64_t left_before, bool is_last) {
    const std::optional<Element> in = best_to_come(w);
    const std::uint64_t alone = in ? gain_[w][*in] : 0;
    if (const Exchange exchange = best_exchange(w); exchange.pairs > alone) {
      const std::optional<Element> other = best_to_come(exchange.with);
      if (exchange.pairs > alone + (other ? gain_[exchange.with][*other] : 0)) {
        evict(w, exchange.mine);
        evict(exchange.with, exchange.theirs);
        load(w, exchange.theirs);
        load(exchange.with, exchange.mine);
        note({w, exchange.mine, exchange.theirs});
        note({exchange.with, exchange.theirs, exchange.mine});
        moved_[w] = moved_[exchange.with] = true;
        return;
      }
    }
    if (alone > 0) {
      change(w, best_to_go(w, *in), *in);
    } else if (in) {
      load_most_open(w, is_last && left_ == left_before);
    }
  }

  // No item brings a new pair: the item with the most open pairs is loaded, if it helps or nothing
  // else has happened in this step.
  void load_most_open(std::uint32_t w, bool must) {
    std::optional<Element> in;
    for (Element y = 0; y < items_; ++y) {
      if (holder_[y] == no_holder && open_pairs_[y] > (in ? open_pairs_[*in] : 0)) {
        in = y;
      }
    }
    const Element out = *std::ranges::min_element(
        memory_[w], [&](Element a, Element b) { return open_pairs_[a] < open_pairs_[b]; });
    if (in && (must || (open_pairs_[out] == 0 && std::size_t{2} * open_pairs_[*in] >= room_))) {
      change(w, out, *in);
    }
  }

  std::size_t items_;
  std::size_t room_;
  GrowthRule rule_;
  Random& random_;
  std::vector<std::uint8_t> open_;         // P × P: whether the pair has not met
  std::vector<std::uint32_t> open_pairs_;  // by item
  std::vector<std::uint32_t> holder_;
  std::vector<std::uint64_t> arrival_;
  std::vector<std::vector<Element>> memory_;
  std::vector<std::vector<std::uint32_t>>
      gain_;  // by worker and item: open pairs with the worker's items
  std::vector<bool> moved_;
  std::uint64_t left_;
  std::uint64_t clock_ = 0;
  GrownOrder order_;
};

}  // namespace

GrowthRule growth_rule(std::size_t number) {
  constexpr std::size_t comings = 3;
  return {static_cast<GrowthRule::Goes>(number / comings % 4),
          static_cast<GrowthRule::Comes>(number % comings)};
}

std::optional<GrownOrder> grow_order(std::uint64_t items, std::uint64_t room, std::uint64_t workers,
                                     const GrownOrder& start, std::size_t keep, GrowthRule rule,
                                     std::uint64_t most_steps, Random& random) {
  Growth growth(items, room, workers, rule, random);
  for (std::size_t i = 0; i < keep; ++i) {
    growth.repeat(start.steps[i]);
  }
  while (!growth.done()) {
    if (growth.order().steps.size() >= most_steps) {
      return std::nullopt;
    }
    growth.step();
  }
  return std::move(growth.order());
}

GrownOrder round_robin_order(std::uint64_t workers) {
  const auto count = static_cast<std::size_t>(2 * workers);
  // Round r of the circle method, by player: the last player meets r, and r + i meets r − i.
  const auto partners_in = [&](std::size_t r) {
    std::vector<std::size_t> partner(count);
    const std::size_t odd = count - 1;
    partner[r] = odd;
    partner[odd] = r;
    for (std::size_t i = 1; i < workers; ++i) {
      partner[(r + i) % odd] = (r + odd - i) % odd;
      partner[(r + odd - i) % odd] = (r + i) % odd;
    }
    return partner;
  };
  std::vector<std::size_t> now = partners_in(0);
  // Worker w starts with the items 2w and 2w + 1.
  std::vector<Element> item_of(count);
  std::vector<std::uint32_t> worker_of(count);
  std::uint32_t next_worker = 0;
  for (std::size_t x = 0; x < count; ++x) {
    if (x < now[x]) {
      worker_of[x] = worker_of[now[x]] = next_worker;
      item_of[x] = 2 * next_worker;
      item_of[now[x]] = 2 * next_worker + 1;
      ++next_worker;
    }
  }
  GrownOrder order;
  for (std::size_t r = 1; r + 1 < count; ++r) {
    const std::vector<std::size_t> then = partners_in(r);
    std::vector<LockstepChange> step;
    std::vector<bool> seen(count, false);
    std::vector<std::uint32_t> moved = worker_of;
    for (std::size_t start = 0; start < count; ++start) {
      // The worker that keeps `keeps` continues with it; it drops its other item for the next
      // worker along the cycle.
      for (std::size_t keeps = start; !seen[keeps];) {
        const std::size_t goes = now[keeps];
        const std::size_t comes = then[keeps];
        seen[keeps] = seen[goes] = true;
        step.push_back({worker_of[keeps], item_of[goes], item_of[comes]});
        moved[comes] = worker_of[keeps];
        keeps = now[comes];
      }
    }
    order.changes += step.size();
    order.steps.push_back(std::move(step));
    worker_of = std::move(moved);
    now = then;
  }
  return order;
}

}  // namespace changeover
