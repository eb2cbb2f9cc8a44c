// changeover plan: the cheapest run sheet.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/plan/sheet_formats.hpp"
#include "cli/terminal.hpp"
#include "io/scan/place.hpp"
#include "request/inputs.hpp"
#include "request/plan_done.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

constexpr std::uint64_t triples = 3;  // the strength that asks for them

struct PlanRequest {
  std::string parts;
  std::optional<std::uint64_t> items;
  std::optional<std::uint64_t> at_once;
  std::string test_cost;
  std::string change_cost;
  std::string change_costs;
  std::string pairs;
  std::string never;
  std::string slots;
  std::string slot;
  std::string mounted;
  std::string start;
  std::string first;
  std::string priority;
  std::string budget;
  std::string done;
  std::optional<std::uint64_t> done_first;
  std::optional<std::uint64_t> strength;
  std::optional<std::uint64_t> benches;
  std::string objective;
  std::optional<std::uint64_t> steps;
  std::string title;
  std::optional<std::uint64_t> shuffle;
  bool compact = false;
  bool what_if = false;
  bool diagnose = false;
  bool trust_failed = false;
  bool header = false;
  bool no_header = false;
  RunRequest run;
  OutputRequest output;
};

// What is wrong with an option's value is a matter of usage, and the option is named.
template <typename Read>
auto from_option(const std::string& option, Read&& read) {
  try {
    return read();
  } catch (const BadInput& fault) {
    throw UsageError{fmt::format("{}: {}", option, fault.what())};
  } catch (const ImpossibleParameters& fault) {
    throw UsageError{fmt::format("{}: {}", option, fault.what())};
  }
}

std::optional<Amount> amount(const std::string& option, const std::string& text) {
  return text.empty() ? std::nullopt
                      : std::optional(from_option(option, [&] { return parse_amount(text); }));
}

// The job and what is to be said of it.
struct Asked {
  Job job;
  std::vector<std::string> notes;
  DoneAnswer done;
};

// The parts and what they cost.
Asked parts_of(const PlanRequest& request) {
  if (request.parts.empty() == !request.items) {
    throw UsageError{"give either a parts list or --items N"};
  }
  if (!request.at_once) {
    throw UsageError{"give --at-once K, how many parts fit at once"};
  }
  if (*request.at_once < 2) {
    throw UsageError{
        fmt::format("--at-once {}: no pair can meet; give at least 2", *request.at_once)};
  }
  if (request.strength == triples && *request.at_once < triples) {
    throw UsageError{
        fmt::format("--at-once {}: no triple can meet; give at least 3", *request.at_once)};
  }
  const auto test = amount("--test-cost", request.test_cost);
  const auto change = amount("--change-cost", request.change_cost);
  if (!test) {
    throw UsageError{"give --test-cost X, what it costs to run one test"};
  }
  if (request.items) {
    if (!request.slots.empty() || !request.slot.empty()) {
      throw UsageError{
          "--slots and --slot are for a parts list with a column slot, not for --items"};
    }
    if (request.header || request.no_header) {
      throw UsageError{"--header and --no-header are for a parts list, not for --items"};
    }
    if (!change) {
      throw UsageError{"give --change-cost Y, what it costs to mount a part"};
    }
    return from_option("--items", [&] {
      Job job = make_job(*request.items, *request.at_once, *test, *change);
      if (job.parts() < 2) {
        throw BadInput("a pair needs two parts");
      }
      return Asked{std::move(job), {}, {}};
    });
  }
  const auto input = open_list(request.parts);
  PartList list = read_parts(*input, request.header      ? Header::given
                                     : request.no_header ? Header::none
                                                         : Header::guessed);
  Job job = make_job(list.names.size(), *request.at_once, *test, change.value_or(Amount{}));
  for (std::size_t i = 0; i < list.names.size(); ++i) {
    if (list.change_costs[i]) {
      job.change_costs[i] = *list.change_costs[i];
    } else if (!change) {
      throw UsageError{
          fmt::format("{} has no change cost in the list; give --change-cost Y for "
                      "parts without one",
                      list.names[i])};
    }
  }
  if (list.names.size() < 2) {
    throw BadInput(fmt::format("{}: one part is listed; a pair needs two", input->name()));
  }
  job.names = std::move(list.names);
  if (request.slots.empty() && request.slot.empty()) {
    if (!list.slots.empty()) {
      throw UsageError{
          fmt::format("{} has a column slot; give --slots FILE or --slot, as in --slot "
                      "CPU=1,disk=2..4, or rename the column",
                      input->name())};
    }
  } else {
    std::vector<Slot> slots = request.slots.empty()
                                  ? from_option("--slot", [&] { return parse_slots(request.slot); })
                                  : read_slots(*open_list(request.slots));
    set_slots(job, list.slots, std::move(slots));
  }
  Asked asked{std::move(job), {}, {}};
  if (!list.note.empty()) {
    asked.notes.push_back(list.note);
  }
  return asked;
}

// Pairs that the slots keep apart need not meet; this is said.
void leave_out(Asked& asked, const PairSet& apart) {
  Job& job = asked.job;
  if (apart.size() == 0) {
    return;
  }
  if (apart.size() == job.needed.size()) {
    throw BadInput(
        "no two parts can be in one set-up within the slots; let a slot hold more parts, or raise "
        "--at-once");
  }
  constexpr std::uint64_t few = 3;
  std::string examples;
  apart.for_each(few, [&](Element x, Element y) {
    examples += fmt::format("{}{} and {}", examples.empty() ? "" : "; ", job.names[std::min(x, y)],
                            job.names[std::max(x, y)]);
  });
  drop_needed(job, apart);
  asked.notes.push_back(fmt::format("{} cannot meet within the slots and need not: {}{}",
                                    count_of(apart.size(), "pair"), examples,
                                    apart.size() > few ? "; …" : ""));
}

// What pairs are worth; a weight of a pair that need not meet says nothing.
void take_priorities(const PlanRequest& request, Asked& asked) {
  Job& job = asked.job;
  const auto input = open_list(request.priority);
  job.weights = read_priorities(*input, job.names);
  try {
    Amount all;
    job.needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) { all += job.weights(x, y); });
  } catch (const ImpossibleParameters&) {
    throw BadInput(
        fmt::format("{}: the weights together exceed 9.2e12; divide all of them", input->name()));
  }
  std::uint64_t without_need = 0;
  all_pairs_but(job.needed).for_each(~std::uint64_t{0}, [&](Element x, Element y) {
    without_need += job.weights.weighs(x, y) ? 1U : 0U;
  });
  if (without_need > 0) {
    asked.notes.push_back(fmt::format("{}: {} need not meet, and {} not count", input->name(),
                                      count_of(without_need, "pair"),
                                      without_need == 1 ? "its weight does" : "their weights do"));
  }
}

// Three parts that cannot be in one set-up need not; this is said.
void take_triples(Asked& asked) {
  const std::uint64_t apart = need_triples(asked.job);
  if (asked.job.triples.empty()) {
    throw BadInput(asked.job.parts() < triples
                       ? "a triple needs three parts"
                       : "no three parts can be in one set-up, for the slots, forbidden pairs or "
                         "what stays mounted");
  }
  if (apart > 0) {
    asked.notes.push_back(fmt::format(
        "{} cannot meet, for slots, forbidden pairs or what stays mounted, and need not",
        count_of(apart, "triple")));
  }
}

Asked asked_by(const PlanRequest& request) {
  Asked asked = parts_of(request);
  Job& job = asked.job;
  if (!request.change_costs.empty()) {
    job.replace_costs = read_change_costs(*open_list(request.change_costs), job.names);
  }
  if (!request.never.empty()) {
    job.never = read_pairs(*open_list(request.never), job.names);
    job.needed = all_pairs_but(job.never);
    if (request.pairs.empty() && job.needed.size() == 0) {
      throw BadInput(
          fmt::format("{}: no two parts can be in one set-up; leave out a pair", request.never));
    }
  }
  if (!request.pairs.empty()) {
    const auto input = open_list(request.pairs);
    job.needed = read_pairs(*input, job.names);
    if (job.needed.size() == 0) {
      throw BadInput(fmt::format("{}: no pair is listed; write A,B, a pair a line", input->name()));
    }
  }
  const auto parts = [&](const std::string& option, const std::string& text) {
    return text.empty() ? Block{}
                        : from_option(option, [&] { return parse_parts(text, job.names); });
  };
  job.mounted = parts("--mounted", request.mounted);
  job.start = parts("--start", request.start);
  Job any = job;
  any.needed = PairSet(job.parts());
  check(any);  // Without needed pairs: what cannot be at all.
  if (request.strength == triples) {
    take_triples(asked);
  } else if (request.pairs.empty() && !job.slots.empty()) {
    leave_out(asked, cannot_meet(job));
  }
  if (!request.first.empty()) {
    job.first = read_first(*open_list(request.first), job);
  }
  if (!request.priority.empty()) {
    take_priorities(request, asked);
  }
  check(job);
  if (!request.done.empty()) {
    asked.done =
        take_done({.path = request.done,
                   .first = request.done_first,
                   .failed = request.trust_failed ? FailedTests::trusted : FailedTests::again,
                   .for_diagnosis = request.diagnose,
                   .first_tests = request.first},
                  job);
    asked.notes.insert(asked.notes.end(), asked.done.notes.begin(), asked.done.notes.end());
  }
  return asked;
}

// Where no file says anything, the options are wrong.
Asked asked_of(const PlanRequest& request) {
  const auto files = {request.parts, request.change_costs, request.pairs,    request.never,
                      request.slots, request.first,        request.priority, request.done};
  if (std::ranges::any_of(files, [](const std::string& file) { return !file.empty(); })) {
    return asked_by(request);
  }
  try {
    return asked_by(request);
  } catch (const BadInput& fault) {
    throw UsageError{fault.what()};
  }
}

std::string plan_text(const SheetDocument& document, const std::string& format, std::size_t width) {
  return format == "csv"        ? sheet_as_csv(document)
         : format == "xlsx"     ? sheet_as_xlsx(document)
         : format == "json"     ? sheet_as_json(document)
         : format == "markdown" ? sheet_as_markdown(document)
         : format == "html"     ? sheet_as_html(document)
                                : sheet_as_table(document, width);
}

std::string what_if_text(const Job& job, const WhatIf& answer, const std::string& format) {
  return format == "csv"        ? what_if_as_csv(job, answer)
         : format == "json"     ? what_if_as_json(job, answer)
         : format == "markdown" ? what_if_as_markdown(job, answer)
                                : what_if_as_table(job, answer);
}

// Which faults the results leave, and what to test next.
Answer diagnosis(const PlanRequest& request, const Asked& asked) {
  const DoneAnswer& done = asked.done;
  if (done.results.empty()) {
    throw BadInput(
        done.unread == 0
            ? fmt::format("{}: no result says pass or fail; fill in the column result",
                          request.done)
            : fmt::format(
                  "{}: no result says pass or fail; {} is not understood; write pass or fail",
                  done.first_unread.front().place, shown(done.first_unread.front().text)));
  }
  Diagnosis found = diagnose(asked.job, done.results);
  found.unread = done.unread;
  found.first_unread = done.first_unread;
  found.notes = asked.notes;
  return {.output = request.output,
          .write = [asked, found, json = request.output.json()](OutputFile& out) {
            out.write(json ? diagnosis_as_json(asked.job, found)
                           : diagnosis_as_table(asked.job, found, terminal_width(out)));
          }};
}

// The tests on several benches.
Answer on_benches(const PlanRequest& request, const Asked& asked, const PlanOptions& options,
                  const std::shared_ptr<Running>& running) {
  BenchOptions benches{.benches = *request.benches, .plan = options};
  benches.objective = request.objective == "cost" ? BenchObjective::cost : BenchObjective::makespan;
  const BenchPlan plan = make_bench_plan(asked.job, benches, running->control());
  const auto write = [asked, plan, benches, title = request.title,
                      format = request.output.format()](OutputFile& out) {
    BenchDocument document{.job = &asked.job, .plan = &plan, .objective = benches.objective};
    document.notes = asked.notes;
    document.title = title.empty() ? document.title : title;
    out.write(format == "csv"        ? benches_as_csv(document)
              : format == "xlsx"     ? benches_as_xlsx(document)
              : format == "json"     ? benches_as_json(document)
              : format == "markdown" ? benches_as_markdown(document)
              : format == "html"     ? benches_as_html(document)
                                     : benches_as_table(document, terminal_width(out)));
  };
  Answer answer{.output = request.output, .write = write};
  running->finish();
  if (plan.shortage) {
    answer.fault = std::make_exception_ptr(
        MissingResource("the plan may not be the best that could be found: " + *plan.shortage));
  }
  return spoken(running, std::move(answer));
}

Answer run(const PlanRequest& request) {
  const OutputRequest& output = request.output;
  if (request.diagnose) {
    output.require("--diagnose", {"table", "json"});
  }
  if (request.what_if) {
    output.require("--what-if", {"table", "csv", "json", "markdown"});
  }
  if (request.compact) {
    output.require("--compact", {"table", "html"});
  }
  if (!request.title.empty()) {
    output.require("--title", {"table", "json", "markdown", "html", "xlsx"});
  }
  if (const auto defect = text_defect(request.title)) {
    throw UsageError{"--title: " + *defect};
  }
  check_inputs(output, {{"the parts list", list_file(request.parts)},
                        {"--change-costs", list_file(request.change_costs)},
                        {"--pairs", list_file(request.pairs)},
                        {"--never", list_file(request.never)},
                        {"--slots", list_file(request.slots)},
                        {"--first", list_file(request.first)},
                        {"--priority", list_file(request.priority)},
                        {"--done", list_file(request.done)}});
  PlanOptions options;
  options.budget = amount("--budget", request.budget);
  // A time that was asked for is used; otherwise as many moves as suit, so that answers repeat.
  options.until_stopped = !request.run.time.empty() && !request.steps && !request.what_if;
  const Asked asked = asked_of(request);
  const Job& job = asked.job;
  options.steps = request.steps.value_or(0);
  options.rest = asked.done.rest;
  options.checked = true;  // by asked_of()
  if (request.diagnose) {
    return diagnosis(request, asked);
  }
  // Ctrl-C ends the program at once while it reads, and from here on asks for the best so far.
  const auto running = std::make_shared<Running>(request.run, output);
  if (request.benches) {
    return on_benches(request, asked, options, running);
  }
  RunPlan plan = make_run_plan(job, options, running->control());
  std::vector<std::string> notes = asked.notes;
  if (request.shuffle) {
    std::uint64_t exchanged = 0;
    plan = shuffled(job, std::move(plan), *request.shuffle, exchanged);
    notes.push_back(
        fmt::format("shuffled with seed {}: {} stand where others stood that nothing tells apart",
                    *request.shuffle, count_of(exchanged, "part")));
  }
  std::optional<std::string> shortage = plan.shortage;
  Answer answer;
  if (request.what_if) {
    WhatIf ranges = what_if(job, plan, options, running->control());
    shortage = ranges.shortage;
    ranges.notes = notes;
    answer = text_answer(what_if_text(job, ranges, output.format()), output);
  } else {
    const auto write = [asked, notes, plan, options, title = request.title,
                        compact = request.compact, format = output.format()](OutputFile& out) {
      SheetDocument document{.job = &asked.job, .plan = &plan, .budget = options.budget};
      document.notes = notes;
      document.compact = compact;
      document.title = title.empty() ? document.title : title;
      out.write(plan_text(document, format, terminal_width(out)));
    };
    answer = {.output = output, .write = write};
  }
  running->finish();
  if (shortage) {
    answer.fault = std::make_exception_ptr(
        MissingResource("the plan may not be the best that could be found: " + *shortage));
  }
  return spoken(running, std::move(answer));
}

}  // namespace

void add_plan(Program& program) {
  auto [verb, request] =
      program.add("plan", "the cheapest order of tests: a run sheet, from your costs", run);
  verb.positional("PARTS", request.parts,
                  "CSV or .xlsx: a part a line, with its change cost or not", false);
  verb.flag("--header", request.header, "the first row of the parts list heads its columns");
  verb.flag("--no-header", request.no_header, "the first row of the parts list is a part");
  verb.option("--items", request.items, "N", "N parts called 1, …, N instead of a list");
  verb.option("-k,--at-once", request.at_once, "K", "how many parts fit at once");
  verb.option("--test-cost", request.test_cost, "X", "what one test costs, e.g. 12.50");
  verb.option("--change-cost", request.change_cost, "Y",
              "what mounting a part costs where the list does not say");
  verb.option(
      "--change-costs", request.change_costs, "FILE",
      "a square table: what putting in the part of the column costs where that of the row was taken out");
  verb.option("--strength", request.strength, "T",
              "2: every two parts must meet (the default); 3: every three");
  verb.option("--pairs", request.pairs, "FILE", "pairs that must meet (default: all)");
  verb.option("--never", request.never, "FILE", "pairs that must not be in one set-up");
  verb.option("--slots", request.slots, "FILE",
              "how many parts of each slot a set-up has: slot,least,most a line");
  verb.option("--slot", request.slot, "NAME=N,…",
              "the same in one line, as in CPU=1,disk=2..4,fan=..2");
  verb.option("--mounted", request.mounted, "A,B", "parts that stay mounted in every set-up");
  verb.option("--start", request.start, "A,B,…", "parts that are mounted before the first test");
  verb.option("--first", request.first, "FILE",
              "the set-ups that must be run first, in this order: the parts of one a line");
  verb.option("--priority", request.priority, "FILE",
              "what pairs are worth, A,B,weight a line; others are worth 1");
  verb.option("--budget", request.budget, "Z", "test as many pairs as this pays for");
  verb.option("--done", request.done, "FILE",
              "tests already done, a set-up a line or a run sheet (CSV, .xlsx): plan the rest");
  verb.option("--done-first", request.done_first, "N", "only the first N of them were done");
  verb.flag(
      "--trust-failed", request.trust_failed,
      "pairs that met only in tests that did not pass count as tested, and are not needed again");
  verb.option("--benches", request.benches, "N",
              "on N benches side by side, each with parts of its own");
  verb.choice("--objective", request.objective, {"makespan", "cost"},
              "of several benches: the least largest cost (default), or the least cost together");
  verb.flag("--what-if", request.what_if,
            "which plan is cheapest at which ratio of change to test cost");
  verb.flag("--compact", request.compact, "without the whole set-ups, in two columns on paper");
  verb.option("--shuffle", request.shuffle, "SEED",
              "exchange parts at random that nothing tells apart");
  verb.flag("--diagnose", request.diagnose,
            "which part or pair the results of --done blame, and what to test next");
  verb.option("--title", request.title, "TEXT", "the heading of the run sheet");
  verb.option("--steps", request.steps, "N", "moves of each local search (default: as suits)");
  request.run.add_to(verb, "60s", request.output);
  request.output.add_to(verb, {"table", "csv", "json", "markdown", "html", "xlsx"});
  verb.exclude({"--header", "--no-header"});
  verb.exclude({"--slots", "--slot"});
  verb.only_with({"--objective"}, {"--benches"});
  verb.never_with({"--budget", "--start", "--first", "--done", "--priority", "--what-if",
                   "--shuffle", "--compact"},
                  {"--benches"});
  verb.never_with({"--priority", "--shuffle", "--what-if", "--diagnose"}, {"--change-costs"});
  verb.only_with({"--done-first", "--diagnose", "--trust-failed"}, {"--done"});
  verb.never_with({"--what-if", "--budget", "--title", "--steps", "--compact", "--shuffle",
                   "--first", "--priority", "--trust-failed"},
                  {"--diagnose"});
  verb.never_with({"--compact", "--shuffle"}, {"--what-if"});
  verb.never_with({"--title", "--budget", "--priority"}, {"--what-if"});
  verb.never_with({"--priority"}, {"--shuffle"});
  verb.require([&asked = request] {
    if (asked.benches && (*asked.benches < 1 || *asked.benches > max_benches)) {
      throw UsageError{
          fmt::format("--benches {}: give a number from 1 to {}", *asked.benches, max_benches)};
    }
    if (asked.strength.value_or(2) != 2 && asked.strength != triples) {
      throw UsageError{
          fmt::format("--strength {}: give 2, for pairs, or 3, for triples", *asked.strength)};
    }
    const std::vector<std::pair<std::string, bool>> of_pairs{
        {"--pairs", !asked.pairs.empty()},
        {"--priority", !asked.priority.empty()},
        {"--shuffle", asked.shuffle.has_value()},
        {"--what-if", asked.what_if},
        {"--diagnose", asked.diagnose}};
    for (const auto& [option, given] : of_pairs) {
      if (asked.strength == triples && given) {
        throw UsageError{option + " is of pairs; it has no meaning with --strength 3"};
      }
    }
  });
  verb.examples(
      {"changeover plan --items 9 --at-once 3 --test-cost 1 --change-cost 5",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 -o sheet.html",
       "changeover plan parts.xlsx:Costs -k 5 --test-cost 12.50 -o run.xlsx",
       "changeover plan server.csv -k 8 --test-cost 5 --slot CPU=1,PSU=1,disk=2..4",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --budget 600 --start 1,2,3",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --done sheet.csv --done-first 7",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --done sheet.csv --diagnose",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --benches 2",
       "changeover plan --items 12 -k 5 --test-cost 1 --change-cost 1 --strength 3",
       "changeover plan --items 20 -k 5 --test-cost 1 --change-cost 1 --what-if"});
}

}  // namespace changeover::cli
