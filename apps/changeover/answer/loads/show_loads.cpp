#include "answer/loads/show_loads.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "answer/answer.hpp"
#include "answer/loads/step_writer.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/step_work.hpp"
#include "core/checked.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

std::string over(std::uint64_t count, const LoadBound& bound) {
  return count == bound.loads
             ? "the fewest possible"
             : fmt::format(
                   "{:.2f} % over the lower bound {}",
                   100 * (static_cast<double>(count) / static_cast<double>(bound.loads) - 1),
                   bound.loads);
}

/// A schedule as it is said: its steps, made anew for each reading, and what they keep to.
class Said {
 public:
  using Maker = std::function<std::unique_ptr<StepSource>()>;

  Said(Maker loads, ScheduleRules rules, const LoadsShown& how)
      : loads_(std::move(loads)), rules_(std::move(rules)), how_(how) {
    rules_.store = how.write_back;
    if (how.new_pairs || how.write_back || rules_.overlap || rules_.fast_room) {
      rules_.compute = how.compute;
    }
  }

  [[nodiscard]] std::unique_ptr<StepSource> steps() const {
    return rules_.compute ? std::make_unique<StepWork>(loads_(), rules_) : loads_();
  }

  /// Whether it is kept in mind which pairs were computed.
  [[nodiscard]] bool each_pair_once() const {
    return rules_.items <= max_elements_in_memory || rules_.wanted.graph() != nullptr;
  }

  /// Reads the steps that say what is computed; they have so many loads. @throws InternalError
  void check(std::uint64_t loads) {
    if (!rules_.compute) {
      return;
    }
    CheckOptions options;
    options.all_pairs = each_pair_once();
    checked_ = check_schedule(*steps(), rules_, options);
    if (!checked_.valid() || checked_.loads != loads) {
      throw InternalError(fmt::format("what the steps do is wrong: {} missing, {} repeated; {}",
                                      checked_.missing, checked_.repeated, checked_.fault));
    }
  }
  [[nodiscard]] const ScheduleVerdict& checked() const { return checked_; }

  /// One line about it, after that about the loads.
  [[nodiscard]] std::string verified() const {
    std::string text;
    if (rules_.compute) {
      text = each_pair_once()
                 ? fmt::format("; {} computed, each once", count_of(checked_.computed, "pair"))
                 : "; a pair may be computed more than once";
    }
    return text + no_change_lost();
  }
  [[nodiscard]] std::string no_change_lost() const {
    return rules_.store ? "; no change is lost" : "";
  }

  /// What overlaps, for the head in JSON; one line about it.
  std::string overlap(JsonWriter& json, const LoadOrderFacts& facts,
                      std::uint64_t order_room) const {
    json.key("order_room").value(order_room);
    if (!facts.every_step_read) {
      return facts.certificate + "; a pair may be computed more than once" + no_change_lost();
    }
    json.key("pairs").value(checked_.computed).key("overlapped").value(checked_.overlapped);
    return fmt::format("simulated, all {} pairs computed once, {} of them while items load{}",
                       checked_.computed, checked_.overlapped, no_change_lost());
  }

  /// What is stored, for the head in JSON, and in text.
  std::string stores(JsonWriter& json, const LoadBound& bound) const {
    if (!rules_.store) {
      return "";
    }
    const LoadBound least =
        store_lower_bound(bound, rules_.wanted, rules_.items, how_.compute.self);
    json.key("stores").value(checked_.stores).key("store_bound").value(least.loads);
    return fmt::format("{}, at least {}: {}\n", count_of(checked_.stores, "store"), least.loads,
                       least.reason);
  }

  [[nodiscard]] StepWriter writer(OutputFile& out, bool workers) const {
    const PairGraph* const graph = rules_.wanted.graph();
    return {out, how_.format, graph != nullptr ? &graph->names() : nullptr, columns(workers)};
  }

  /// The steps. `follow`: an order that was not read before, with its loads, is followed on the
  /// way.
  void write(StepWriter& writer, std::optional<std::uint64_t> follow = {}) const {
    std::optional<ScheduleCheck> audit;
    if (follow) {
      ScheduleRules loads = rules_;
      loads.compute = {};
      CheckOptions options;
      options.all_pairs = false;
      options.seed = how_.seed;
      audit.emplace(loads, options);
    }
    const auto all = steps();
    for (Step step; all->next(step);) {
      if (audit) {
        audit->read(step);
      }
      writer.write(step);
    }
    if (audit) {
      const ScheduleVerdict verdict = audit->finish();
      if (!verdict.valid() || verdict.loads != *follow) {  // before the output appears
        throw InternalError(
            fmt::format("the load order is wrong: {}{}", verdict.fault, verdict.example));
      }
    }
    writer.end();
  }

 private:
  [[nodiscard]] std::vector<Column> columns(bool workers) const {
    std::vector<Column> all;
    const auto add = [&](bool asked, std::initializer_list<Column> columns) {
      all.insert(all.end(), columns.begin(), asked ? columns.end() : columns.begin());
    };
    const bool fast = rules_.fast_room.has_value();
    add(workers, {Column::worker});
    all.push_back(Column::step);
    add(fast, {Column::fast_evict});
    add(!fast, {Column::load});
    add(!rules_.overlap || how_.format == "jsonl",
        {Column::evict});  // the name that every order has
    add(rules_.store, {Column::store});
    add(fast, {Column::load, Column::fast_load});
    add(rules_.overlap, {Column::evict_first, Column::evict_late, Column::before, Column::compute});
    add(how_.new_pairs, {Column::new_pairs});
    return all;
  }

  Maker loads_;
  ScheduleRules rules_;
  const LoadsShown& how_;
  ScheduleVerdict checked_;
};

/// What orders of all kinds say first.
JsonWriter head_of(const LoadOrderFacts& facts, const LoadBound& bound, std::uint64_t steps) {
  JsonWriter json;
  json.begin_object().key("items").value(facts.items).key("room").value(facts.room);
  if (!facts.wanted.are_all()) {
    json.key("wanted").value(facts.wanted.describe());
    json.key("wanted_pairs").value(facts.wanted.count());
  }
  json.key("loads").value(facts.loads).key("steps").value(steps);
  json.key("lower_bound").value(bound.loads).key("lower_bound_reason").value(bound.reason);
  json.key("method").value(facts.method).key("explanation").value(facts.explanation);
  return json;
}

void list_loads(JsonWriter& json, const std::vector<std::uint64_t>& loads) {
  json.key("worker_loads").begin_array();
  for (const std::uint64_t each : loads) {
    json.value(each);
  }
  json.end_array();
}

std::string sentence(const LoadOrderFacts& facts) {
  return fmt::format(
      "{}, room for {}: ",
      facts.wanted.are_all() ? count_of(facts.items, "item") : facts.wanted.describe(), facts.room);
}

LoadBound bound_for(const LoadOrderFacts& facts) {
  return facts.wanted.are_all() ? load_lower_bound(facts.items, facts.room)
                                : load_lower_bound(facts.wanted, facts.room);
}

// How to get fewer loads, where that may help.
std::string hint(const LoadsShown& how, const LoadOrderFacts& facts) {
  const bool may_help = facts.wanted.graph() != nullptr ||
                        (facts.wanted.are_all() && facts.items <= LoadOrderOptions().improve_up_to);
  return facts.gap() > 0 && !how.searched && may_help ? "--time 30s may find an order with fewer\n"
                                                      : "";
}

// About the loads; an order that was not read before is followed.
std::string certificate(const LoadOrderFacts& facts) {
  return facts.every_step_read ? facts.certificate
                               : facts.certificate + "; 64 items are followed while it is written";
}

std::optional<std::uint64_t> to_follow(const LoadOrderFacts& facts) {
  return facts.every_step_read ? std::nullopt : std::optional(facts.loads);
}

ScheduleRules rules_of(const LoadOrderFacts& facts) {
  return {.items = facts.items, .room = facts.room, .wanted = facts.wanted};
}

}  // namespace

void show_loads(const LoadOrder& order, const LoadsShown& how, OutputFile& out) {
  const LoadOrderFacts& facts = order.facts();
  Said said([&order] { return order.stream(); }, rules_of(facts), how);
  said.check(facts.loads);
  const std::string verified = certificate(facts) + said.verified();
  const std::uint64_t steps = facts.steps + (how.write_back ? 1 : 0);
  JsonWriter json = head_of(facts, facts.bound, steps);
  const std::string stores = said.stores(json, facts.bound);
  json.key("gap").value(facts.gap()).key("verified").value(verified).end_object();
  StepWriter writer = said.writer(out, false);
  writer.begin(json.take(),
               fmt::format("{}{} in {}, {}\n{}{}{}: {}\nbound: {}\nverified: {}\n", sentence(facts),
                           count_of(facts.loads, "load"), count_of(steps, "step"),
                           over(facts.loads, facts.bound), stores, hint(how, facts), facts.method,
                           facts.explanation, facts.bound.reason, verified));
  said.write(writer, to_follow(facts));
}

namespace {

constexpr const char* spare_places[] = {"no place is kept for what is loading\n",
                                        "one of the places is kept for what is loading\n"};
constexpr const char* overlapping_step =
    "each step: wait for load, compute before; evict first of the next step, start its loads; "
    "compute the others; evict late\n";

// `spare` is given if loads overlap computation; `room` includes it then.
void show_split(const WorkerSplit& split, std::uint64_t room, std::optional<std::uint64_t> spare,
                const LoadsShown& how, OutputFile& out) {
  const SplitFacts& facts = split.facts();
  // Groups of items have small orders, which were read.
  LoadOrderFacts whole = split.order().facts();
  whole.items = facts.items;
  whole.room = room;
  whole.loads = facts.loads;
  whole.explanation = facts.explanation;
  whole.certificate = facts.certificate;
  const std::uint64_t workers = facts.workers.size();
  const LoadBound makespan_bound = !spare ? facts.makespan_bound
                                   : whole.wanted.are_all()
                                       ? makespan_lower_bound(whole.items, room, workers)
                                       : makespan_lower_bound(whole.wanted, room, workers);
  ScheduleRules rules = rules_of(whole);
  rules.overlap = spare.has_value();
  Said said([&split] { return split.stream(); }, rules, how);
  if (!spare || whole.every_step_read) {
    said.check(facts.loads);
  }
  JsonWriter json = head_of(whole, bound_for(whole), whole.steps);
  json.key("workers").value(workers).key("makespan").value(facts.makespan);
  json.key("makespan_bound").value(makespan_bound.loads);
  json.key("makespan_bound_reason").value(makespan_bound.reason);
  json.key("groups").value(facts.groups);
  const std::string verified =
      spare ? said.overlap(json, whole, facts.room) : certificate(whole) + said.verified();
  json.key("verified").value(verified);
  std::string text = fmt::format("{}{} for {}, the busiest has {}, {}\n", sentence(whole),
                                 count_of(facts.loads, "load"), count_of(workers, "worker"),
                                 facts.makespan, over(facts.makespan, makespan_bound));
  text += facts.groups == facts.items ? std::string()
                                      : fmt::format("items in {} groups, room for {} groups\n",
                                                    facts.groups, facts.group_room);
  text += fmt::format("{}{}: {}\nbound: {}\nverified: {}\n", spare ? spare_places[*spare] : "",
                      whole.method, whole.explanation, makespan_bound.reason, verified);
  std::vector<std::uint64_t> loads;
  for (const WorkerFacts& worker : facts.workers) {
    text += fmt::format("worker {}: {} in {}\n", loads.size(), count_of(worker.loads, "load"),
                        count_of(worker.steps, "step"));
    loads.push_back(worker.loads);
  }
  list_loads(json, loads);
  StepWriter writer = said.writer(out, true);
  writer.begin(json.end_object().take(), text + (spare ? overlapping_step : ""));
  said.write(writer, spare ? std::nullopt : to_follow(whole));
}

}  // namespace

void show_loads(const WorkerSplit& split, const LoadsShown& how, OutputFile& out) {
  show_split(split, split.facts().room, {}, how, out);
}

void show_loads(const PrefetchSplit& plan, std::uint64_t room, const LoadsShown& how,
                OutputFile& out) {
  show_split(plan.order, room, plan.spare, how, out);
}

void show_loads(const PrefetchPlan& plan, std::uint64_t room, const LoadsShown& how,
                OutputFile& out) {
  LoadOrderFacts facts = plan.order.facts();
  facts.room = room;
  ScheduleRules rules = rules_of(facts);
  rules.overlap = true;
  Said said([&plan] { return plan.order.stream(); }, rules, how);
  if (facts.every_step_read || how.write_back) {
    said.check(facts.loads);
  }
  const std::uint64_t steps = facts.steps + (how.write_back ? 1 : 0);
  const LoadBound bound = bound_for(facts);
  JsonWriter json = head_of(facts, bound, steps);
  const std::string stores = said.stores(json, bound);
  const std::string verified = said.overlap(json, facts, plan.order.facts().room);
  StepWriter writer = said.writer(out, false);
  writer.begin(json.key("verified").value(verified).end_object().take(),
               fmt::format("{}{} in {}, lower bound {}\n{}{}{}: {}\nverified: {}\n{}",
                           sentence(facts), count_of(facts.loads, "load"), count_of(steps, "step"),
                           bound.loads, spare_places[plan.spare], stores, facts.method,
                           facts.explanation, verified, overlapping_step));
  said.write(writer);
}

void show_loads(const DisjointOrder& order, const LoadsShown& how, OutputFile& out) {
  const DisjointFacts& facts = order.facts();
  Said said([&order] { return order.stream(); }, order.rules(), how);
  said.check(facts.loads);
  const bool anew = how.new_pairs || how.write_back;
  if (anew && said.checked().span != facts.span) {
    throw InternalError("the order of the workers takes longer than was promised");
  }
  const std::string verified =
      anew ? fmt::format("every step read: no item held twice at once, {} computed, each once{}",
                         count_of(said.checked().computed, "pair"), said.no_change_lost())
           : facts.certificate;
  LoadOrderFacts whole;
  whole.items = facts.items;
  whole.room = facts.room;
  whole.loads = facts.loads;
  whole.method = facts.method;
  whole.explanation = facts.explanation;
  const std::uint64_t steps = facts.steps + (how.write_back ? 1 : 0);
  JsonWriter json = head_of(whole, facts.bound, steps);
  json.key("workers").value(facts.workers).key("makespan").value(facts.makespan);
  json.key("span").value(facts.span);
  json.key("makespan_bound").value(facts.makespan_bound.loads);
  json.key("makespan_bound_reason").value(facts.makespan_bound.reason);
  const std::string stores = said.stores(json, facts.bound);
  json.key("disjoint").value(true).key("verified").value(verified);
  list_loads(json, facts.worker_loads);
  StepWriter writer = said.writer(out, true);
  writer.begin(json.end_object().take(),
               fmt::format("{}, {} with room for {}, no item at two of them: {} in {}, {}\n"
                           "the busiest worker has {}; the slowest of each step add up to {}, {}\n"
                           "{}{}: {}\nbound: {}\nbound of the busiest: {}\nverified: {}\n"
                           "each step: all {}evict, wait for each other, load, compute\n",
                           count_of(facts.items, "item"), count_of(facts.workers, "worker"),
                           facts.room, count_of(facts.loads, "load"), count_of(steps, "step"),
                           over(facts.loads, facts.bound), count_of(facts.makespan, "load"),
                           facts.span, over(facts.span, facts.makespan_bound), stores, facts.method,
                           facts.explanation, facts.bound.reason, facts.makespan_bound.reason,
                           verified, how.write_back ? "store and " : ""));
  said.write(writer);
}

void show_loads(const TwoLevelOrder& order, const LoadsShown& how, OutputFile& out) {
  const TwoLevelFacts& facts = order.facts();
  Said said([&order] { return order.stream(); }, order.rules(), how);
  std::string verified = facts.certificate;
  if (how.write_back || how.compute.ordered || how.compute.self || how.compute.shuffle) {
    said.check(facts.loads);
    verified = fmt::format(
        "every step read: room at both levels, {} computed on the accelerator, each once{}",
        count_of(said.checked().computed, "pair"), said.no_change_lost());
  }
  const std::uint64_t steps = facts.steps + (how.write_back ? 1 : 0);
  JsonWriter json;
  json.begin_object().key("items").value(facts.items).key("room").value(facts.room);
  json.key("fast_room").value(facts.fast_room).key("loads").value(facts.loads);
  json.key("transfers").value(facts.transfers).key("steps").value(steps);
  json.key("lower_bound").value(facts.load_bound.loads);
  json.key("lower_bound_reason").value(facts.load_bound.reason);
  json.key("transfer_bound").value(facts.transfer_bound.loads);
  json.key("transfer_bound_reason").value(facts.transfer_bound.reason);
  const std::string stores = said.stores(json, facts.load_bound);
  if (how.item_bytes) {
    json.key("item_bytes").value(*how.item_bytes);
    json.key("bytes_loaded").value(checked_multiply(facts.loads, *how.item_bytes));
    json.key("bytes_transferred").value(checked_multiply(facts.transfers, *how.item_bytes));
  }
  if (facts.group_items > 0) {
    json.key("group_items").value(facts.group_items);
  }
  json.key("explanation").value(facts.explanation).key("verified").value(verified).end_object();
  // How often items move to a level, the bytes, the fewest there can be.
  const auto level = [&](std::uint64_t count, const std::string& what, const LoadBound& bound) {
    const std::string bytes =
        how.item_bytes ? fmt::format(" ({} bytes)", checked_multiply(count, *how.item_bytes)) : "";
    return fmt::format("{}{}, {}", count_of(count, what), bytes, over(count, bound));
  };
  StepWriter writer = said.writer(out, false);
  writer.begin(json.take(),
               fmt::format("{}, room for {} in memory and {} of them on the accelerator: {}\n"
                           "from the disk: {}\nto the accelerator: {}\n{}{}\n"
                           "bound of the loads: {}\nbound of the transfers: {}\nverified: {}\n"
                           "each step: fast evict, {}evict, load, fast load, compute\n",
                           count_of(facts.items, "item"), facts.room, facts.fast_room,
                           count_of(steps, "step"), level(facts.loads, "load", facts.load_bound),
                           level(facts.transfers, "transfer", facts.transfer_bound), stores,
                           facts.explanation, facts.load_bound.reason, facts.transfer_bound.reason,
                           verified, how.write_back ? "store, " : ""));
  said.write(writer);
}

}  // namespace changeover::cli
