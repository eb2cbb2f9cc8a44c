#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/plan_all_pairs.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/pairs/held/held_list.hpp"
#include "loadorder/pairs/held/held_order.hpp"
#include "loadorder/pairs/pair_bounds.hpp"
#include "loadorder/pairs/small_search.hpp"
#include "loadorder/pairs/starts.hpp"

namespace changeover {
namespace {

using Moves = std::vector<LoadMove>;

/// The loads up to the first eviction are one step; each further load is a step.
class MoveSteps final : public StepSource {
 public:
  explicit MoveSteps(std::shared_ptr<const Moves> moves) : moves_(std::move(moves)) {}

  bool next(Step& step) override {
    if (at_ == moves_->size()) {
      return false;
    }
    step.number = ++number_;
    step.evict.clear();
    step.load.clear();
    do {
      const LoadMove& move = (*moves_)[at_++];
      step.load.push_back(move.load);
      if (move.evict != LoadMove::nothing) {
        step.evict.push_back(move.evict);
      }
    } while (number_ == 1 && at_ < moves_->size() && (*moves_)[at_].evict == LoadMove::nothing);
    return true;
  }

 private:
  std::shared_ptr<const Moves> moves_;
  std::size_t at_ = 0;
  std::uint64_t number_ = 0;
};

bool stop_wanted() {
  RunControl* const control = RunScope::current();
  return control != nullptr && control->stop_wanted();
}

/// Returns true some time after a stop was requested.
class Patience {
 public:
  bool operator()() {
    constexpr std::chrono::milliseconds grace{200};
    if (!since_ && stop_wanted()) {
      since_ = RunControl::Clock::now();
    }
    return since_ && RunControl::Clock::now() - *since_ > grace;
  }

 private:
  std::optional<RunControl::Clock::time_point> since_;
};

struct ListedOrder {
  Moves moves;
  std::string method;
  std::string explanation;
};

// Searches an order for a list: first several starts, then changes to the best of them.
class ListSearch {
 public:
  ListSearch(const PairGraph& graph, std::uint64_t room, const LoadBound& bound,
             const LoadOrderOptions& options)
      : graph_(graph), room_(room), bound_(bound), options_(options), random_(options.seed) {
    best_.explanation =
        "Items are closed one after another: what an item lacks is loaded while it stays; what is "
        "needed last is evicted.";
  }

  ListedOrder result() {
    fixed_first(
        options_, [this] { search(); },
        [this](RunControl&) {
          goes_on_ = true;
          if (!best_start_.empty()) {
            improve_closing();
          }
        });
    if (best_start_.empty() || held_.loads < best_.moves.size()) {
      best_ = {.moves = held_.moves(graph_),
               .method = "held groups",
               .explanation = fmt::format(
                   "{} groups stay in turn, in all places but one. What still has a pair with the "
                   "group passes through that place.",
                   held_.groups.size())};
    }
    return std::move(best_);
  }

 private:
  void search() {
    held_ = held_list(graph_, room_, [this] { return in_a_hurry(); });
    // Closing that begins far behind does not catch up: where most pairs are listed it takes long.
    constexpr std::uint64_t small = 1000;
    most_loads_ = std::max(small, held_.loads + held_.loads / 3);
    std::size_t tried = 0;
    each_start(
        graph_, room_,
        [&](const std::string& name, std::vector<Element> start) {
          try_start(name, std::move(start));
          const bool is_far = best_start_.empty() && ++tried == 2;
          return !is_far && (best_start_.empty() || best_.moves.size() > bound_.loads) &&
                 !in_a_hurry();
        },
        [this] { return in_a_hurry(); });
    if (!best_start_.empty()) {
      improve_closing();
    }
  }

  // Once for a fixed amount of work, or going on with ever more until stopped.
  void improve_closing() {
    // Improving an order takes as long as many runs of it.
    constexpr std::uint64_t most_work = 1'000'000'000;  // some seconds
    constexpr std::uint64_t work_a_pair = 1'000'000;
    constexpr std::uint64_t runs = 50;
    const auto work = static_cast<std::uint64_t>(
        options_.effort *
        static_cast<double>(std::min(most_work, work_a_pair * (graph_.pairs() + 1))));
    const std::uint64_t least = checked_multiply(runs, work_of_run_);
    if (SmallSearch::serves(graph_)) {
      improve_small();
    } else if (best_.moves.size() > bound_.loads && !in_a_hurry() && (goes_on_ || least <= work)) {
      improve(std::max(work, least));
    }
  }

  // Whether the search of the caller has been stopped. Without one what stops is the whole.
  bool in_a_hurry() const { return goes_on_ ? stop_wanted() : must_hurry(); }

  void try_start(const std::string& name, std::vector<Element> start) {
    if (SmallSearch::serves(graph_)) {
      starts_.push_back(start);
    }
    Closing closing(graph_, room_, start);
    const std::uint64_t limit = best_start_.empty() ? most_loads_ : best_.moves.size() - 1;
    std::uint64_t loads = 0;
    const auto run = [&] { loads = closing.run(limit, [this] { return in_a_hurry(); }); };
    best_start_.empty() ? in_spite_of_the_time(run) : run();
    if (loads <= limit) {
      best_.moves = closing.take_moves();
      best_.method = "closing, " + name;
      best_start_ = std::move(start);
      work_of_run_ = closing.work_of_run();
    }
  }

  // Improves every start for a while, and the best of them for longer.
  void improve_small() {
    constexpr std::uint64_t work = 1'000'000'000;  // some seconds
    constexpr std::uint64_t most_looks = 500'000;
    SmallSearch small(graph_, room_);
    const auto stop = [this] { return in_a_hurry(); };
    const auto anneal = [&](const std::vector<Element>& start, std::uint64_t effort) {
      return small.anneal(start, bound_.loads, effort, random_, stop);
    };
    const auto least = static_cast<std::uint64_t>(
        options_.effort * static_cast<double>(std::min(work, most_looks * small.work_of_look())));
    for (; best_.moves.size() > bound_.loads && !in_a_hurry(); ++rounds_) {
      const std::uint64_t effort = effort_of_round(least);
      SmallSearch::Found found = anneal(best_start_, effort / 8);
      for (const std::vector<Element>& start : starts_) {
        if (SmallSearch::Found other = anneal(start, effort / 8);
            other.moves.size() < found.moves.size()) {
          found = std::move(other);
        }
      }
      found = anneal(found.order, effort / 2);
      if (found.moves.size() <= best_.moves.size()) {
        best_start_ = std::move(found.order);
        best_.moves = std::move(found.moves);
        best_.method = "closing, improved";
      }
      tell(effort);
      if (!goes_on_) {
        ++rounds_;
        return;
      }
    }
  }

  [[nodiscard]] std::uint64_t effort_of_round(std::uint64_t first) const {
    constexpr std::uint64_t most_doubled = 32;
    return checked_multiply(first, std::uint64_t{1} << std::min(rounds_, most_doubled));
  }

  void tell(std::uint64_t effort) const {
    if (progress_due()) {
      report_progress({.phase = "improving the load order",
                       .steps = effort,
                       .unit = "looks at a pair",
                       .best = best_.moves.size(),
                       .lower_bound = bound_.loads});
    }
  }

  // Improves windows of the order, ever longer. What has been reached is run in whole now and then,
  // so that the best of it is not lost in what follows.
  void improve(std::uint64_t work) {
    if (!closing_) {
      closing_.emplace(graph_, room_, best_start_);
      best_order_ = closing_->closing_order();
    }
    const auto stop = [this] { return in_a_hurry(); };
    for (; best_.moves.size() > bound_.loads && !in_a_hurry(); ++rounds_) {
      const std::uint64_t effort = effort_of_round(work);
      closing_->take_order(best_order_);
      closing_->improve(effort, random_, stop, [&] {
        Closing whole = *closing_;
        if (whole.run(best_.moves.size(), Patience()) <= best_.moves.size()) {
          best_order_ = whole.closing_order();
          best_.moves = whole.take_moves();
          best_.method = "closing, improved";
        }
      });
      tell(effort);
      if (!goes_on_) {
        ++rounds_;
        return;
      }
    }
  }

  const PairGraph& graph_;
  std::uint64_t room_;
  const LoadBound& bound_;
  const LoadOrderOptions& options_;
  ListedOrder best_;
  std::vector<Element> best_start_;
  std::vector<std::vector<Element>> starts_;  // for a short list
  std::uint64_t work_of_run_ = 0;
  std::uint64_t most_loads_ = Closing::no_limit;  // of a start
  HeldList held_;
  std::optional<Closing> closing_;   // of a long list
  std::vector<Element> best_order_;  // in its names
  Random random_;
  std::uint64_t rounds_ = 0;
  bool goes_on_ = false;  // beyond the fixed work
};

// An order for all pairs is good if most pairs are listed.
void consider_all_pairs(const PairGraph& graph, std::uint64_t room, const LoadOrderOptions& options,
                        ListedOrder& best) {
  const std::uint64_t items = graph.items();
  if (items <= room || load_lower_bound(items, room).loads >= best.moves.size()) {
    return;
  }
  LoadOrderOptions quick = options;
  quick.improve = nullptr;
  quick.read_first = false;  // It is read with the pairs of the list afterwards.
  const LoadOrder all = plan_all_pairs(items, room, quick);
  // If the loads of a step are made one by one, an item also meets those that are evicted later in
  // the step: only more pairs meet.
  if (all.facts().loads < best.moves.size()) {
    best.method = all.facts().method;
    best.explanation = "An order for all pairs. " + all.facts().explanation;
    best.moves = one_by_one(all);
  }
}

std::uint64_t steps_of(const Moves& moves) {
  std::uint64_t first = 0;
  while (first < moves.size() && (first == 0 || moves[first].evict == LoadMove::nothing)) {
    ++first;
  }
  return moves.size() - first + (moves.empty() ? 0 : 1);
}

void verify(const LoadOrder::Maker& maker, LoadOrderFacts& facts, const LoadOrderOptions& options) {
  if (!options.read_first) {
    facts.every_step_read = false;
    facts.certificate = "not read yet";
    return;
  }
  const ScheduleVerdict verdict =
      check_schedule(*maker(), {.items = facts.items, .room = facts.room, .wanted = facts.wanted});
  if (!verdict.valid() || verdict.loads != facts.loads || verdict.steps != facts.steps ||
      verdict.loads < facts.bound.loads) {
    throw InternalError(fmt::format(
        "the load order for {} with room for {} is wrong: {}", facts.wanted.describe(), facts.room,
        verdict.valid() ? "it does not keep its promise" : verdict.fault + verdict.example));
  }
  facts.certificate = "every step read, " + all_met(facts.wanted.count(), "wanted pair");
}

// An order for all pairs also serves fewer pairs: nullopt if it has as many loads as the given one,
// or more than its bound allows.
std::optional<LoadOrder> order_for_all_pairs(const LoadOrderFacts& facts, std::uint64_t loads,
                                             const LoadOrderOptions& options) {
  if (load_lower_bound(facts.items, facts.room).loads >= loads) {
    return std::nullopt;
  }
  LoadOrderOptions its_own = options;
  if (loads != Closing::no_limit) {
    its_own.improve = nullptr;
  }
  const auto all =
      std::make_shared<const LoadOrder>(plan_all_pairs(facts.items, facts.room, its_own));
  if (all->facts().loads >= loads) {
    return std::nullopt;
  }
  LoadOrderFacts its = all->facts();
  its.wanted = facts.wanted;
  its.bound = facts.bound;
  its.explanation = "An order for all pairs. " + its.explanation;
  LoadOrder::Maker maker = [all] { return all->stream(); };
  if (its.every_step_read) {
    verify(maker, its, options);
  }
  return LoadOrder(std::move(its), std::move(maker));
}

LoadOrder order_of_groups(LoadOrderFacts facts, const LoadOrderOptions& options) {
  HeldShape shape = best_held_shape(facts.wanted, facts.room);
  if (auto all = order_for_all_pairs(facts, shape.loads, options)) {
    return std::move(*all);
  }
  facts.loads = shape.loads;
  facts.steps = shape.steps;
  facts.method = "held groups";
  facts.explanation = shape.explain();
  facts.every_step_read =
      facts.items <= std::min<std::uint64_t>(options.read_up_to, max_elements_in_memory) &&
      shape.loads <= most_loads_read;
  LoadOrder::Maker maker = [shape] { return held_steps(shape); };
  if (facts.every_step_read) {
    verify(maker, facts, options);
  } else {
    facts.certificate = "all that a group must meet passes while it stays";
  }
  return {std::move(facts), std::move(maker)};
}

LoadOrder order_in_one_step(LoadOrderFacts facts, const LoadOrderOptions& options) {
  auto moves = std::make_shared<Moves>();
  for (Element x = 0; x < facts.items; ++x) {
    if (facts.wanted.needs(x)) {
      moves->push_back({x, LoadMove::nothing});
    }
  }
  facts.loads = moves->size();
  facts.steps = 1;
  facts.method = "one-step";
  facts.explanation = "All items fit.";
  LoadOrder::Maker maker = [moves] { return std::make_unique<MoveSteps>(moves); };
  facts.every_step_read = facts.items <= max_elements_in_memory || facts.wanted.graph() != nullptr;
  if (facts.every_step_read) {
    verify(maker, facts, options);
  } else {
    facts.certificate = "all items are loaded at once";
  }
  return {std::move(facts), std::move(maker)};
}

}  // namespace

LoadOrder plan_load_order(const WantedPairs& wanted, std::uint64_t room,
                          const LoadOrderOptions& options) {
  if (wanted.are_all()) {
    return plan_all_pairs(wanted.items(), room, options);
  }
  LoadOrderFacts facts = facts_before(wanted, room);
  if (facts.items > most_items) {
    throw ImpossibleParameters(
        fmt::format("{}: that is {} items together, and {} is the most; take fewer",
                    wanted.describe(), facts.items, most_items));
  }
  if (needed_items(wanted) <= room) {
    return order_in_one_step(std::move(facts), options);
  }
  if (wanted.graph() == nullptr) {
    return order_of_groups(std::move(facts), options);
  }
  if (wanted.graph()->pairs() == binomial(facts.items, 2)) {  // A list of all pairs.
    if (auto all = order_for_all_pairs(facts, Closing::no_limit, options)) {
      return std::move(*all);
    }
  }
  ListedOrder best = ListSearch(*wanted.graph(), room, facts.bound, options).result();
  consider_all_pairs(*wanted.graph(), room, options, best);
  const auto moves = std::make_shared<const Moves>(std::move(best.moves));
  facts.loads = moves->size();
  facts.steps = steps_of(*moves);
  facts.method = std::move(best.method);
  facts.explanation = std::move(best.explanation);
  facts.every_step_read = true;
  LoadOrder::Maker maker = [moves] { return std::make_unique<MoveSteps>(moves); };
  verify(maker, facts, options);
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover
