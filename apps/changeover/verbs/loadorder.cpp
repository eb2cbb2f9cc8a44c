// changeover loadorder: loads and evictions after which every pair of items has been in memory together.
#include <fmt/format.h>

#include "answer/loads/show_lockstep.hpp"
#include "answer/loads/show_two_levels.hpp"
#include "answer/loads/step_writer.hpp"
#include "answer/loads/stored_steps.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/output.hpp"
#include "changeover/loadorder/disjoint.hpp"
#include "changeover/loadorder/load_check.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/prefetch.hpp"
#include "changeover/loadorder/step_work.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/loadorder/write_back.hpp"
#include "changeover/run/scope.hpp"
#include "io/write/json_writer.hpp"
#include "request/inputs.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct LoadOrderRequest {
  std::optional<std::uint64_t> items;
  std::optional<std::uint64_t> room;
  std::optional<std::uint64_t> against;
  std::optional<std::uint64_t> done_items;
  std::string pairs;
  std::optional<std::uint64_t> fast_room;
  std::optional<std::uint64_t> item_bytes;
  std::optional<std::uint64_t> workers;
  bool disjoint = false;
  bool write_back = false;
  bool prefetch = false;
  bool new_pairs = false;
  bool ordered = false;
  bool self = false;
  bool shuffle = false;
  RunRequest run;
  OutputRequest output;
};

std::string over(double gap, std::uint64_t bound) {
  return gap == 0 ? "the fewest possible"
                  : fmt::format("{:.2f} % over the lower bound {}", 100 * gap, bound);
}

// Follows what is written when not every step was read before.
class Audit {
 public:
  /// `loads` of all workers together.
  Audit(const LoadOrderFacts& facts, std::uint64_t loads, std::uint64_t seed)
      : facts_(facts), loads_(loads) {
    if (!facts.every_step_read) {
      LoadCheckOptions options;
      options.all_pairs = false;
      options.seed = seed;
      options.wanted = facts.wanted;
      check_.emplace(facts.items, facts.room, options);
    }
  }

  [[nodiscard]] std::string text() const {
    return check_ ? facts_.certificate + "; 64 items are followed while it is written"
                  : facts_.certificate;
  }

  /// The next worker begins.
  void start_over() {
    if (check_) {
      check_->start_over();
    }
  }

  void read(const LoadStep& step) {
    if (check_) {
      check_->read(step);
    }
  }

  // @throws InternalError, before the output appears.
  void finish() const {
    if (!check_) {
      return;
    }
    const LoadVerdict verdict = check_->finish();
    if (!verdict.valid() || verdict.loads != loads_) {
      throw InternalError(
          fmt::format("the load order is wrong: {}{}", verdict.fault, verdict.uncovered_example));
    }
  }

 private:
  const LoadOrderFacts& facts_;
  std::uint64_t loads_;
  std::optional<LoadCheck> check_;
};

JsonWriter head_of(const LoadOrderFacts& facts, const LoadBound& bound, std::uint64_t items,
                   std::uint64_t room, std::uint64_t loads) {
  JsonWriter json;
  json.begin_object().key("items").value(items).key("room").value(room);
  if (!facts.wanted.are_all()) {
    json.key("wanted").value(facts.wanted.describe());
    json.key("wanted_pairs").value(facts.wanted.count());
  }
  json.key("loads").value(loads).key("steps").value(facts.steps);
  json.key("lower_bound").value(bound.loads).key("lower_bound_reason").value(bound.reason);
  json.key("method").value(facts.method).key("explanation").value(facts.explanation);
  return json;
}

std::string sentence(const WantedPairs& wanted, std::uint64_t items, std::uint64_t room) {
  return wanted.are_all() ? fmt::format("{}, room for {}: ", count_of(items, "item"), room)
                          : fmt::format("{}, room for {}: ", wanted.describe(), room);
}

const std::vector<std::string>* names_of(const WantedPairs& wanted) {
  return wanted.graph() != nullptr ? &wanted.graph()->names() : nullptr;
}

LoadBound bound_for(const WantedPairs& wanted, std::uint64_t items, std::uint64_t room) {
  return wanted.are_all() ? load_lower_bound(items, room) : load_lower_bound(wanted, room);
}

// How to get fewer loads, where that may help.
std::string hint(const LoadOrderRequest& request, const LoadOrderFacts& facts) {
  const bool searched = !request.run.time.empty();
  if (facts.gap() > 0 && !searched && facts.wanted.graph() != nullptr) {
    return "--time 30s may find an order with fewer\n";
  }
  return facts.gap() == 0 || searched || !facts.wanted.are_all() ||
                 facts.items > LoadOrderOptions().improve_up_to
             ? std::string()
             : "--time 30s may find an order with fewer\n";
}

StepWorkOptions work_options(const LoadOrderRequest& request) {
  StepWorkOptions options{.ordered = request.ordered, .self = request.self};
  if (request.shuffle) {
    options.shuffle = request.run.seed.value_or(1);
  }
  return options;
}

// Streams of steps, one a worker, with what they compute if that is asked for.
class Work {
 public:
  using Streams = std::vector<std::function<std::unique_ptr<StepSource>()>>;

  Work(const LoadOrderRequest& request, const WantedPairs& wanted, std::uint64_t items,
       std::uint64_t room)
      : shown_(request.new_pairs),
        said_(request.new_pairs || request.write_back),
        wanted_(wanted),
        items_(items),
        room_(room) {
    options_ = work_options(request);
  }

  // One line about it for `verified`. @throws InternalError
  [[nodiscard]] std::string verify(const Streams& streams) const {
    if (!said_) {
      return "";
    }
    if (items_ > max_elements_in_memory && wanted_.graph() == nullptr) {
      return "; a pair may be computed more than once";
    }
    WorkCheck check(items_, wanted_, options_);
    each(
        streams, [&](std::uint64_t) { check.start_over(); },
        [&](const WorkStep& step, std::uint64_t) { check.read(step); });
    const WorkVerdict verdict = check.finish();
    if (!verdict.valid()) {
      throw InternalError(
          fmt::format("what the steps compute is wrong: {} missing, {} repeated; {}",
                      verdict.missing, verdict.repeated, verdict.fault));
    }
    return fmt::format("; {} computed, each once", count_of(verdict.computed, "pair"));
  }

  // Calls start(worker), then take(step, worker) for each step of it.
  template <typename Start, typename Take>
  void each(const Streams& streams, Start&& start, Take&& take) const {
    std::optional<StepWork> work;
    if (said_) {
      work.emplace(items_, room_, wanted_, options_);
    }
    WorkStep step;
    for (std::uint64_t w = 0; w < streams.size(); ++w) {
      start(w);
      auto steps = streams[w]();
      if (work) {
        work->start(std::move(steps));
      }
      while (work ? work->next(step) : steps->next(step.loads)) {
        take(step, w);
      }
    }
  }

  [[nodiscard]] const std::vector<ItemPair>* of(const WorkStep& step) const {
    return shown_ ? &step.pairs : nullptr;
  }
  /// Further columns of a table.
  [[nodiscard]] std::string columns() const { return shown_ ? ",new_pairs" : ""; }

 private:
  bool shown_;
  bool said_;
  WantedPairs wanted_;
  std::uint64_t items_;
  std::uint64_t room_;
  StepWorkOptions options_;
};

void write_one(const LoadOrderRequest& request, const LoadOrder& order, OutputFile& out) {
  const LoadOrderFacts& facts = order.facts();
  Audit audit(facts, facts.loads, request.run.seed.value_or(1));
  const Work work(request, facts.wanted, facts.items, facts.room);
  const Work::Streams streams{[&order] { return order.stream(); }};
  const StoredSteps stores(request.write_back, facts, [&](const auto& take) {
    work.each(
        streams, [](std::uint64_t) {}, [&](const WorkStep& step, std::uint64_t) { take(step); });
  });
  const std::string verified = audit.text() + work.verify(streams) + stores.verified();
  LoadOrderFacts said = facts;
  said.steps += request.write_back ? 1 : 0;
  JsonWriter json = head_of(said, facts.bound, facts.items, facts.room, facts.loads);
  stores.add_to(json, request.self);
  json.key("gap").value(facts.gap()).key("verified").value(verified).end_object();
  StepWriter writer(out, request.output.format(), names_of(facts.wanted));
  writer.begin(
      json.take(),
      fmt::format("{}{} in {}, {}\n{}{}{}: {}\nbound: {}\nverified: {}\n",
                  sentence(facts.wanted, facts.items, facts.room), count_of(facts.loads, "load"),
                  count_of(said.steps, "step"), over(facts.gap(), facts.bound.loads),
                  stores.text(request.self), hint(request, facts), facts.method, facts.explanation,
                  facts.bound.reason, verified),
      "step,load,evict" + stores.column() + work.columns());
  stores.each([&](const StoredStep& step) {
    if (step.work.loads.number <= facts.steps) {
      audit.read(step.work.loads);
    }
    writer.write(step.work.loads, {}, work.of(step.work),
                 request.write_back ? &step.store : nullptr);
  });
  audit.finish();
  writer.end();
}

void write_workers(const LoadOrderRequest& request, const WorkerSplit& split, OutputFile& out) {
  const SplitFacts& facts = split.facts();
  LoadOrderFacts whole = split.order().facts();
  whole.explanation = facts.explanation;  // Groups of items have small orders, which were read.
  whole.certificate = facts.certificate;
  const double gap =
      static_cast<double>(facts.makespan) / static_cast<double>(facts.makespan_bound.loads) - 1;
  Audit audit(whole, facts.loads, request.run.seed.value_or(1));
  const Work work(request, whole.wanted, facts.items, facts.room);
  Work::Streams streams;
  for (std::uint64_t w = 0; w < facts.workers.size(); ++w) {
    streams.push_back([&split, w] { return split.stream(w); });
  }
  const std::string verified = audit.text() + work.verify(streams);
  const LoadBound bound = bound_for(whole.wanted, facts.items, facts.room);
  JsonWriter json = head_of(whole, bound, facts.items, facts.room, facts.loads);
  json.key("workers").value(facts.workers.size()).key("makespan").value(facts.makespan);
  json.key("makespan_bound").value(facts.makespan_bound.loads);
  json.key("makespan_bound_reason").value(facts.makespan_bound.reason);
  json.key("groups").value(facts.groups).key("verified").value(verified);
  json.key("worker_loads").begin_array();
  std::string text = fmt::format(
      "{}{} for {}, the busiest has {}, {}\n", sentence(whole.wanted, facts.items, facts.room),
      count_of(facts.loads, "load"), count_of(facts.workers.size(), "worker"), facts.makespan,
      over(gap, facts.makespan_bound.loads));
  text += facts.groups == facts.items ? std::string()
                                      : fmt::format("items in {} groups, room for {} groups\n",
                                                    facts.groups, facts.group_room);
  text += fmt::format("{}: {}\nbound: {}\nverified: {}\n", whole.method, whole.explanation,
                      facts.makespan_bound.reason, verified);
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    json.value(facts.workers[w].loads);
    text += fmt::format("worker {}: {} in {}\n", w, count_of(facts.workers[w].loads, "load"),
                        count_of(facts.workers[w].steps, "step"));
  }
  StepWriter writer(out, request.output.format(), names_of(whole.wanted));
  writer.begin(json.end_array().end_object().take(), text,
               "worker,step,load,evict" + work.columns());
  work.each(
      streams, [&](std::uint64_t) { audit.start_over(); },
      [&](const WorkStep& step, std::uint64_t w) {
        audit.read(step.loads);
        writer.write(step.loads, w, work.of(step));
      });
  audit.finish();
  writer.end();
}

void write_prefetch(const LoadOrderRequest& request, const PrefetchPlan& plan, std::uint64_t room,
                    OutputFile& out) {
  const LoadOrderFacts& facts = plan.order.facts();
  const LoadBound bound = bound_for(facts.wanted, facts.items, room);
  JsonWriter json = head_of(facts, bound, facts.items, room, facts.loads);
  json.key("order_room").value(facts.room);
  std::string certificate = facts.certificate;
  PrefetchStep step;
  if (facts.every_step_read) {
    PrefetchCheck check(facts.items, room, facts.wanted);
    PrefetchSchedule schedule(plan.order.stream(), facts.items, room, facts.wanted);
    while (schedule.next(step)) {
      check.read(step);
    }
    const PrefetchVerdict verdict = check.finish();
    if (!verdict.valid()) {
      throw InternalError("the prefetch schedule is wrong: " + verdict.fault);
    }
    certificate = fmt::format("simulated, all {} pairs computed once, {} of them while items load",
                              verdict.computed, verdict.overlapped);
    json.key("pairs").value(verdict.computed).key("overlapped").value(verdict.overlapped);
  } else {
    certificate += "; a pair may be computed more than once";
  }
  StepWriter writer(out, request.output.format(), names_of(facts.wanted));
  writer.begin(json.key("verified").value(certificate).end_object().take(),
               fmt::format("{}{} in {}, lower bound {}\n{} is kept for what is loading\n{}: {}\n"
                           "verified: {}\n"
                           "each step: wait for load, compute before; evict first of the next "
                           "step, start its loads; "
                           "compute the others; evict late\n",
                           sentence(facts.wanted, facts.items, room), count_of(facts.loads, "load"),
                           count_of(facts.steps, "step"), bound.loads,
                           plan.spare == 0 ? "no place" : "one of the places", facts.method,
                           facts.explanation, certificate),
               "step,load,evict_first,evict_late,before,compute");
  PrefetchSchedule schedule(plan.order.stream(), facts.items, room, facts.wanted);
  while (schedule.next(step)) {
    writer.write(step);
  }
  writer.end();
}

// What the options say, before a file is read.
void check(const LoadOrderRequest& request) {
  const bool listed = !request.pairs.empty();
  if (!request.room || (!listed && !request.items)) {
    throw UsageError{listed ? "--room C is required" : "--items P and --room C are required"};
  }
  if (request.items && *request.items == 0) {
    throw UsageError{"--items 0: give at least 1 item"};
  }
  if (*request.room < 2) {
    throw UsageError{
        fmt::format("--room {}: no two items could meet; give room for at least 2", *request.room)};
  }
  if (*request.room > most_items) {
    throw UsageError{fmt::format("--room {}: give at most {}, the most items that there can be",
                                 *request.room, most_items)};
  }
  if (request.workers && *request.workers == 0) {
    throw UsageError{"--workers 0: give at least 1 worker"};
  }
  if (request.workers && *request.workers > most_workers) {
    throw UsageError{fmt::format("--workers {}: give 1 to {}", *request.workers, most_workers)};
  }
  if (request.against && *request.against == 0) {
    throw UsageError{"--against 0: give at least 1 item"};
  }
  if (request.done_items && *request.done_items >= *request.items) {
    throw UsageError{fmt::format("--done-items {}: of --items {} none would be new",
                                 *request.done_items, *request.items)};
  }
  if (request.disjoint && *request.workers > 1 &&
      *request.items / *request.workers < *request.room) {
    throw UsageError{fmt::format(
        "--disjoint: {} workers with room for {} would hold more than {}; give --room {} or less, or "
        "fewer workers",
        *request.workers, *request.room, count_of(*request.items, "item"),
        *request.items / *request.workers)};
  }
  if ((request.disjoint || request.fast_room) && *request.items > max_elements_in_memory) {
    throw UsageError{fmt::format("{}: at most {} items; make items larger",
                                 request.disjoint ? "--disjoint" : "--fast-room",
                                 max_elements_in_memory)};
  }
  if (request.fast_room && (*request.fast_room < 2 || *request.fast_room > *request.room)) {
    throw UsageError{fmt::format("--fast-room {}: of --room {} give 2 to {}", *request.fast_room,
                                 *request.room, *request.room)};
  }
  if (request.item_bytes && *request.item_bytes == 0) {
    throw UsageError{"--item-bytes 0: give at least 1"};
  }
  const std::uint64_t most = most_items;
  if (request.items.value_or(0) > most || request.against.value_or(0) > most) {
    throw UsageError{fmt::format("--items and --against are at most {}", most)};
  }
  if (request.against && *request.items + *request.against > most) {
    throw UsageError{fmt::format("--items {} and --against {} are {} items together; at most {}",
                                 *request.items, *request.against,
                                 *request.items + *request.against, most)};
  }
}

WantedPairs wanted_by(const LoadOrderRequest& request) {
  if (!request.pairs.empty()) {
    return WantedPairs::listed(read_pairs(request.pairs, {.items = request.items}));
  }
  if (request.against) {
    return WantedPairs::between(*request.items, *request.against);
  }
  if (request.done_items) {
    return WantedPairs::beyond(*request.done_items, *request.items);
  }
  return {};
}

// When memory is full for the first time, all pairs in it are new.
void require_memory_for_a_step(const LoadOrderRequest& request, const WantedPairs& wanted,
                               std::uint64_t items, std::uint64_t room) {
  const std::uint64_t there = std::min(room, items);
  std::uint64_t pairs = there * (there - 1) / 2;
  if (!wanted.are_all()) {
    pairs = std::min(pairs, wanted.count());
  }
  const std::uint64_t copies = request.ordered ? 3 : 2;  // as they are found, and as they are said
  require_memory(pairs * copies * sizeof(ItemPair),
                 fmt::format("a step of --new-pairs with --room {}", room));
}

Answer run(const LoadOrderRequest& request) {
  check(request);
  const WantedPairs wanted = wanted_by(request);
  const std::uint64_t items = wanted.are_all() ? *request.items : wanted.items();
  const std::uint64_t room = *request.room;
  if (request.new_pairs) {
    require_memory_for_a_step(request, wanted, items, room);
  }
  LoadOrderOptions options;
  options.seed = request.run.seed.value_or(1);
  OutputRequest output = request.output;
  output.precious = false;  // Without a search the same command makes it again.
  output.check_writable();
  if (request.run.settings().time->count() > 0) {
    options.improve = [&](const Design& start, std::uint64_t blocks) {
      output.precious = true;
      Running running(request.run, request.output);  // The time is for the search alone.
      return improve_by_search(running.control())(start, blocks);
    };
    options.search_pairs = [&](const std::function<void()>& search) {
      output.precious = true;
      const Running running(request.run, request.output);
      search();
    };
  }
  // Made now, so that what cannot be is said before anything is written.
  Answer answer;
  if (request.disjoint) {
    const auto order = std::make_shared<const DisjointOrder>(
        plan_disjoint_order(items, room, *request.workers, options));
    answer.write = [request, order](OutputFile& out) {
      show_lockstep(*order,
                    {.format = request.output.format(),
                     .work = work_options(request),
                     .new_pairs = request.new_pairs,
                     .write_back = request.write_back},
                    out);
    };
  } else if (request.fast_room) {
    const auto order =
        std::make_shared<const TwoLevelOrder>(plan_two_levels(items, room, *request.fast_room));
    answer.write = [request, order](OutputFile& out) {
      show_two_levels(*order, request.output.format(), request.item_bytes, request.new_pairs, out);
    };
  } else if (request.workers) {
    const auto split = std::make_shared<const WorkerSplit>(
        wanted.are_all() ? split_load_order(items, room, *request.workers, options)
                         : split_load_order(wanted, room, *request.workers, options));
    answer.write = [request, split](OutputFile& out) { write_workers(request, *split, out); };
  } else if (request.prefetch) {
    const auto plan = std::make_shared<const PrefetchPlan>(
        wanted.are_all() ? plan_prefetch(items, room, options)
                         : plan_prefetch(wanted, room, options));
    answer.write = [=](OutputFile& out) { write_prefetch(request, *plan, room, out); };
  } else {
    const auto order = std::make_shared<const LoadOrder>(
        wanted.are_all() ? plan_load_order(items, room, options)
                         : plan_load_order(wanted, room, options));
    answer.write = [request, order](OutputFile& out) { write_one(request, *order, out); };
  }
  answer.output = output;
  return answer;
}

}  // namespace

void add_loadorder(Program& program) {
  auto [verb, request] = program.add<LoadOrderRequest>(
      "loadorder", "an order of loads that brings all pairs of items together", run);
  verb.option("--items", request.items, "P", "items, e.g. partitions of a file");
  verb.option("--room", request.room, "C", "how many are in memory at once");
  verb.option(
      "--pairs", request.pairs, "FILE",
      "only the pairs listed there, two items per line (text, CSV, .xlsx); \"-\": standard input");
  verb.option("--against", request.against, "B", "each of the P items with each of B others");
  verb.option("--done-items", request.done_items, "N", "the pairs of the first N items are done");
  verb.option("--fast-room", request.fast_room, "C",
              "so many of those in memory are on an accelerator, where pairs meet");
  verb.option("--item-bytes", request.item_bytes, "N",
              "bytes an item, to say what both levels move");
  verb.option("--workers", request.workers, "W", "split it for W workers with room C each");
  verb.flag("--disjoint", request.disjoint,
            "workers step together and never hold one item twice, so that items may change");
  verb.flag("--write-back", request.write_back,
            "items change while they are held: say what is stored when");
  verb.flag("--prefetch", request.prefetch,
            "say what is computed when, so that loads overlap computation");
  verb.flag("--new-pairs", request.new_pairs, "say of each step which pairs are computed");
  verb.flag("--ordered", request.ordered, "pairs both ways: (i,j) and (j,i)");
  verb.flag("--self", request.self, "each item with itself, too: (i,i)");
  verb.flag("--shuffle", request.shuffle, "pairs of a step in random order, by --seed");
  request.run.add_to(verb, "0s", request.output);
  request.output.add_to(verb, {"text", "jsonl", "csv"});
  verb.exclude({"--workers", "--prefetch"});
  verb.exclude({"--new-pairs", "--prefetch"});
  verb.only_with({"--disjoint"}, {"--workers"});
  verb.exclude({"--write-back", "--prefetch"});
  verb.never_with({"--fast-room"},
                  {"--workers", "--prefetch", "--write-back", "--pairs", "--against",
                   "--done-items", "--ordered", "--self", "--shuffle", "--time"});
  verb.only_with({"--item-bytes"}, {"--fast-room"});
  verb.require([&request = request] {
    if (request.write_back && request.workers && !request.disjoint) {
      throw UsageError{
          "--write-back --workers: two workers would change one item at once; add --disjoint"};
    }
  });
  verb.never_with({"--disjoint"}, {"--pairs", "--against", "--done-items"});
  verb.only_with({"--ordered", "--self", "--shuffle"}, {"--new-pairs", "--write-back"});
  verb.exclude({"--pairs", "--against", "--done-items"});
  verb.never_with({"--time"}, {"--against", "--done-items"});
  verb.require([&request = request] {
    check_inputs(request.output, {{"the list of pairs", list_file(request.pairs)}});
  });
  verb.only_with({"--threads", "--memory"}, {"--time"});
  verb.examples({"changeover loadorder --items 64 --room 16",
                 "changeover loadorder --items 20 --room 5 --time 20s      search for fewer loads",
                 "changeover loadorder --items 1000 --room 100 --json -o order.jsonl",
                 "changeover loadorder --items 1000 --room 100 --workers 8",
                 "changeover loadorder --items 64 --room 8 --workers 2 --disjoint   for training",
                 "changeover loadorder --items 200 --room 40 --fast-room 8      two levels",
                 "changeover loadorder --items 64 --room 16 --prefetch",
                 "changeover loadorder --pairs edges.txt --room 10       only some pairs",
                 "changeover loadorder --items 12 --against 20 --room 4  two sets",
                 "changeover loadorder --items 1024 --done-items 1000 --room 64"});
}

}  // namespace changeover::cli
