#include "loadorder/show/show_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "loadorder/show/bytes_moved.hpp"
#include "loadorder/show/counted_pairs.hpp"
#include "loadorder/show/marius_writer.hpp"
#include "loadorder/show/schedule_keys.hpp"
#include "loadorder/show/step_writer.hpp"
#include "loadorder/show/worker_words.hpp"
#include "loadorder/training/epochs.hpp"

namespace changeover {
namespace {

/// A schedule in words: a head that depends on its kind, then its steps, generated again at each
/// reading.
class ScheduleText {
 public:
  using Maker = std::function<std::unique_ptr<StepSource>()>;

  ScheduleText(LoadOrderFacts facts, Maker loads, const LoadsShown& how)
      : facts_(std::move(facts)),
        loads_(std::move(loads)),
        how_(how),
        rules_{.items = facts_.items,
               .room = facts_.room,
               .fast_room = facts_.fast_room,
               .lockstep = facts_.lockstep,
               .wanted = facts_.wanted,
               .store = how.write_back,
               .sizes = facts_.sizes,
               .epochs = facts_.epochs} {
    if (how.new_pairs || how.write_back) {
      rules_.compute = how.compute;
    }
  }

  /// Loads overlap computation: `spare` places of the room are kept for them.
  void overlap(std::uint64_t spare) {
    spare_ = spare;
    rules_.overlap = true;
    rules_.compute = how_.compute;
  }
  /// The steps are those of workers one after another.
  void split(const WorkerSplit& split) {
    split_ = &split.facts();
    rules_.shares = true;
    owners_ = split.owners();
  }

  void show(Sink& out) {
    if (must_check()) {
      check();
    }
    const std::string verified = how_verified();
    JsonWriter json;
    json.begin_object().key("format").value("changeover-loads/1");
    std::string text = about(json);
    json.key("verified").value(verified);
    if (split_ != nullptr || facts_.lockstep > 0) {
      json.key("worker_loads").value(facts_.worker_loads);
      WorkerWords(facts_, split_).say_each(json);
    }
    text += "verified: " + verified + "\n" + at_the_end();
    if (how_.format == "marius") {
      write_for_marius(out);
      return;
    }
    const PairGraph* const graph = facts_.wanted.graph();
    StepWriter writer(out, how_.format, graph != nullptr ? &graph->names() : nullptr, columns());
    writer.begin(json.end_object().take(), text);
    if (!how_.head_only) {
      write(writer);
    }
  }

 private:
  [[nodiscard]] std::unique_ptr<StepSource> steps() const {
    return rules_.compute ? std::make_unique<StepWork>(loads_(), rules_, owners_) : loads_();
  }

  // Whether the computed pairs are tracked.
  [[nodiscard]] bool each_pair_once() const {
    return facts_.items <= max_elements_in_memory || facts_.wanted.graph() != nullptr;
  }

  // A schedule that is too large to be tracked is not read twice.
  [[nodiscard]] bool must_check() const {
    return !how_.beside && !how_.worker_by_itself && !how_.from_step && is_more_than_loads();
  }

  [[nodiscard]] bool is_more_than_loads() const {
    return rules_.store || (rules_.compute && (spare_ ? facts_.every_step_read : each_pair_once()));
  }

  // Reads the steps with what they compute. @throws InternalError
  void check() {
    CheckOptions options;
    options.all_pairs = each_pair_once();
    CountedPairs counted(steps(), workers());
    checked_ = check_schedule(counted, rules_, options);
    if (!checked_.valid() || checked_.loads != facts_.loads ||
        checked_.transfers != facts_.transfers ||
        (facts_.lockstep > 0 && checked_.span != facts_.span) || !match_head(counted.pairs())) {
      throw InternalError(fmt::format("what the steps do is wrong: {} missing, {} repeated; {}",
                                      checked_.missing, checked_.repeated, checked_.fault));
    }
    if (facts_.lockstep > 0) {
      facts_.worker_pairs =
          counted.pairs();  // spreading at random moves pairs between workers, too
    }
  }

  // Whether the computed pairs of each worker are those of the head.
  [[nodiscard]] bool match_head(const std::vector<std::uint64_t>& computed) const {
    return split_ == nullptr || !split_->pairs_are_known ||
           std::ranges::equal(computed, split_->workers, {}, {}, &WorkerFacts::pairs);
  }

  // One line on the verification.
  [[nodiscard]] std::string how_verified() const {
    if (how_.worker_by_itself) {
      return fmt::format(
          "the steps of worker {} are read while they are written; those of others are not",
          *how_.worker);
    }
    if (how_.beside) {
      return each_pair_once() ? "every step is read while it is written"
                              : "64 items are followed while it is written";
    }
    const std::string lost = rules_.store ? "; no change is lost" : "";
    const std::string computed = fmt::format("{} computed", count_of(checked_.computed, "pair"));
    if (spare_ && facts_.every_step_read) {
      return fmt::format("simulated, {} computed once, {} of them while items load{}",
                         all_of(checked_.computed, "pair"), checked_.overlapped, lost);
    }
    if (checked_.steps > 0 && facts_.lockstep > 0) {
      return fmt::format("every step read: no item held twice at once, {}{}, each once{}",
                         facts_.fast_room ? "room at both levels, " : "", computed, lost);
    }
    if (checked_.steps > 0 && facts_.fast_room) {
      return fmt::format("every step read: {} at both levels, {} on the accelerator, each once{}",
                         facts_.sizes ? "bytes" : "room", computed, lost);
    }
    std::string line = facts_.certificate;
    if (follow()) {
      line += "; 64 items are followed while it is written";
    }
    if (rules_.compute && !facts_.fast_room && facts_.lockstep == 0) {
      line += each_pair_once() && !spare_ ? "; " + computed + ", each once"
                                          : "; a pair may be computed more than once";
    }
    return line + lost;
  }

  [[nodiscard]] bool follow() const {
    return !facts_.every_step_read && !spare_ && !how_.from_step;
  }

  // The lines before the one on the verification; adds the keys of the schedule to `json`.
  std::string about(JsonWriter& json) const {
    const LoadBound bound = bound_of_loads(rules_, facts_.room, workers());
    const std::uint64_t steps = facts_.steps + (rules_.store ? 1 : 0);
    const ScheduleKeys keys(facts_, split_, how_);
    keys.say_question(json);
    keys.say_bytes(checked_, json);
    json.key("loads").value(facts_.loads);
    if (facts_.fast_room) {
      json.key("transfers").value(facts_.transfers);
    }
    json.key("steps").value(steps);
    json.key("lower_bound").value(bound.loads).key("lower_bound_reason").value(bound.reason);
    keys.say_levels_or_method(json);
    json.key("explanation").value(facts_.explanation);
    keys.say_workers(json);
    if (spare_) {
      keys.say_spare(*spare_, bound_beside_spare(), checked_, json);
    }
    std::string spread = say_spread(json) + say_early(json);
    const std::string stores = say_stores(json, bound);
    if (facts_.lockstep > 0) {
      json.key("disjoint").value(true);
    }
    const bool plain = workers() == 0 && !spare_ && !facts_.fast_room;
    if (plain) {
      json.key("gap").value(facts_.gap());
    }
    const std::string method = facts_.fast_room ? facts_.explanation + "\n"
                                                : facts_.method + ": " + facts_.explanation + "\n";
    spread += how_.time_is_up ? say_that_time_is_up(json) : "";
    if (how_.item_bytes && !facts_.fast_room) {
      const std::uint64_t bytes = bytes_of_moves(facts_.loads, how_, "load");
      spread += fmt::format("{} {} loaded\n", count_of(bytes, "byte"), bytes == 1 ? "is" : "are");
    }
    return in_short(bound, steps) + epochs_in_words(facts_) + spread + stores +
           (plain ? hint() : "") + method + bounds(bound);
  }

  [[nodiscard]] std::uint64_t workers() const { return workers_of(facts_, split_); }

  // If places are kept for what is loading: the bound of orders for the other places. An order for
  // the whole room may have fewer loads, but then loads wait for what leaves.
  [[nodiscard]] std::optional<LoadBound> bound_beside_spare() const {
    if (spare_.value_or(0) == 0 || facts_.sizes) {
      return std::nullopt;
    }
    return bound_of_loads(rules_, facts_.room - *spare_, workers());
  }

  // What is kept for loads in progress, and what no order for the rest goes below.
  [[nodiscard]] std::string spare_in_words() const {
    if (!spare_) {
      return "";
    }
    if (*spare_ == 0 || facts_.sizes) {
      return fmt::format("{} kept for what is loading\n",
                         *spare_ == 0 ? "no place is" : fmt::format("{} bytes are", *spare_));
    }
    const std::uint64_t others = facts_.room - *spare_;
    return "one of the places is kept for what is loading; " +
           (split_ != nullptr ? fmt::format("with {} some worker has at least {}\n", others,
                                            count_of(split_->makespan_bound.loads, "load"))
                              : fmt::format("no order for {} has fewer than {}\n", others,
                                            count_of(bound_beside_spare()->loads, "load")));
  }

  std::string say_spread(JsonWriter& json) const {
    if (!how_.compute.spread || checked_.steps == 0) {
      return "";
    }
    const std::uint64_t steps_of_all = facts_.steps * std::max<std::uint64_t>(1, facts_.lockstep);
    say_most(json, "pairs_per_step", checked_.most_in_a_step,
             static_cast<double>(checked_.computed) / static_cast<double>(steps_of_all));
    return fmt::format("pairs are spread over steps: at most {} in one, at least {}\n",
                       checked_.most_in_a_step, ceil_div(checked_.computed, steps_of_all));
  }

  std::string say_early(JsonWriter& json) const {
    if (!how_.early) {
      return "";
    }
    json.key("loads_ahead").value(checked_.ahead);
    return fmt::format("{} of {} start in a step before the item is transferred\n", checked_.ahead,
                       count_of(facts_.loads, "load"));
  }

  std::string say_stores(JsonWriter& json, const LoadBound& bound) const {
    if (!rules_.store) {
      return "";
    }
    const LoadBound least =
        store_lower_bound(bound, facts_.wanted, facts_.items, how_.compute.self);
    json.key("stores").value(checked_.stores).key("store_bound").value(least.loads);
    return fmt::format("{}, at least {}: {}\n", count_of(checked_.stores, "store"), least.loads,
                       least.reason);
  }

  // The first lines.
  [[nodiscard]] std::string in_short(const LoadBound& bound, std::uint64_t steps) const {
    const std::string loads = count_of(facts_.loads, "load");
    const std::string spare = spare_in_words();
    if (facts_.lockstep > 0) {
      return WorkerWords(facts_, split_).in_lockstep(what_meets(), in_epochs(), steps, bound) +
             (facts_.fast_room
                  ? facts_.sizes
                        ? fmt::format("to the accelerators, with {} bytes: {}\n",
                                      facts_.sizes->fast_memory, bytes_transferred())
                        : fmt::format("to the accelerators, with room for {}: {}\n",
                                      *facts_.fast_room,
                                      level(facts_.transfers, "transfer", facts_.transfer_bound))
                  : "");
    }
    const std::string busiest = WorkerWords(facts_, split_).busiest();
    if (facts_.fast_room && facts_.sizes) {
      return fmt::format(
          "{}, {} bytes of memory and {} on the accelerator{}: {}\n{}"
          "from the disk: {} bytes in {}, {}\nto the accelerator: {}\n",
          what_meets(), facts_.sizes->memory, facts_.sizes->fast_memory, in_epochs(),
          count_of(steps, "step"), busiest, facts_.bytes, loads,
          over(facts_.bytes, facts_.byte_bound), bytes_transferred());
    }
    if (facts_.fast_room) {
      return fmt::format(
          "{}, room for {} in memory and {} of them on the accelerator{}: {}\n{}"
          "from the disk: {}\nto the accelerator: {}\n",
          what_meets(), facts_.room, *facts_.fast_room, in_epochs(), count_of(steps, "step"),
          busiest, level(facts_.loads, "load", bound),
          level(facts_.transfers, "transfer", facts_.transfer_bound));
    }
    if (facts_.sizes) {
      const std::string what = fmt::format("{}, {} bytes of memory{}: {}", what_meets(),
                                           facts_.sizes->memory, in_epochs(), facts_.bytes);
      return split_ != nullptr ? fmt::format("{} bytes in {}{}", what, busiest, spare)
                               : fmt::format("{} bytes in {} and {}, {}\n{}", what, loads,
                                             count_of(steps, "step"),
                                             over(facts_.bytes, facts_.byte_bound), spare);
    }
    const std::string what =
        fmt::format("{}, room for {}{}: ", what_meets(), facts_.room, in_epochs());
    if (split_ != nullptr) {
      const std::string groups =
          split_->groups == facts_.items ? ""
          : split_->group_room == 0
              ? fmt::format("items in {}\n", count_of(split_->groups, "group"))
              : fmt::format("items in {}, room for {}\n", count_of(split_->groups, "group"),
                            count_of(split_->group_room, "group"));
      return what + busiest + groups + spare;
    }
    return fmt::format(
        "{}{}, {}, in {}\n{}", what, loads,
        spare_ ? fmt::format("lower bound {}", bound.loads) : over(facts_.loads, bound),
        count_of(steps, "step"), spare);
  }

  [[nodiscard]] std::string what_meets() const {
    return facts_.wanted.are_all() ? count_of(facts_.items, "item") : facts_.wanted.describe();
  }

  [[nodiscard]] std::string in_epochs() const {
    return facts_.epochs == 1 ? "" : fmt::format(", {} epochs", facts_.epochs);
  }

  [[nodiscard]] std::string bytes_transferred() const {
    return fmt::format("{} bytes in {}, {}", facts_.transfer_bytes,
                       count_of(facts_.transfers, "transfer"),
                       over(facts_.transfer_bytes, facts_.transfer_byte_bound));
  }

  // The number of moves to a level, with their bytes, and the lower bound.
  [[nodiscard]] std::string level(std::uint64_t count, const std::string& what,
                                  const LoadBound& bound) const {
    const std::string bytes =
        how_.item_bytes ? fmt::format(" ({})", count_of(bytes_of_moves(count, how_, what), "byte"))
                        : "";
    return fmt::format("{}{}, {}", count_of(count, what), bytes, over(count, bound));
  }

  // A hint on how to get fewer loads, where that may help.
  [[nodiscard]] std::string hint() const {
    if (facts_.sizes) {
      return facts_.bytes > facts_.byte_bound.loads && !how_.searched
                 ? "--time 30s may find an order with fewer bytes\n"
                 : "";
    }
    const bool may_help =
        facts_.wanted.graph() != nullptr ||
        (facts_.wanted.are_all() && facts_.items <= LoadOrderOptions().improve_up_to);
    return facts_.gap() > 0 && !how_.searched && may_help
               ? "--time 30s may find an order with fewer\n"
               : "";
  }

  [[nodiscard]] std::string bounds(const LoadBound& bound) const {
    if (facts_.fast_room) {
      return fmt::format(
          "bound of the loads: {}\nbound of the transfers: {}\n{}",
          (facts_.sizes ? facts_.byte_bound : bound).reason,
          (facts_.sizes ? facts_.transfer_byte_bound : facts_.transfer_bound).reason,
          split_ == nullptr ? "" : "bound of the busiest: " + facts_.makespan_bound.reason + "\n");
    }
    if (facts_.lockstep > 0) {
      return fmt::format(
          "bound: {}\nbound of the busiest: {}\n",
          (facts_.sizes ? facts_.byte_bound : bound).reason,
          (facts_.sizes ? facts_.makespan_byte_bound : facts_.makespan_bound).reason);
    }
    if (facts_.sizes) {
      return fmt::format("bound: {}\n", split_ != nullptr ? split_->makespan_bytes_bound.reason
                                                          : facts_.byte_bound.reason);
    }
    const LoadBound& whole = split_ != nullptr ? facts_.makespan_bound : bound;
    const std::optional<LoadBound> other = bound_beside_spare();
    return "bound: " + whole.reason + "\n" +
           (other ? fmt::format("bound with room for {}: {}\n", facts_.room - *spare_,
                                (split_ != nullptr ? split_->makespan_bound : *other).reason)
                  : "");
  }

  [[nodiscard]] std::string at_the_end() const {
    std::string text;
    for (std::size_t w = 0; split_ != nullptr && w < split_->workers.size(); ++w) {
      const WorkerFacts& worker = split_->workers[w];
      text += fmt::format("worker {}: {}{} in {}{}\n", w, count_of(worker.loads, "load"),
                          facts_.sizes ? fmt::format(" of {} bytes", worker.bytes) : "",
                          count_of(worker.steps, "step"),
                          split_->pairs_are_known ? ", " + count_of(worker.pairs, "pair") : "");
    }
    if (spare_) {
      text +=
          "each step: wait for load, compute before; evict first of the next step, start its "
          "loads; compute the others; evict late\n";
    } else if (facts_.lockstep > 0) {
      const bool fast = facts_.fast_room.has_value();
      text += fmt::format("each step: all {}{}evict, wait for each other, load, {}compute\n",
                          fast ? "fast evict, " : "", rules_.store ? "store and " : "",
                          fast ? "fast load, " : "");
    } else if (facts_.fast_room) {
      text += fmt::format("each step: fast evict, {}evict, {}load, {}fast load, compute\n",
                          rules_.store ? "store, " : "", how_.early ? "start to " : "",
                          how_.early ? "wait for what comes next, " : "");
    }
    return text;
  }

  [[nodiscard]] std::vector<Column> columns() const {
    std::vector<Column> all;
    const auto add = [&](bool asked, std::initializer_list<Column> columns) {
      all.insert(all.end(), columns.begin(), asked ? columns.end() : columns.begin());
    };
    const bool fast = facts_.fast_room.has_value();
    add(split_ != nullptr || facts_.lockstep > 0, {Column::worker});
    add(facts_.epochs > 1, {Column::epoch});
    all.push_back(Column::step);
    add(fast, {Column::fast_evict});
    add(!fast, {Column::load});
    // In JSON, the name that every order has.
    add(!rules_.overlap || how_.format == "jsonl", {Column::evict});
    add(rules_.store, {Column::store});
    add(fast, {Column::load, Column::fast_load});
    add(rules_.overlap, {Column::evict_first, Column::evict_late, Column::before, Column::compute});
    add(how_.new_pairs, {Column::new_pairs});
    return all;
  }

  // For a single buffer whose pairs were checked.
  void write_for_marius(Sink& out) const {
    if (!checked_.valid() ||
        (facts_.wanted.graph() != nullptr && !facts_.wanted.graph()->names().empty())) {
      throw BadInput(
          "Marius needs numbered partitions; number the items from 0, at most "
          "65535");
    }
    write_steps_for_marius(facts_, *steps(), out);
  }

  // Writes the steps; an unverified order is checked on the way.
  void write(StepWriter& writer) const {
    std::optional<ScheduleCheck> audit;
    const bool whole = how_.beside && !how_.worker_by_itself;
    if (whole || how_.worker_by_itself || follow()) {
      ScheduleRules loads = rules_;
      if (!whole && !how_.worker_by_itself) {
        loads.compute = {};
      }
      loads.store = false;
      CheckOptions options;
      options.all_pairs = whole && each_pair_once();
      options.seed = how_.seed;
      audit.emplace(loads, options);
    }
    const auto all = steps();
    for (Step step; all->next(step);) {
      const bool of_others = how_.worker && step.worker != *how_.worker;
      if (of_others && how_.worker_by_itself) {
        continue;  // already read to know the rest
      }
      if (audit) {
        audit->read(step);
      }
      if (!of_others) {
        writer.write(step);
      }
    }
    if (audit) {
      const ScheduleVerdict verdict = audit->finish();
      const std::uint64_t loads = how_.worker_by_itself ? loads_of_worker() : facts_.loads;
      const bool right = how_.worker_by_itself
                             ? verdict.fault.empty() && verdict.repeated == 0
                             : verdict.valid() || (verdict.steps == 0 && facts_.steps == 0);
      if (!right || verdict.loads != loads) {  // before the output appears
        throw InternalError(
            fmt::format("the load order is wrong: {}{}", verdict.fault, verdict.example));
      }
    }
    writer.end();
  }

  [[nodiscard]] std::uint64_t loads_of_worker() const {
    return split_->workers[static_cast<std::size_t>(*how_.worker)].loads;
  }

  LoadOrderFacts facts_;
  Maker loads_;
  const LoadsShown& how_;
  ScheduleRules rules_;
  std::optional<std::uint64_t> spare_;
  const SplitFacts* split_ = nullptr;
  std::shared_ptr<const PairOwners> owners_;
  ScheduleVerdict checked_;  // without steps if it was not checked again
};

// For the whole room, of which the order may leave some.
ScheduleText schedule_text_of(const WorkerSplit& split, std::uint64_t room, const LoadsShown& how) {
  const SplitFacts& facts = split.facts();
  // Groups of items have small orders, which were verified.
  LoadOrderFacts whole = split.order().facts();
  whole.items = facts.items;
  whole.room = room;
  whole.loads = facts.loads;
  whole.bytes = facts.bytes;
  whole.transfers = facts.transfers;
  whole.epochs = facts.epochs;
  whole.epoch_loads = facts.epoch_loads;
  whole.steps = sum_of(facts.workers, &WorkerFacts::steps);
  whole.explanation = facts.explanation;
  whole.certificate = facts.certificate;
  whole.makespan_bound = makespan_bound_of(split, room);
  whole.worker_loads = each_of<std::uint64_t>(facts.workers, &WorkerFacts::loads);
  // Without owners, the steps of earlier workers are needed to know what one worker computes.
  const bool alone = how.worker_by_itself && (split.owners() != nullptr || !how.new_pairs);
  ScheduleText said(
      std::move(whole),
      [&split, &how, alone] { return alone ? split.stream(*how.worker) : split.stream(); }, how);
  said.split(split);
  return said;
}

}  // namespace

LoadBound bound_of_loads(const ScheduleRules& rules, std::uint64_t room, std::uint64_t workers) {
  const WantedPairs wanted = rules.wanted.among(rules.items);
  return epochs_lower_bound(load_lower_bound(wanted, room), wanted.count(), room,
                            std::max<std::uint64_t>(1, workers), rules.epochs);
}

LoadBound makespan_bound_of(const WorkerSplit& split, std::uint64_t room) {
  const SplitFacts& facts = split.facts();
  if (room == facts.room) {
    return facts.makespan_bound;
  }
  const WantedPairs wanted = split.order().facts().wanted.among(facts.items);
  const std::uint64_t workers = facts.workers.size();
  LoadBound once = makespan_lower_bound(wanted, room, workers);
  const LoadBound all = epochs_lower_bound(load_lower_bound(wanted, room), wanted.count(), room,
                                           workers, facts.epochs);
  return facts.epochs == 1 ? once : epochs_makespan_bound(once, all, workers);
}

void show_loads(const LoadOrder& order, const LoadsShown& how, Sink& out) {
  ScheduleText(
      order.facts(),
      [&order, &how] { return how.from_step ? order.stream_from(*how.from_step) : order.stream(); },
      how)
      .show(out);
}

void show_loads(const WorkerSplit& split, const LoadsShown& how, Sink& out) {
  schedule_text_of(split, split.facts().room, how).show(out);
}

void show_loads(const PrefetchPlan& plan, const LoadsShown& how, Sink& out) {
  LoadOrderFacts facts = plan.order.facts();
  facts.room += facts.sizes ? 0 : plan.spare;
  ScheduleText said(
      std::move(facts), [&plan] { return plan.order.stream(); }, how);
  said.overlap(plan.spare);
  said.show(out);
}

void show_loads(const PrefetchSplit& plan, const LoadsShown& how, Sink& out) {
  const bool has_sizes = plan.order.order().facts().sizes != nullptr;
  ScheduleText said =
      schedule_text_of(plan.order, plan.order.facts().room + (has_sizes ? 0 : plan.spare), how);
  said.overlap(plan.spare);
  said.show(out);
}

}  // namespace changeover
