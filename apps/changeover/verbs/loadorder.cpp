// changeover loadorder: loads and evictions after which every pair of items has been in memory together.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/output.hpp"
#include "changeover/loadorder/load_check.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/prefetch.hpp"
#include "changeover/loadorder/workers.hpp"
#include "io/write/json_writer.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct LoadOrderRequest {
  std::optional<std::uint64_t> items;
  std::optional<std::uint64_t> room;
  std::optional<std::uint64_t> workers;
  bool prefetch = false;
  RunRequest run;
  OutputRequest output;
};

/// Writes an order in a format: a head, then a line for each step.
class StepWriter {
 public:
  StepWriter(OutputFile& out, const std::string& format)
      : out_(out), json_(format == "jsonl"), csv_(format == "csv") {}

  /// The head in JSON or in text; in CSV the names of the columns.
  void begin(const std::string& json, const std::string& text, const std::string& columns) {
    out_.write(json_ ? json + "\n" : csv_ ? columns + "\n" : text + "\n");
  }

  /// `worker` is nothing if there is only one.
  void write(const LoadStep& step, std::optional<std::uint64_t> worker = {}) {
    start(step.number, worker);
    list("load", step.load);
    list("evict", step.evict);
    finish();
  }

  void write(const PrefetchStep& step) {
    start(step.number, {});
    list("load", step.load);
    if (json_) {  // the name that every order has
      std::vector<Element> all = step.evict_first;
      all.insert(all.end(), step.evict_late.begin(), step.evict_late.end());
      list("evict", all);
    }
    list("evict_first", step.evict_first);
    list("evict_late", step.evict_late);
    list("before", step.before);
    list("compute", step.overlap);
    finish();
  }

  void end() {
    out_.write(text_);
    text_.clear();
  }

 private:
  void add(std::uint64_t number) { fmt::format_to(std::back_inserter(text_), "{}", number); }

  void add(const ItemPair& pair) {
    text_ += json_ ? "[" : "";
    add(pair.first);
    text_ += json_ ? ',' : '-';
    add(pair.second);
    text_ += json_ ? "]" : "";
  }

  void start(std::uint64_t number, std::optional<std::uint64_t> worker) {
    if (worker) {
      text_ += json_ ? "{\"worker\":" : csv_ ? "" : "worker ";
      add(*worker);
      text_ += json_ ? ",\"step\":" : csv_ ? "," : " step ";
    } else {
      text_ += json_ ? "{\"step\":" : csv_ ? "" : "step ";
    }
    add(number);
    text_ += json_ || csv_ ? "" : ":";
  }

  // In text an empty list is not mentioned.
  template <typename Member>
  void list(std::string name, const std::vector<Member>& members) {
    if (json_) {
      text_ += ",\"" + name + "\":[";
    } else if (csv_) {
      text_ += ',';
    } else if (members.empty()) {
      return;
    } else {
      std::replace(name.begin(), name.end(), '_', ' ');
      text_ += (text_.back() == ':' ? " " : "; ") + name + " ";
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
      text_ += i == 0 ? "" : json_ ? "," : " ";
      add(members[i]);
    }
    text_ += json_ ? "]" : "";
  }

  void finish() {
    constexpr std::size_t piece = 1 << 16;
    text_ += json_ ? "}\n" : "\n";
    if (text_.size() >= piece) {
      end();
    }
  }

  OutputFile& out_;
  bool json_;
  bool csv_;
  std::string text_;
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
  json.key("loads").value(loads).key("steps").value(facts.steps);
  json.key("lower_bound").value(bound.loads).key("lower_bound_reason").value(bound.reason);
  json.key("method").value(facts.method).key("explanation").value(facts.explanation);
  return json;
}

std::string sentence(std::uint64_t items, std::uint64_t room) {
  return fmt::format("{}, room for {}: ", count_of(items, "item"), room);
}

// How to get fewer loads, where that may help.
std::string hint(const LoadOrderRequest& request, const LoadOrderFacts& facts) {
  const bool searched = !request.run.time.empty();
  return facts.gap() == 0 || searched || facts.items > LoadOrderOptions().improve_up_to
             ? std::string()
             : "--time 30s may find an order with fewer\n";
}

void write_one(const LoadOrderRequest& request, const LoadOrder& order, OutputFile& out) {
  const LoadOrderFacts& facts = order.facts();
  Audit audit(facts, facts.loads, request.run.seed.value_or(1));
  JsonWriter json = head_of(facts, facts.bound, facts.items, facts.room, facts.loads);
  json.key("gap").value(facts.gap()).key("verified").value(audit.text()).end_object();
  StepWriter writer(out, request.output.format());
  writer.begin(json.take(),
               fmt::format("{}{} in {}, {}\n{}{}: {}\nbound: {}\nverified: {}\n",
                           sentence(facts.items, facts.room), count_of(facts.loads, "load"),
                           count_of(facts.steps, "step"), over(facts.gap(), facts.bound.loads),
                           hint(request, facts), facts.method, facts.explanation,
                           facts.bound.reason, audit.text()),
               "step,load,evict");
  LoadStep step;
  for (const auto steps = order.stream(); steps->next(step);) {
    audit.read(step);
    writer.write(step);
  }
  audit.finish();
  writer.end();
}

void write_workers(const LoadOrderRequest& request, const WorkerSplit& split, OutputFile& out) {
  const SplitFacts& facts = split.facts();
  const LoadOrderFacts& whole = split.order().facts();
  const double gap =
      static_cast<double>(facts.makespan) / static_cast<double>(facts.makespan_bound.loads) - 1;
  // Groups of items have small orders, which were read.
  Audit audit(whole, facts.loads, request.run.seed.value_or(1));
  JsonWriter json = head_of(whole, load_lower_bound(facts.items, facts.room), facts.items,
                            facts.room, facts.loads);
  json.key("workers").value(facts.workers.size()).key("makespan").value(facts.makespan);
  json.key("makespan_bound").value(facts.makespan_bound.loads);
  json.key("makespan_bound_reason").value(facts.makespan_bound.reason);
  json.key("groups").value(facts.groups).key("verified").value(audit.text());
  json.key("worker_loads").begin_array();
  std::string text =
      fmt::format("{}{} for {}, the busiest has {}, {}\n", sentence(facts.items, facts.room),
                  count_of(facts.loads, "load"), count_of(facts.workers.size(), "worker"),
                  facts.makespan, over(gap, facts.makespan_bound.loads));
  text += facts.groups == facts.items ? std::string()
                                      : fmt::format("items in {} groups, room for {} groups\n",
                                                    facts.groups, facts.group_room);
  text += fmt::format("{}: {}\nbound: {}\nverified: {}\n", whole.method, whole.explanation,
                      facts.makespan_bound.reason, audit.text());
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    json.value(facts.workers[w].loads);
    text += fmt::format("worker {}: {} in {}\n", w, count_of(facts.workers[w].loads, "load"),
                        count_of(facts.workers[w].steps, "step"));
  }
  StepWriter writer(out, request.output.format());
  writer.begin(json.end_array().end_object().take(), text, "worker,step,load,evict");
  LoadStep step;
  for (std::uint64_t w = 0; w < facts.workers.size(); ++w) {
    audit.start_over();
    for (const auto steps = split.stream(w); steps->next(step);) {
      audit.read(step);
      writer.write(step, w);
    }
  }
  audit.finish();
  writer.end();
}

void write_prefetch(const LoadOrderRequest& request, const PrefetchPlan& plan, std::uint64_t room,
                    OutputFile& out) {
  const LoadOrderFacts& facts = plan.order.facts();
  const LoadBound bound = load_lower_bound(facts.items, room);
  JsonWriter json = head_of(facts, bound, facts.items, room, facts.loads);
  json.key("order_room").value(facts.room);
  std::string certificate = facts.certificate;
  PrefetchStep step;
  if (facts.every_step_read) {
    PrefetchCheck check(facts.items, room);
    PrefetchSchedule schedule(plan.order.stream(), facts.items, room);
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
  StepWriter writer(out, request.output.format());
  writer.begin(json.key("verified").value(certificate).end_object().take(),
               fmt::format("{}{} in {}, lower bound {}\n{} is kept for what is loading\n{}: {}\n"
                           "verified: {}\n"
                           "each step: wait for load, compute before; evict first of the next "
                           "step, start its loads; "
                           "compute the others; evict late\n",
                           sentence(facts.items, room), count_of(facts.loads, "load"),
                           count_of(facts.steps, "step"), bound.loads,
                           plan.spare == 0 ? "no place" : "one of the places", facts.method,
                           facts.explanation, certificate),
               "step,load,evict_first,evict_late,before,compute");
  PrefetchSchedule schedule(plan.order.stream(), facts.items, room);
  while (schedule.next(step)) {
    writer.write(step);
  }
  writer.end();
}

Answer run(const LoadOrderRequest& request) {
  if (!request.items || !request.room) {
    throw UsageError{"--items P and --room C are required"};
  }
  const std::uint64_t items = *request.items;
  const std::uint64_t room = *request.room;
  if (items == 0) {
    throw UsageError{"--items 0: give at least 1 item"};
  }
  if (room < 2) {
    throw UsageError{
        fmt::format("--room {}: no two items could meet; give room for at least 2", room)};
  }
  if (request.workers && *request.workers == 0) {
    throw UsageError{"--workers 0: give at least 1 worker"};
  }
  if (request.workers && *request.workers > most_workers) {
    throw UsageError{fmt::format("--workers {}: give 1 to {}", *request.workers, most_workers)};
  }
  LoadOrderOptions options;
  OutputRequest output = request.output;
  output.precious = false;  // Without a search the same command makes it again.
  output.check_writable();
  if (request.run.settings().time->count() > 0) {
    options.improve = [&](const Design& start, std::uint64_t blocks) {
      output.precious = true;
      Running running(request.run, request.output);  // The time is for the search alone.
      return improve_by_search(running.control())(start, blocks);
    };
  }
  // Made now, so that what cannot be is said before anything is written.
  Answer answer;
  if (request.workers) {
    const auto split = std::make_shared<const WorkerSplit>(
        split_load_order(items, room, *request.workers, options));
    answer.write = [request, split](OutputFile& out) { write_workers(request, *split, out); };
  } else if (request.prefetch) {
    const auto plan = std::make_shared<const PrefetchPlan>(plan_prefetch(items, room, options));
    answer.write = [=](OutputFile& out) { write_prefetch(request, *plan, room, out); };
  } else {
    const auto order = std::make_shared<const LoadOrder>(plan_load_order(items, room, options));
    answer.write = [request, order](OutputFile& out) { write_one(request, *order, out); };
  }
  answer.output = output;
  return answer;
}

}  // namespace

void add_loadorder(Program& program) {
  auto [verb, request] =
      program.add("loadorder", "an order of loads that brings all pairs of items together", run);
  verb.option("--items", request.items, "P", "items, e.g. partitions of a file");
  verb.option("--room", request.room, "C", "how many are in memory at once");
  verb.option("--workers", request.workers, "W", "split it for W workers with room C each");
  verb.flag("--prefetch", request.prefetch,
            "say what is computed when, so that loads overlap computation");
  request.run.add_to(verb, "0s", request.output);
  request.output.add_to(verb, {"text", "jsonl", "csv"});
  verb.exclude({"--workers", "--prefetch"});
  verb.only_with({"--threads", "--memory"}, {"--time"});
  verb.examples({"changeover loadorder --items 64 --room 16",
                 "changeover loadorder --items 20 --room 5 --time 20s      search for fewer loads",
                 "changeover loadorder --items 1000 --room 100 --json -o order.jsonl",
                 "changeover loadorder --items 1000 --room 100 --workers 8",
                 "changeover loadorder --items 64 --room 16 --prefetch"});
}

}  // namespace changeover::cli
