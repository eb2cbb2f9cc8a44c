#include "loadorder/shares/split_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <ranges>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/listed/listed_levels.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/order/streamed_order.hpp"
#include "loadorder/shares/few_workers.hpp"
#include "loadorder/shares/owners/group_owners.hpp"
#include "loadorder/shares/owners/pair_table.hpp"
#include "loadorder/shares/owners/plane_owners.hpp"
#include "loadorder/shares/owners/streamed_owners.hpp"
#include "loadorder/shares/step_lists.hpp"
#include "loadorder/shares/stretches.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_pairs_computed =
    30'000'000;  // to be checked one by one in a second or so
constexpr std::uint64_t most_groups_of_a_table = 600;

/// The steps of shares of groups.
class GroupSteps final : public WorkerSteps {
 public:
  GroupSteps(GroupShares shares, std::uint64_t items, std::uint64_t room)
      : shares_(std::move(shares)), groups_{items, shares_.groups}, room_(room) {}

  [[nodiscard]] std::unique_ptr<StepSource> of(std::uint64_t worker) const override {
    return share_steps(worker < shares_.workers.size()
                           ? shares_.workers[static_cast<std::size_t>(worker)]
                           : GroupShare{},
                       groups_, room_, worker);
  }
  [[nodiscard]] const GroupShares& shares() const { return shares_; }

 private:
  GroupShares shares_;
  ItemGroups groups_;
  std::uint64_t room_;
};

void set_pairs(SplitFacts& facts, const std::vector<std::uint64_t>& pairs) {
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    facts.workers[w].pairs = w < pairs.size() ? pairs[w] : 0;
  }
}

void count_moves_of(const std::vector<Move>& moves, WorkerFacts& worker) {
  worker.first_step = worker.loads = 0;
  worker.steps = moves.size();
  for (const Move& move : moves) {
    worker.loads += move.load.size();
  }
}

void sum_up(SplitFacts& facts) {
  facts.loads = facts.makespan = facts.most_pairs = facts.bytes = facts.makespan_bytes = 0;
  facts.most_cost = facts.all_costs = 0;
  for (const WorkerFacts& worker : facts.workers) {
    facts.loads += worker.loads;
    facts.makespan = std::max(facts.makespan, worker.loads);
    facts.bytes += worker.bytes;
    facts.makespan_bytes = std::max(facts.makespan_bytes, worker.bytes);
    facts.most_pairs = std::max(facts.most_pairs, worker.pairs);
    facts.most_cost = std::max(facts.most_cost, worker.cost);
    facts.all_costs += worker.cost;
  }
}

}  // namespace

WorkerSplit SplitMaker::stretches(LoadOrder order, std::uint64_t items, std::uint64_t room,
                                  std::uint64_t workers, bool even_pairs) {
  const LoadOrderFacts& whole = order.facts();
  SplitFacts facts;
  facts.items = items;
  facts.room = room;
  facts.groups = whole.items;
  facts.group_room = whole.room;
  const WantedPairs wanted = whole.wanted.among(items);
  facts.makespan_bound = makespan_lower_bound(wanted, room, workers);
  if (whole.sizes) {
    facts.makespan_bytes_bound = sized_makespan_bound(*whole.sizes, wanted, workers);
  }
  facts.certificate = (whole.items < items ? "of groups of items: " : "") + whole.certificate;
  facts.all_pairs = wanted.count();
  Stretches cut = cut_order(order, items, workers, even_pairs);
  facts.workers = std::move(cut.workers);
  facts.cut_by_loads = cut.by_loads;
  sum_up(facts);
  WorkerSplit split(std::move(facts), std::move(order));
  put_in_words(split);
  weigh(split);
  return split;
}

// Adds up the bytes that each worker loads.
void SplitMaker::weigh(WorkerSplit& split) {
  const std::shared_ptr<const ItemSizes> sizes = split.order_.facts().sizes;
  if (sizes == nullptr) {
    return;
  }
  for (std::size_t w = 0; w < split.facts_.workers.size(); ++w) {
    std::uint64_t bytes = 0;
    const auto steps = split.stream(w);
    for (Step step; steps->next(step);) {
      bytes = checked_add(bytes, bytes_of(*sizes, step.load));
    }
    split.facts_.workers[w].bytes = bytes;
  }
  sum_up(split.facts_);
}

void SplitMaker::put_in_words(WorkerSplit& split) {
  SplitFacts& facts = split.facts_;
  facts.explanation = split.order_.facts().explanation;
  if (facts.groups < facts.items && facts.group_room > 0) {
    facts.explanation = fmt::format("Of {} groups of at most {} items: {}", facts.groups,
                                    ceil_div(facts.items, facts.groups), facts.explanation);
  }
}

// The order that consists of all shares, one after another.
void SplitMaker::take_steps(WorkerSplit& split, std::shared_ptr<const WorkerSteps> steps) {
  SplitFacts& facts = split.facts_;
  sum_up(facts);
  LoadOrderFacts whole = split.order_.facts();
  whole.items = facts.items;
  whole.room = facts.room;
  whole.loads = facts.loads;
  whole.steps = sum_of(facts.workers, &WorkerFacts::steps);
  split.steps_ = steps;
  split.order_ =
      LoadOrder(std::move(whole), [steps = std::move(steps), workers = facts.workers.size()] {
        return one_after_another(steps, workers);
      });
  weigh(split);
}

WorkerSplit SplitMaker::lists(const WorkerSplit& like, const std::vector<std::vector<Move>>& moves,
                              const std::string& method, const std::string& explanation) {
  SplitFacts facts = like.facts();
  LoadOrderFacts whole = like.order().facts();
  facts.groups = facts.items;
  facts.group_room = facts.room;
  facts.cut_by_loads = false;
  facts.pairs_are_known = false;
  auto lists = std::make_shared<StepLists>();
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    facts.workers[w] = {};
    lists->add(w < moves.size() ? moves[w] : std::vector<Move>());
    count_moves_of(w < moves.size() ? moves[w] : std::vector<Move>(), facts.workers[w]);
  }
  whole.group_items = 0;
  whole.method = method;
  whole.explanation = explanation;
  WorkerSplit split(std::move(facts), LoadOrder(std::move(whole), {}));
  take_steps(split, std::move(lists));
  put_in_words(split);
  return split;
}

WorkerSplit SplitMaker::shares(GroupShares shares, std::uint64_t items, std::uint64_t room,
                               std::uint64_t workers) {
  SplitFacts facts;
  facts.items = items;
  facts.room = room;
  facts.groups = shares.groups;
  const WantedPairs all = items;
  facts.makespan_bound = makespan_lower_bound(all, room, workers);
  facts.all_pairs = all.count();
  facts.workers.resize(static_cast<std::size_t>(workers));
  const ItemGroups groups{items, shares.groups};
  for (std::size_t w = 0; w < shares.workers.size(); ++w) {
    const ShareCost cost = cost_of(shares.workers[w], groups, room);
    facts.workers[w].steps = cost.steps;
    facts.workers[w].loads = cost.loads;
  }
  LoadOrderFacts whole;
  whole.bound = load_lower_bound(all, room);
  whole.method = shares.method;
  whole.explanation =
      (shares.groups == items ? std::string("The items are ")
                              : fmt::format("The {} groups, of at most {} items, are ",
                                            shares.groups, ceil_div(items, shares.groups))) +
      shares.explanation;
  whole.certificate = facts.certificate = "not read yet";
  WorkerSplit split(std::move(facts), LoadOrder(std::move(whole), {}));
  take_steps(split, std::make_shared<GroupSteps>(std::move(shares), items, room));
  put_in_words(split);
  return split;
}

WorkerSplit SplitMaker::blocks(HeldBlocks blocks, const WorkerSplit& other) {
  SplitFacts facts = other.facts();
  LoadOrderFacts whole = other.order().facts();
  whole.steps = 0;
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    WorkerFacts& worker = facts.workers[w] = {};
    if (w < blocks.shapes.size()) {
      worker.first_step = whole.steps + 1;
      worker.steps = blocks.shapes[w].steps;
      worker.loads = blocks.shapes[w].loads;
      whole.steps += worker.steps;
    }
  }
  sum_up(facts);
  whole.loads = facts.loads;
  whole.method = "held groups, a block a worker";
  whole.explanation = fmt::format("{} of the first set with {} of the other; the first pair: {}",
                                  count_of(blocks.first_parts, "part"),
                                  count_of(blocks.other_parts, "part"), blocks.shapes[0].explain());
  const auto shared = std::make_shared<const HeldBlocks>(std::move(blocks));
  const std::uint64_t items = whole.items;
  WorkerSplit split(std::move(facts), LoadOrder(std::move(whole), [shared, items] {
                      return block_steps(shared, items);
                    }));
  put_in_words(split);
  return split;
}

WorkerSplit SplitMaker::for_fewer_pairs(WorkerSplit split, const WantedPairs& wanted,
                                        const LoadBound& bound, const LoadBound& makespan_bound) {
  LoadOrderFacts whole = split.order_.facts();
  whole.wanted = wanted;
  whole.bound = bound;
  whole.explanation = "An order for all pairs. " + whole.explanation;
  split.order_ = LoadOrder(std::move(whole), split.order_.maker());
  split.facts_.makespan_bound = makespan_bound;
  split.facts_.all_pairs = wanted.count();
  split.facts_.pairs_are_known = false;
  put_in_words(split);
  leave_out_unneeded(split);
  return split;
}

// Removes items in no listed pair, which orders for all pairs load.
void SplitMaker::leave_out_unneeded(WorkerSplit& split) {
  const PairGraph* const graph = split.order_.facts().wanted.graph();
  const auto is_needed = [&](Element x) { return graph->is_needed(x); };
  if (graph == nullptr ||
      std::ranges::all_of(std::views::iota(Element{0}, static_cast<Element>(graph->items())),
                          is_needed)) {
    return;
  }
  SplitFacts& facts = split.facts_;
  auto lists = std::make_shared<StepLists>();
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    std::vector<Move> moves;
    const auto steps = split.stream(w);
    for (Step step; steps->next(step);) {
      stop_if_asked();
      std::erase_if(step.evict, std::not_fn(is_needed));
      std::erase_if(step.load, std::not_fn(is_needed));
      moves.push_back({step.evict, step.load});
    }
    moves = lazily(moves, facts.room, split.order_.facts().sizes.get());
    facts.workers[w] = {};
    count_moves_of(moves, facts.workers[w]);
    lists->add(moves);
  }
  split.owners_ = nullptr;  // they belonged to the former steps
  take_steps(split, std::move(lists));
}

bool SplitMaker::are_few(const WorkerSplit& split) {
  return (split.facts_.items <= most_items_of_a_table ||
          split.order_.facts().wanted.graph() != nullptr) &&
         split.facts_.workers.size() <= most_workers_of_a_table;
}

void SplitMaker::spread(WorkerSplit& split, const std::function<bool(Element, Element)>& computed,
                        const std::function<double(Element, Element)>& cost, bool first_holder) {
  SplitFacts& facts = split.facts_;
  if (!are_few(split) || (facts.workers.size() == 1 && !computed && !cost)) {
    if (computed) {
      throw BadInput("too many items for a part of their pairs to be left out");
    }
    return;
  }
  const ScheduleRules rules = split.rules();
  SpreadPairs spread = spread_pairs(
      rules, facts.workers, [&](std::uint64_t worker) { return split.stream(worker); }, cost,
      computed, first_holder);
  facts.workers = std::move(spread.workers);
  facts.has_costs = cost != nullptr;
  facts.pairs_are_known = true;
  split.owners_ = std::move(spread.owners);
  if (spread.steps) {
    facts.cut_by_loads = false;
    take_steps(split, std::move(spread.steps));
    if (first_holder) {  // What stays longer now may be the first to have a pair.
      SplitMaker::spread(split, computed, cost, first_holder);
    }
  }
  sum_up(facts);
}

void SplitMaker::give_pairs(WorkerSplit& split, const LoadOrderOptions& options) {
  SplitFacts& facts = split.facts_;
  const LoadOrderFacts& whole = split.order_.facts();
  const bool all = whole.wanted.are_all();
  const bool is_short = are_few(split);
  if (options.pair_cost && !is_short) {
    throw BadInput(
        fmt::format("all pairs with costs are too many; give at most {} items and {} workers, or "
                    "list the pairs",
                    most_items_of_a_table, most_workers_of_a_table));
  }
  const auto take = [&](const auto& owners) {
    set_pairs(facts, owners->pairs());
    facts.pairs_are_known = true;
    split.owners_ = owners;
  };
  // More workers than steps: some have none, and the first that has a pair computes it.
  const bool is_streamed = all && whole.method == "streamed" && facts.groups == facts.items &&
                           facts.workers.size() <= whole.steps;
  if (facts.workers.size() == 1 && !options.pair_cost) {
    facts.workers[0].pairs = facts.all_pairs;
    facts.pairs_are_known = true;
  } else if (!options.balance && is_short) {
    spread(split, {}, options.pair_cost, true);
  } else if (!options.balance) {
    split.owners_ = nullptr;
  } else if (const auto* const groups = dynamic_cast<const GroupSteps*>(split.steps_.get());
             groups != nullptr && all && !options.pair_cost) {
    if (groups->shares().plane_order > 0 && facts.groups > most_groups_of_a_table) {
      const std::uint64_t q = groups->shares().plane_order;
      take(std::make_shared<const PlaneOwners>(Plane(q, facts.groups == q * q), facts.items));
    } else {
      take(owners_of(groups->shares(), facts.items));
    }
  } else if (facts.groups < facts.items && all && !options.pair_cost) {
    take(owners_of_stretches(split.order_, facts.workers, facts.items));
  } else if (is_short) {
    spread(split, {}, options.pair_cost);
  } else if (is_streamed) {
    take(std::make_shared<const StreamedOwners>(split.order_, facts.workers));
  }
  sum_up(facts);
}

void SplitMaker::own_orders(WorkerSplit& split, const OwnOrder& make) {
  SplitFacts& facts = split.facts_;
  const WantedPairs& wanted = split.order_.facts().wanted;
  const auto has_partner = [&](Element x) {
    return wanted.graph() == nullptr || !wanted.graph()->partners(x).empty();
  };
  std::vector<std::vector<ItemPair>> pairs(facts.workers.size());
  StepWork work(split.stream(), split.rules(ComputeRules{.self = true}), split.owners_);
  for (Step step; work.next(step);) {
    for (const auto& [x, y] : step.compute) {
      if (x != y || !has_partner(x)) {
        pairs[static_cast<std::size_t>(step.worker)].emplace_back(x, y);
      }
    }
  }
  auto lists = std::make_shared<StepLists>();
  std::vector<std::vector<Element>> alone(pairs.size());
  std::vector<bool> is_loaded(static_cast<std::size_t>(facts.items), false);
  facts.transfers = 0;
  const std::vector<std::vector<Move>> moves = make(pairs);
  for (std::size_t w = 0; w < pairs.size(); ++w) {
    count_moves_of(moves[w], facts.workers[w]);
    for (const Move& move : moves[w]) {
      facts.transfers += move.fast_load.size();
      for (const Element x : move.load) {
        if (!is_loaded[x]) {
          is_loaded[x] = true;
          alone[w].push_back(x);
        }
      }
    }
    lists->add(moves[w]);
  }
  facts.cut_by_loads = false;
  facts.groups = facts.items;
  facts.group_room = facts.room;
  if (pairs.size() <= most_workers_of_a_table) {
    split.owners_ = owners_of_lists(wanted.among(facts.items), pairs, alone);
  } else {  // The first that has a pair computes it, which is known when all is read.
    facts.pairs_are_known = false;
  }
  take_steps(split, std::move(lists));
}

WorkerSplit SplitMaker::two_levels(WorkerSplit split, const LoadOrderFacts& levels,
                                   const LoadOrderOptions& options) {
  constexpr std::size_t most_searched = 4;  // workers, some seconds each
  own_orders(split, [&](const std::vector<std::vector<ItemPair>>& pairs) {
    return each_of<std::vector<Move>>(pairs, [&](const std::vector<ItemPair>& of_worker) {
      return levels.sizes ? sized_levels_of(of_worker, *levels.sizes, options)
                          : listed_levels_of(of_worker, split.facts().room, *levels.fast_room,
                                             pairs.size() <= most_searched, options);
    });
  });
  LoadOrderFacts whole = split.order_.facts();
  whole.fast_room = levels.fast_room;
  whole.sizes = levels.sizes;
  whole.bound = levels.bound;
  whole.transfer_bound = levels.transfer_bound;
  whole.byte_bound = levels.byte_bound;
  whole.transfer_byte_bound = levels.transfer_byte_bound;
  whole.transfers = split.facts_.transfers;
  whole.method = "two levels";
  whole.explanation =
      "Pairs are given to workers as at one level; each worker has an order for its pairs.";
  split.order_ = LoadOrder(std::move(whole), split.order_.maker());
  put_in_words(split);
  return split;
}

void SplitMaker::verify(WorkerSplit& split, const LoadOrderOptions& options) {
  SplitFacts& facts = split.facts_;
  LoadOrderFacts whole = split.order_.facts();
  const auto say = [&](bool every_step_read, const std::string& certificate) {
    whole.every_step_read = every_step_read;
    whole.certificate = facts.certificate = certificate;
    split.order_ = LoadOrder(std::move(whole), split.order_.maker());
  };
  const bool listed = whole.wanted.graph() != nullptr;
  if (!listed &&
      (facts.items > std::min<std::uint64_t>(options.read_up_to, max_elements_in_memory) ||
       facts.loads > most_loads_read)) {
    if (const auto* const groups = dynamic_cast<const GroupSteps*>(split.steps_.get())) {
      say(false, certify(groups->shares()));
    }
    return;
  }
  if (!options.read_first && !whole.sizes) {
    return say(false, "not read yet");
  }
  const std::string what =
      whole.fast_room ? fmt::format("{} items with room for {} and {}, for {} workers", facts.items,
                                    facts.room, *whole.fast_room, facts.workers.size())
                      : fmt::format("{} items with room for {}, for {} workers", facts.items,
                                    facts.room, facts.workers.size());
  ScheduleRules rules = split.rules();
  CheckOptions how;
  if (whole.method == "streamed" && facts.groups == facts.items) {
    how.kept_as = names_by_window(best_streamed_shape(facts.items, facts.room));
  }
  std::unique_ptr<StepSource> steps = split.stream();
  const bool computes = facts.all_pairs <= most_pairs_computed;
  how.by_worker = !computes && split.owners_ == nullptr;
  if (computes) {
    rules.compute = ComputeRules{};
    steps = std::make_unique<StepWork>(std::move(steps), rules, split.owners_);
  }
  ScheduleVerdict verdict = check_schedule(*steps, rules, how);
  verdict.worker_pairs.resize(facts.workers.size(), 0);
  const std::vector<std::uint64_t> said =
      each_of<std::uint64_t>(facts.workers, &WorkerFacts::pairs);
  // Pairs that met first are the computed ones if they belong to the first worker that has them.
  const bool are_shown = facts.pairs_are_known && (computes || split.owners_ == nullptr);
  verdict.worker_bytes.resize(facts.workers.size(), 0);
  const bool are_weighed = !whole.sizes || std::ranges::equal(verdict.worker_bytes, facts.workers,
                                                              {}, {}, &WorkerFacts::bytes);
  if (!verdict.valid() || verdict.loads != facts.loads || !are_weighed ||
      (are_shown && verdict.worker_pairs != said)) {
    throw InternalError(
        fmt::format("the split of {} is wrong: {}{}", what, verdict.fault, verdict.example));
  }
  if (!facts.pairs_are_known && (computes || split.owners_ == nullptr)) {
    set_pairs(facts, verdict.worker_pairs);
    facts.pairs_are_known = true;
    sum_up(facts);
  }
  facts.transfers = verdict.transfers;
  whole.bytes = verdict.bytes;
  whole.transfer_bytes = verdict.transfer_bytes;
  whole.most_bytes = verdict.most_bytes;
  const std::string bytes =
      whole.sizes ? fmt::format(", at most {} bytes in memory", verdict.most_bytes) : "";
  say(true, whole.fast_room
                ? levels_read(verdict, facts.all_pairs, whole.sizes != nullptr)
                : "every step read, " +
                      all_met(facts.all_pairs, whole.wanted.are_all() ? "pair" : "wanted pair") +
                      bytes);
}

// All groups are treated alike: shares with two items per group are right if and only if those with
// any number are.
std::string SplitMaker::certify(const GroupShares& shares) {
  constexpr std::uint64_t each = 2;
  const std::uint64_t items = each * shares.groups;
  GroupShares few = shares;
  const std::uint64_t room = largest_of(
      shares.workers, [&](const GroupShare& share) { return each * share.held.size() + 1; });
  const WorkerSplit split = SplitMaker::shares(std::move(few), items, room, shares.workers.size());
  const ScheduleVerdict verdict = check_schedule(*split.stream(), split.rules());
  if (!verdict.valid()) {
    throw InternalError(fmt::format("shares of {} groups are wrong: {}{}", shares.groups,
                                    verdict.fault, verdict.example));
  }
  return fmt::format("structure: all steps of {} items a group read, all {} pairs of {} groups met",
                     each, split.facts().all_pairs, shares.groups);
}

WorkerSplit split_order(LoadOrder order, std::uint64_t items, std::uint64_t room,
                        std::uint64_t workers) {
  check_workers(workers);
  const LoadOrderFacts& whole = order.facts();
  if (whole.items > items) {
    throw BadInput(fmt::format("{} cannot be put into {} groups; give no more groups than items",
                               count_of(items, "item"), whole.items));
  }
  if (whole.lockstep > 1) {
    throw BadInput(fmt::format(
        "an order for {} workers in lockstep cannot be cut for other workers", whole.lockstep));
  }
  return SplitMaker::stretches(std::move(order), items, room, workers, false);
}

}  // namespace changeover
