#include "loadorder/listed/listed_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/levels/accelerator.hpp"
#include "loadorder/order/levels/level_cost.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/shares/idle_items.hpp"

namespace changeover {
namespace {

/// When the loads of an order load the same item again.
class NextLoads {
 public:
  NextLoads(const std::vector<LoadMove>& moves, std::uint64_t items)
      : after_(moves.size(), not_again), next_(static_cast<std::size_t>(items), not_again) {
    for (std::size_t i = moves.size(); i > 0; --i) {
      after_[i - 1] = std::exchange(next_[moves[i - 1].load], i - 1);
    }
  }

  /// Load number i is over.
  void pass(std::size_t i, Element x) { next_[x] = after_[i]; }
  [[nodiscard]] std::size_t of(Element x) const { return next_[x]; }

 private:
  std::vector<std::size_t> after_;  // by load: the next one of its item
  std::vector<std::size_t> next_;   // by item
};

// Steps that evict nothing are part of the step before.
void merge_fills(std::vector<Move>& moves) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    Move& move = moves[i];
    if (kept > 0 && move.evict.empty() && move.fast_evict.empty()) {
      Move& last = moves[kept - 1];
      last.load.insert(last.load.end(), move.load.begin(), move.load.end());
      last.fast_load.insert(last.fast_load.end(), move.fast_load.begin(), move.fast_load.end());
    } else if (kept++ != i) {
      moves[kept - 1] = std::move(move);
    }
  }
  moves.resize(kept);
}

/// Loads in batches: what a batch brings together is done before the next one.
class Batches {
 public:
  Batches(const PairGraph& graph, std::uint64_t room, std::uint64_t fast_room)
      : graph_(graph),
        items_(static_cast<std::size_t>(graph.items())),
        room_(room),
        fast_room_(fast_room),
        accelerator_(graph.items(), fast_room) {}

  /// `loads` is an order for less room.
  std::vector<Move> steps(const std::vector<LoadMove>& loads) {
    find_batches(loads);
    for (const Batch& batch : batches_) {
      stop_if_asked();
      add_steps(batch);
    }
    merge_fills(moves_);
    return std::move(moves_);
  }

 private:
  struct Stay {
    Element item = 0;
    std::size_t number = 0;
  };
  struct Batch {
    std::vector<Stay> evict;
    std::vector<Stay> load;
    std::vector<ItemPair> pairs;  // that come together, and items that are only loaded
  };

  // Nothing that the order keeps or loads in a batch goes before the batch is over.
  void find_batches(const std::vector<LoadMove>& loads) {
    NextLoads next(loads, items_);
    IdleItems idle(items_);
    std::vector<bool> in_memory(items_, false);
    std::vector<bool> kept(items_, false);  // by the order
    std::vector<std::size_t> stay_of(items_, 0);
    std::vector<bool> met(static_cast<std::size_t>(2 * graph_.pairs()), false);
    std::uint64_t kept_items = 0;
    std::uint64_t held = 0;
    for (std::size_t begin = 0; begin < loads.size();) {
      Batch batch;
      const std::size_t end =
          std::min<std::size_t>(loads.size(), begin + static_cast<std::size_t>(room_ - kept_items));
      std::vector<Element> come;
      for (std::size_t i = begin; i < end; ++i) {
        const Element x = loads[i].load;
        if (!in_memory[x]) {
          in_memory[x] = true;
          come.push_back(x);
        } else {
          idle.erase(x);
        }
      }
      for (; held + come.size() > room_; --held) {
        const Element goes = idle.take_last();
        in_memory[goes] = false;
        batch.evict.push_back({goes, stay_of[goes]});
      }
      held += come.size();
      for (const Element x : come) {
        stay_of[x] = is_used_.size();
        is_used_.push_back(graph_.partners(x).empty());
        batch.load.push_back({x, stay_of[x]});
        if (is_used_.back()) {
          batch.pairs.emplace_back(x, x);
        }
      }
      for (const Element x : come) {
        for (const Element y : graph_.partners(x)) {
          const auto place = static_cast<std::size_t>(*graph_.place(x, y));
          if (in_memory[y] && !met[place]) {
            met[place] = true;
            is_used_[stay_of[x]] = is_used_[stay_of[y]] = true;
            batch.pairs.emplace_back(x, y);
          }
        }
      }
      batches_.push_back(std::move(batch));
      std::vector<Element> left;
      for (; begin < end; ++begin) {
        const auto& [x, out] = loads[begin];
        if (out != LoadMove::nothing) {
          kept[out] = false;
          --kept_items;
          left.push_back(out);
        }
        next.pass(begin, x);
        kept[x] = true;
        ++kept_items;
      }
      for (const Element x : left) {
        if (!kept[x]) {
          idle.add(x, next.of(x));
        }
      }
    }
  }

  // Stays that bring no pair together are left out.
  void add_steps(const Batch& batch) {
    for (const auto& [x, stay] : batch.evict) {
      if (is_used_[stay]) {
        next_.evict.push_back(x);
        if (accelerator_.has(x)) {
          accelerator_.take_off(x, next_.fast_evict);
        }
      }
    }
    for (const auto& [x, stay] : batch.load) {
      if (is_used_[stay]) {
        next_.load.push_back(x);
      }
    }
    const std::vector<Element> items = items_of(batch.pairs);
    for (const LoadMove& move : quick_moves(batch.pairs, items, fast_room_)) {
      if (move.evict != LoadMove::nothing) {
        accelerator_.unwant(move.evict);
      }
      accelerator_.bring({move.load}, next_.fast_evict, next_.fast_load);
      if (!next_.fast_load.empty()) {
        moves_.push_back(std::exchange(next_, {}));
      }
    }
    for (const Element x : items) {
      accelerator_.unwant(x);
    }
  }

  const PairGraph& graph_;
  std::size_t items_;
  std::uint64_t room_;
  std::uint64_t fast_room_;
  Accelerator accelerator_;
  std::vector<Batch> batches_;
  std::vector<bool> is_used_;  // by stay
  Move next_;                  // evictions and loads of the next step
  std::vector<Move> moves_;
};

}  // namespace

std::vector<std::uint64_t> batches_to_try(std::uint64_t room, std::uint64_t fast_room) {
  std::vector<std::uint64_t> sizes;
  for (const std::uint64_t size : {room / 4, room / 2, 2 * (fast_room - 1), room / 8, 3 * room / 4,
                                   fast_room - 1, std::uint64_t{1}}) {
    if (size >= 1 && size + 2 <= room && std::ranges::find(sizes, size) == sizes.end()) {
      sizes.push_back(size);
    }
  }
  return sizes;
}

std::vector<Move> levels_of(const PairGraph& graph, const LoadOrderFacts& facts,
                            const std::vector<LoadMove>& loads, std::uint64_t batch) {
  if (batch > 0) {
    return Batches(graph, facts.room, *facts.fast_room).steps(loads);
  }
  std::vector<Move> cache = with_a_cache(one_step_each(loads), facts.room);
  merge_fills(cache);
  return cache;
}

namespace {

std::vector<Move> best_moves(LoadOrderFacts& facts, bool searched,
                             const LoadOrderOptions& options) {
  const WantedPairs list = as_list(facts.wanted);
  const PairGraph& graph = *list.graph();
  const std::uint64_t fast_room = *facts.fast_room;
  std::vector<Move> best;
  double least = 0;
  std::uint64_t best_batch = 0;
  const auto consider = [&](std::vector<Move> moves, std::uint64_t batch) {
    if (const double cost = cost_of(moves, facts); best.empty() || cost < least) {
      best = std::move(moves);
      least = cost;
      best_batch = batch;
    }
  };
  LoadOrderOptions quick = options;
  quick.read_first = false;  // both levels are read together
  quick.improve = nullptr;
  const auto order_for = [&](std::uint64_t room, bool is_last) {
    return (is_last && searched) || facts.wanted.graph() == nullptr
               ? one_by_one(plan_load_order(facts.wanted, room, quick))
               : quick_moves(graph, room);
  };
  consider(levels_of(graph, facts, order_for(fast_room, true), 0), 0);
  constexpr std::uint64_t most_work = 20'000'000;  // some seconds
  std::uint64_t work = 0;
  // Stopped, it ends with the best so far.
  const auto consider_batch = [&](std::uint64_t size, bool is_last) {
    return !must_hurry() && done(true, [&] {
      consider(levels_of(graph, facts, order_for(facts.room - size, is_last), size), size);
    });
  };
  bool has_time = true;
  for (const std::uint64_t size : batches_to_try(facts.room, fast_room)) {
    work += graph.pairs();
    if (!has_time || work > most_work) {
      break;
    }
    has_time = consider_batch(size, false);
  }
  if (has_time && best_batch > 0 && searched) {
    static_cast<void>(consider_batch(best_batch, true));
  }
  facts.method = best_batch == 0 ? "cache" : "batches";
  facts.explanation =
      best_batch == 0
          ? std::string(by_a_cache)
          : fmt::format(
                "An order for memory with {} less; what its next loads bring together is "
                "done on the accelerator before anything goes.",
                count_of(best_batch, "place"));
  return best;
}

}  // namespace

LoadOrder::Maker listed_levels(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  return in_memory(best_moves(facts, true, options));
}

std::vector<Move> listed_levels_of(const std::vector<ItemPair>& pairs, std::uint64_t room,
                                   std::uint64_t fast_room, bool searched,
                                   const LoadOrderOptions& options) {
  if (pairs.empty()) {
    return {};
  }
  std::vector<Element> items = items_of(pairs);
  LoadOrderFacts facts = facts_before(
      WantedPairs::listed(std::make_shared<const PairGraph>(items.size(), numbered(pairs, items))),
      room, fast_room);
  std::vector<Move> moves = best_moves(facts, searched, options);
  give_names(moves, items);
  return moves;
}

}  // namespace changeover
