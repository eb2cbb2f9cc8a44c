#include "loadorder/listed/level_search.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "changeover/run/control.hpp"
#include "loadorder/listed/listed_levels.hpp"
#include "loadorder/order/levels/level_cost.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/pairs/starts.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

/// An order of closing items, and how memory follows it: the loads of a batch, or as a cache (0).
struct Closed {
  std::vector<Element> order;
  std::uint64_t batch = 0;
};

class LevelSearch {
 public:
  LevelSearch(const PairGraph& graph, const LoadOrderFacts& facts, const std::vector<Move>& start,
              std::uint64_t seed, const std::function<bool()>& over)
      : graph_(graph), facts_(facts), over_(over), random_(seed), least_(cost_of(start, facts)) {}

  void begin(const std::vector<Move>& start) {
    batches_ = batches_to_try(facts_.room, *facts_.fast_room);
    batches_.insert(batches_.begin(), 0);
    take({as_they_leave(start), 0});
    for (const std::uint64_t batch : batches_) {
      each_start(graph_, room_for(batch), [&](const std::string&, std::vector<Element> order) {
        take({std::move(order), batch});
        return !over_();
      });
    }
  }

  void improve() {
    constexpr std::size_t rounds_ago = 40;
    std::vector<double> costs(rounds_ago, cost_);
    for (std::size_t round = 0; !over_(); round = (round + 1) % rounds_ago) {
      Closed other = changed();
      std::vector<Move> moves = moves_of(other);
      const double cost = cost_of(moves, facts_);
      ++tries_;
      if (cost <= costs[round] || cost <= cost_) {
        now_ = std::move(other);
        cost_ = cost;
      }
      costs[round] = cost_;
      keep(std::move(moves), cost);
      if (progress_due()) {
        report_progress({.phase = "improving both levels", .steps = tries_, .unit = "orders"});
      }
    }
  }

  [[nodiscard]] std::vector<Move> take_best() { return std::move(best_); }

 private:
  [[nodiscard]] std::uint64_t room_for(std::uint64_t batch) const {
    return batch == 0 ? *facts_.fast_room : facts_.room - batch;
  }

  [[nodiscard]] std::vector<Move> moves_of(const Closed& closed) const {
    Closing closing(graph_, room_for(closed.batch), closed.order);
    closing.run();
    return levels_of(graph_, facts_, closing.take_moves(), closed.batch);
  }

  void keep(std::vector<Move> moves, double cost) {
    if (cost < least_) {
      least_ = cost;
      best_ = std::move(moves);
    }
  }

  void take(Closed other) {
    std::vector<Move> moves = moves_of(other);
    const double cost = cost_of(moves, facts_);
    if (now_.order.empty() || cost < cost_) {
      now_ = std::move(other);
      cost_ = cost;
    }
    keep(std::move(moves), cost);
  }

  // Items in the sequence in which they leave the accelerator for good.
  [[nodiscard]] std::vector<Element> as_they_leave(const std::vector<Move>& moves) const {
    std::vector<std::size_t> last(static_cast<std::size_t>(graph_.items()), moves.size());
    for (std::size_t t = 0; t < moves.size(); ++t) {
      for (const Element x : moves[t].fast_evict) {
        last[x] = t;
      }
      for (const Element x : moves[t].fast_load) {
        last[x] = moves.size();
      }
    }
    std::vector<Element> order;
    for (Element x = 0; x < graph_.items(); ++x) {
      order.push_back(x);
    }
    std::ranges::stable_sort(order, {}, [&](Element x) { return last[x]; });
    return order;
  }

  Closed changed() {
    Closed other = now_;
    std::vector<Element>& order = other.order;
    constexpr std::uint32_t rarely = 16;
    if (order.size() < 2 || random_.below(rarely) == 0) {
      other.batch = batches_[random_.below(static_cast<std::uint32_t>(batches_.size()))];
      return other;
    }
    const auto items = static_cast<std::uint32_t>(order.size());
    std::uint32_t from = random_.below(items);
    std::uint32_t to = random_.below(items);
    const auto begin = order.begin();
    switch (random_.below(3)) {
      case 0:
        std::swap(order[from], order[to]);
        break;
      case 1:
        if (from < to) {
          std::rotate(begin + from, begin + from + 1, begin + to + 1);
        } else {
          std::rotate(begin + to, begin + from, begin + from + 1);
        }
        break;
      default:
        std::reverse(begin + std::min(from, to), begin + std::max(from, to) + 1);
        break;
    }
    return other;
  }

  const PairGraph& graph_;
  const LoadOrderFacts& facts_;
  const std::function<bool()>& over_;
  Random random_;
  std::vector<std::uint64_t> batches_;
  Closed now_;
  double cost_ = 0;
  double least_;
  std::vector<Move> best_;
  std::uint64_t tries_ = 0;
};

}  // namespace

std::vector<Move> search_levels(const PairGraph& graph, const LoadOrderFacts& facts,
                                const std::vector<Move>& start, std::uint64_t seed,
                                const std::function<bool()>& over) {
  LevelSearch search(graph, facts, start, seed, over);
  try {
    search.begin(start);
    search.improve();
  } catch (const Stopped&) {
    // The time is over in the middle of an order.
  }
  return search.take_best();
}

}  // namespace changeover
