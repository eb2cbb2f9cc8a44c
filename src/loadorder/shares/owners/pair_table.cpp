#include "loadorder/shares/owners/pair_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/shares/owners/pouring.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {
namespace {

using Worker = std::uint16_t;
constexpr Worker no_worker = 65'535;

/// Numbers the pairs: all of them, or those of a list.
class PairPlaces {
 public:
  PairPlaces(const WantedPairs& wanted, std::uint64_t items)
      : wanted_(wanted),
        count_(wanted.graph() != nullptr ? 2 * wanted.graph()->pairs() : items * (items - 1) / 2) {}

  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(count_); }

  /// Calls visit(y, place) for all wanted pairs of x with an item in memory.
  template <typename Visit>
  void each(Element x, const std::vector<Element>& memory, const std::vector<bool>& there,
            Visit&& visit) const {
    const PairGraph* const graph = wanted_.graph();
    if (graph == nullptr) {
      for (const Element y : memory) {
        if (wanted_.contains(x, y)) {
          visit(y, static_cast<std::size_t>(PairSet::rank(x, y)));
        }
      }
    } else if (graph->partners(x).size() < memory.size()) {
      for (const Element y : graph->partners(x)) {
        if (there[y]) {
          visit(y, static_cast<std::size_t>(*graph->place(x, y)));
        }
      }
    } else {
      for (const Element y : memory) {
        if (const auto place = graph->place(x, y)) {
          visit(y, static_cast<std::size_t>(*place));
        }
      }
    }
  }

  /// Nullopt for a pair that is not listed.
  [[nodiscard]] std::optional<std::uint64_t> place(Element x, Element y) const {
    return wanted_.graph() != nullptr ? wanted_.graph()->place(x, y)
                                      : std::optional(PairSet::rank(x, y));
  }

 private:
  WantedPairs wanted_;
  std::uint64_t count_;
};

struct Table {
  PairPlaces places;
  std::vector<Worker> owner;  // by place
  std::vector<Worker> alone;  // by item
};

class TableRule final : public PairRule {
 public:
  TableRule(const Table& table, std::uint64_t worker)
      : table_(table), worker_(static_cast<Worker>(worker)) {}
  [[nodiscard]] bool computes(std::uint64_t /*step*/, Element x, Element y) const override {
    if (x == y) {
      return table_.alone[x] == worker_;
    }
    const auto place = table_.places.place(x, y);
    return place && table_.owner[static_cast<std::size_t>(*place)] == worker_;
  }

 private:
  const Table& table_;
  Worker worker_;
};

class TableOwners final : public PairOwners {
 public:
  explicit TableOwners(Table table) : table_(std::move(table)) {}
  [[nodiscard]] std::unique_ptr<const PairRule> of(std::uint64_t worker) const override {
    return std::make_unique<TableRule>(table_, worker);
  }

 private:
  Table table_;
};

class Spreading {
 public:
  Spreading(const ScheduleRules& rules, const std::vector<WorkerFacts>& workers,
            const std::function<std::unique_ptr<StepSource>(std::uint64_t worker)>& of,
            const std::function<double(Element, Element)>& cost,
            const std::function<bool(Element, Element)>& computed, bool first_holder)
      : rules_(rules),
        workers_(workers),
        of_(of),
        cost_(cost),
        computed_(computed),
        first_holder_(first_holder),
        come_(rules.fast_room ? &Step::fast_load : &Step::load),
        leave_(rules.fast_room ? &Step::fast_evict : &Step::evict),
        table_{PairPlaces(rules.wanted, rules.items), {}, {}} {}

  SpreadPairs result() {
    if (first_holder_) {
      give_to_the_first();
    } else {
      find_workers_of_pairs();
      give_pairs();
    }
    SpreadPairs spread;
    spread.workers = workers_;
    for (std::size_t w = 0; w < workers_.size(); ++w) {
      spread.workers[w].pairs = pairs_[w];
      spread.workers[w].cost = cost_ ? load_[w] : 0;
    }
    if (!rules_.fast_room) {
      leave_out(spread);
    }
    give_items(spread);
    spread.owners = std::make_shared<TableOwners>(std::move(table_));
    return spread;
  }

 private:
  // Calls visit(worker, x, y, place) for each pair when it comes together at a worker, and
  // stay(worker, item, come) when an item is loaded or evicted.
  template <typename Visit, typename Stay>
  void play(Visit&& visit, Stay&& stay) {
    std::vector<bool> there(static_cast<std::size_t>(rules_.items), false);
    for (std::uint64_t w = 0; w < workers_.size(); ++w) {
      stop_if_asked();
      std::vector<Element> memory;
      const auto steps = of_(w);
      for (Step step; steps->next(step);) {
        for (const Element x : step.*leave_) {
          there[x] = false;
          stay(w, x, false);
        }
        if (!(step.*leave_).empty()) {
          std::erase_if(memory, [&](Element x) { return !there[x]; });
        }
        for (const Element x : step.*come_) {
          stay(w, x, true);
          table_.places.each(x, memory, there, [&](Element y, std::size_t place) {
            if (!computed_ || !computed_(x, y)) {
              visit(w, x, y, place);
            }
          });
          memory.push_back(x);
          there[x] = true;
        }
      }
      for (const Element x : memory) {
        there[x] = false;
      }
    }
  }

  template <typename Visit>
  void play_pairs(Visit&& visit) {
    play(visit, [](std::uint64_t, Element, bool) {});
  }

  [[nodiscard]] double cost_of(Element x, Element y) const {
    const double cost = cost_ ? cost_(std::min(x, y), std::max(x, y)) : 1;
    if (!(cost >= 0)) {
      throw BadInput(fmt::format("the pair of {} and {} costs {}: give 0 or more", std::min(x, y),
                                 std::max(x, y), cost));
    }
    return cost;
  }

  void begin() {
    table_.owner.assign(table_.places.count(), no_worker);
    has_pair_.assign(static_cast<std::size_t>(rules_.items), false);
    load_.assign(workers_.size(), 0);
    pairs_.assign(workers_.size(), 0);
  }

  void give_to_the_first() {
    begin();
    play_pairs([&](std::uint64_t w, Element x, Element y, std::size_t place) {
      has_pair_[x] = has_pair_[y] = true;
      if (table_.owner[place] == no_worker) {
        table_.owner[place] = static_cast<Worker>(w);
        load_[w] += cost_of(x, y);
        ++pairs_[w];
      }
    });
  }

  // Assigns pairs that only one worker has; for the others, records which workers have them.
  void find_workers_of_pairs() {
    begin();
    const std::size_t places = table_.places.count();
    std::vector<Worker> last(places, no_worker);
    std::vector<bool> is_shared(places, false);
    play_pairs([&](std::uint64_t w, Element x, Element y, std::size_t place) {
      has_pair_[x] = has_pair_[y] = true;
      const auto worker = static_cast<Worker>(w);
      is_shared[place] =
          is_shared[place] || (table_.owner[place] != no_worker && table_.owner[place] != worker);
      table_.owner[place] = worker;
    });
    nodes_.assign(1, {});
    std::map<std::pair<std::uint32_t, Worker>, std::uint32_t> children;
    std::vector<std::uint32_t> number(places, 0);  // among the shared ones, plus one
    play_pairs([&](std::uint64_t w, Element x, Element y, std::size_t place) {
      const auto worker = static_cast<Worker>(w);
      if (std::exchange(last[place], worker) == worker) {
        return;
      }
      if (!is_shared[place]) {
        load_[w] += cost_of(x, y);
        ++pairs_[w];
        return;
      }
      if (number[place] == 0) {
        shared_.push_back({place, 0});
        if (cost_) {
          costs_.push_back(cost_of(x, y));
        }
        number[place] = static_cast<std::uint32_t>(shared_.size());
      }
      std::uint32_t& node = shared_[number[place] - 1].node;
      const auto [child, is_new] =
          children.try_emplace({node, worker}, static_cast<std::uint32_t>(nodes_.size()));
      if (is_new) {
        nodes_.push_back({node, worker});
      }
      node = child->second;
    });
  }

  // The workers of a node, the last one first.
  [[nodiscard]] std::vector<Worker> workers_of(std::uint32_t node) const {
    std::vector<Worker> all;
    for (; node != 0; node = nodes_[node].parent) {
      all.push_back(nodes_[node].worker);
    }
    return all;
  }

  void give_pairs() {
    // Pairs of the same workers are one amount. Pairs of one worker are an amount that only it
    // takes.
    Pouring pouring;
    pouring.begin.assign(1, 0);
    const auto add = [&](double amount, const std::vector<Worker>& workers) {
      pouring.amount.push_back(amount);
      pouring.worker.insert(pouring.worker.end(), workers.begin(), workers.end());
      pouring.begin.push_back(pouring.worker.size());
    };
    std::vector<double> sums(nodes_.size(), 0);
    for (std::size_t i = 0; i < shared_.size(); ++i) {
      sums[shared_[i].node] += shared_cost(i);
    }
    std::vector<std::size_t> amount_of(nodes_.size(), 0);
    std::vector<std::uint32_t> nodes;
    for (const Shared& pair : shared_) {
      if (amount_of[pair.node] == 0) {
        nodes.push_back(pair.node);
        amount_of[pair.node] = nodes.size();
      }
    }
    for (const std::uint32_t node : nodes) {
      add(sums[node], workers_of(node));
    }
    for (std::size_t w = 0; w < load_.size(); ++w) {
      add(load_[w], {static_cast<Worker>(w)});
    }
    pouring.pour(load_.size());
    std::vector<double> given(nodes.size(), 0);
    std::vector<std::uint64_t> portion(pouring.begin.begin(), pouring.begin.end());
    std::vector<double> end(nodes.size());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      end[a] = pouring.portion[portion[a]];
    }
    for (std::size_t i = 0; i < shared_.size(); ++i) {
      const std::size_t a = amount_of[shared_[i].node] - 1;
      const double middle = given[a] + shared_cost(i) / 2;
      given[a] += shared_cost(i);
      while (middle > end[a] && portion[a] + 1 < pouring.begin[a + 1]) {
        end[a] += pouring.portion[++portion[a]];
      }
      give(i, static_cast<Worker>(pouring.worker[portion[a]]));
    }
    even_out();
  }

  /// A pair that several workers have.
  struct Shared {
    std::size_t place = 0;
    std::uint32_t node = 0;  // the workers
  };

  [[nodiscard]] double shared_cost(std::size_t i) const { return cost_ ? costs_[i] : 1; }

  void give(std::size_t i, Worker worker) {
    table_.owner[shared_[i].place] = worker;
    load_[worker] += shared_cost(i);
    ++pairs_[worker];
  }

  // Balances what cutting portions has left uneven.
  void even_out() {
    constexpr int rounds = 20;
    bool moved = true;
    for (int round = 0; moved && round < rounds; ++round) {
      moved = false;
      for (std::size_t i = 0; i < shared_.size(); ++i) {
        const Worker from = table_.owner[shared_[i].place];
        Worker to = from;
        for (std::uint32_t node = shared_[i].node; node != 0; node = nodes_[node].parent) {
          to = load_[nodes_[node].worker] < load_[to] ? nodes_[node].worker : to;
        }
        if (load_[to] + shared_cost(i) < load_[from]) {
          load_[from] -= shared_cost(i);
          --pairs_[from];
          give(i, to);
          moved = true;
        }
      }
    }
  }

  // Leaves out stays in which a worker computes no pair of the item.
  void leave_out(SpreadPairs& spread) {
    std::vector<bool> is_used;  // by stay, in the order of their beginnings
    std::vector<std::size_t> stay_of(static_cast<std::size_t>(rules_.items), 0);
    std::vector<bool> done(table_.places.count(), false);
    std::vector<bool> loaded(static_cast<std::size_t>(rules_.items), false);
    play(
        [&](std::uint64_t w, Element x, Element y, std::size_t place) {
          if (table_.owner[place] == w && !done[place]) {
            done[place] = true;
            is_used[stay_of[x]] = is_used[stay_of[y]] = true;
          }
        },
        [&](std::uint64_t, Element x, bool comes) {
          if (comes) {
            stay_of[x] = is_used.size();
            // An item in no remaining pair is loaded once for itself.
            is_used.push_back(!loaded[x] && !has_pair_[x] && !(computed_ && computed_(x, x)));
            loaded[x] = true;
          }
        });
    if (std::ranges::find(is_used, false) == is_used.end()) {
      return;
    }
    auto lists = std::make_shared<StepLists>();
    std::vector<bool> is_kept(static_cast<std::size_t>(rules_.items), false);
    std::size_t stay = 0;
    for (std::uint64_t w = 0; w < workers_.size(); ++w) {
      std::vector<Move> moves;
      const auto steps = of_(w);
      for (Step step; steps->next(step);) {
        Move& move = moves.emplace_back();
        std::ranges::copy_if(step.evict, std::back_inserter(move.evict),
                             [&](Element x) { return is_kept[x]; });
        for (const Element x : step.load) {
          is_kept[x] = is_used[stay++];
          if (is_kept[x]) {
            move.load.push_back(x);
          }
        }
      }
      moves = lazily(moves, rules_.room, rules_.sizes.get());
      WorkerFacts& facts = spread.workers[static_cast<std::size_t>(w)];
      facts.first_step = facts.loads = 0;
      facts.steps = moves.size();
      for (const Move& move : moves) {
        facts.loads += move.load.size();
      }
      lists->add(moves);
    }
    spread.steps = std::move(lists);
  }

  // An item alone belongs to the first worker that loads it.
  void give_items(const SpreadPairs& spread) {
    table_.alone.assign(static_cast<std::size_t>(rules_.items), no_worker);
    for (std::uint64_t w = 0; w < workers_.size(); ++w) {
      const auto steps = spread.steps ? spread.steps->of(w) : of_(w);
      for (Step step; steps->next(step);) {
        for (const Element x : step.*come_) {
          if (!computed_ || !computed_(x, x)) {
            table_.alone[x] = std::min(table_.alone[x], static_cast<Worker>(w));
          }
        }
      }
    }
  }

  const ScheduleRules& rules_;
  const std::vector<WorkerFacts>& workers_;
  const std::function<std::unique_ptr<StepSource>(std::uint64_t)>& of_;
  const std::function<double(Element, Element)>& cost_;
  const std::function<bool(Element, Element)>& computed_;
  bool first_holder_;
  std::vector<Element> Step::*come_;
  std::vector<Element> Step::*leave_;
  Table table_;
  struct Node {
    std::uint32_t parent = 0;
    Worker worker = no_worker;
  };
  std::vector<bool> has_pair_;  // by item
  std::vector<Node> nodes_;     // sets of workers as a tree; the first is empty
  std::vector<Shared> shared_;
  std::vector<double> costs_;  // of the pairs, if they have costs
  std::vector<double> load_;   // by worker
  std::vector<std::uint64_t> pairs_;
};

}  // namespace

SpreadPairs spread_pairs(const ScheduleRules& rules, const std::vector<WorkerFacts>& workers,
                         const std::function<std::unique_ptr<StepSource>(std::uint64_t worker)>& of,
                         const std::function<double(Element, Element)>& cost,
                         const std::function<bool(Element, Element)>& computed, bool first_holder) {
  return Spreading(rules, workers, of, cost, computed, first_holder).result();
}

std::shared_ptr<const PairOwners> owners_of_lists(const WantedPairs& wanted,
                                                  const std::vector<std::vector<ItemPair>>& pairs,
                                                  const std::vector<std::vector<Element>>& alone) {
  Table table{PairPlaces(wanted, wanted.items()), {}, {}};
  table.owner.assign(table.places.count(), no_worker);
  table.alone.assign(static_cast<std::size_t>(wanted.items()), no_worker);
  for (std::size_t w = 0; w < pairs.size(); ++w) {
    for (const auto& [x, y] : pairs[w]) {
      if (x != y) {
        table.owner[static_cast<std::size_t>(*table.places.place(x, y))] = static_cast<Worker>(w);
      }
    }
    for (const Element x : alone[w]) {
      table.alone[x] = static_cast<Worker>(w);
    }
  }
  return std::make_shared<TableOwners>(std::move(table));
}

bool are_given_one_by_one(const PairOwners& owners) {
  return dynamic_cast<const TableOwners*>(&owners) != nullptr;
}

}  // namespace changeover
