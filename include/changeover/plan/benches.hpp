// Plans for several benches side by side: which tests run on which bench, in which order, and when.
//
//     Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));
//     RunControl control({.threads = 1});
//     BenchPlan plan = make_bench_plan(job, {.benches = 2}, control);
//     to_string(plan.makespan);              // when the last test ends: "63"
//     plan.sheets[0].steps.size();           // tests on the first bench
//
// Two parts have met if they were in one set-up on some bench. Every bench obeys the job, except
// where it has its own values (Bench): what stays mounted, slots, room, costs. Forbidden pairs hold
// on every bench. Parts that are mounted on a bench at its start need not be put in there.
//
// Time. A step is the changes before a test and the test. It takes as long as it costs (an hour per
// unit, if costs are hours), and the steps of a bench do not overlap. A bench *holds* a part from
// the beginning of the step that puts it in to the end of the last test before it is taken out,
// also while the bench waits in between. It holds a part that is mounted at the start, and stays in
// the first set-up, from the beginning. A bench that waits may give up a part that stays, after the
// last test before the wait: it then holds the part again from the next step on, which puts it in
// again and pays for it. At no time may more benches hold a part than there are pieces of it
// (Job::quantities); a bench with its own piece is not counted. The *makespan* is the end of the
// last test.
//
// Days. A bench with limited hours per day begins a step only if the step ends on the same day. A
// longer step begins in the morning and continues for as many days as it takes. All benches begin a
// day together. Time counts working hours: a day has the hours of the bench that works longest, and
// the others rest at its end. A bench without hours, or with 24, never rests; the day then has 24
// hours.
//
// Bounds. The lists of all benches, end to end, are one list that does the job. If no bench has
// anything mounted at its start, this list costs at most their sum, since parts that stay mounted
// from one list to the next need not be put in again. So all benches together cost at least
// cost_bound(). The bounds that plans show, of the cost and of the makespan, are better (internal,
// with proofs: src/plan/search/benches/bench_bounds.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"
#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// A bench; members that are not set take the value of the job.
struct Bench {
  std::string name = {};                      ///< empty: "Bench 1" and so on
  std::optional<std::uint64_t> at_once = {};  ///< number of parts that fit
  std::optional<Amount> test_cost = {};       ///< of running one test on this bench
  Amount change_factor = {1'000'000};  ///< all change costs are multiplied by it on this bench
  std::vector<Slot> slots =
      {};  ///< limits that differ from those of the job's slots of the same name
  std::optional<Block> mounted = {};             ///< parts in every set-up of this bench
  std::optional<Block> start = {};               ///< parts that are mounted before the first test
  std::optional<std::vector<Block>> first = {};  ///< set-ups that must run first on this bench
  Block own = {};      ///< parts of which the bench has its own piece, besides the shared ones
  Block without = {};  ///< parts that cannot be mounted on this bench
  std::optional<Amount> hours = {};  ///< working hours per day; costs are hours, or Job::cost_unit
  bool down = false;                 ///< out of order: no test is planned for it
  std::uint64_t tests_done = 0;      ///< number of earlier tests; only for numbering
  std::uint64_t last_step = 0;       ///< highest number of an earlier test, if they have numbers
  std::vector<Block> rest = {};      ///< remaining set-ups of its current plan
  std::vector<MountedPlace> places = {};  ///< known places, with the parts in them

  /// The number that the last earlier test has; new tests go on after it.
  [[nodiscard]] std::uint64_t steps_before() const {
    return tests_done < last_step ? last_step : tests_done;
  }
  bool operator==(const Bench&) const = default;
};

/// The name of a bench, or "Bench 3" for the third if it has none.
[[nodiscard]] std::string name_of(const std::vector<Bench>& benches, std::size_t bench);

/// The cost of one hour: 60 if costs are minutes, 1 if no unit is given.
[[nodiscard]] std::uint64_t costs_of_hour(const Job& job);

/// What comes first in the order of plans.
enum class BenchObjective {
  makespan,  ///< the makespan, then the total cost
  cost,      ///< the total cost, then the makespan
  tests      ///< the tests of all benches together, then the makespan; for jobs of a model only
};

/// "makespan", "cost" or "tests".
[[nodiscard]] const char* to_string(BenchObjective objective);

struct BenchOptions {
  std::uint64_t benches = 2;
  BenchObjective objective = BenchObjective::makespan;
  PlanOptions plan =
      {};  ///< options of the searches; a budget is for all benches together; without a rest
  std::vector<Bench> each =
      {};  ///< the benches, if they differ; otherwise `benches` says how many there are
};

/// The limit for the number of benches.
inline constexpr std::uint64_t max_benches = 64;

/// A test on a bench, with its time.
struct BenchStep {
  Block setup;
  Amount begin;  ///< of the changes before the test
  Block again =
      {};  ///< parts of the set-up before that were given up during a wait and are put in again
};

/// The steps of each bench, in its order.
using BenchSchedule = std::vector<std::vector<BenchStep>>;

/// Begin and end of a step.
struct StepTime {
  Amount begin;
  Amount end;
};

/// The lists of all benches, and how they were made.
struct BenchCandidate {
  std::string name;
  std::string how;
  std::vector<std::vector<Block>> lists;
  std::uint64_t tests = 0;
  std::uint64_t changes = 0;
  Amount cost;      ///< of all benches together
  Amount makespan;  ///< the end of the last test
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_tested = 0;
  Amount weight = {};  ///< of the tested pairs, if the job weighs pairs
};

/// The lists as run sheets, counted by code that is independent of the planner. A pair is new where
/// it first meets if bench 1 is counted completely before bench 2, and so on.
struct BenchCount {
  std::vector<Bench> benches;  ///< the benches that were counted
  BenchSchedule schedule;
  std::vector<RunSheet>
      sheets;  ///< by bench; a part that is given up is taken out, and put in by a later step
  std::vector<std::vector<StepTime>> times;  ///< by bench and step
  std::uint64_t tests = 0;
  std::uint64_t changes = 0;
  Amount cost;  ///< of all benches together
  /// The end of the last test; if no bench waits or rests, the largest cost of a bench.
  Amount makespan;
  std::uint64_t pairs_needed = 0;
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_needed = 0;
  std::uint64_t triples_tested = 0;
  Amount weight_needed;  ///< of all needed pairs, if the job weighs them
  Amount weight_tested;
  std::vector<std::string> faults;  ///< broken constraints, one per line

  [[nodiscard]] bool does_the_job() const {
    return faults.empty() && pairs_tested == pairs_needed && triples_tested == triples_needed;
  }
};

/// Counts everything and checks it against the definitions above. @throws as run_sheet(); BadInput
/// if the number of lists is not the number of benches.
[[nodiscard]] BenchCount count_benches(const Job& job, const std::vector<Bench>& benches,
                                       const BenchSchedule& schedule);

/// Counts and checks lists of set-ups, one list per bench, for equal benches that have every part,
/// start empty, and never wait.
[[nodiscard]] BenchCount count_benches(const Job& job,
                                       const std::vector<std::vector<Block>>& lists);

/// Reasons why these benches are malformed or cannot do the job, one per line, at most ten; empty
/// if they can. Complete in the same sense as defects(Job).
[[nodiscard]] std::vector<std::string> bench_defects(const Job& job,
                                                     const std::vector<Bench>& benches);

/// The needed pairs that no set-up of any bench can hold, because of slots, room and benches; like
/// cannot_meet(Job).
[[nodiscard]] PairSet cannot_meet(const Job& job, const std::vector<Bench>& benches);

struct BenchPlan : BenchCount {
  std::vector<BenchCandidate> candidates;  ///< best first; the first one is the plan
  std::optional<BenchCandidate>
      complete;                 ///< with a budget: the cheapest plan that tests everything
  CostBound bound;              ///< on the cost of testing everything on all benches together
  Amount makespan_bound;        ///< lower bound on the makespan of testing everything
  std::string makespan_reason;  ///< one line
  std::optional<Amount>
      most_weight;  ///< with a budget and weights: no plan within the budget tests more weight
  std::uint64_t steps = 0;                       ///< moves of local search
  WhyStopped why_stopped = WhyStopped::running;  ///< as in RunPlan
  std::optional<std::string> shortage;           ///< as in RunPlan

  /// All pairs are tested with the number of tests of the bound, so no plan has fewer.
  [[nodiscard]] bool proved_fewest() const { return does_the_job() && tests == bound.tests; }
};

/// Returns the best plan found for these benches; there always is one. The plan for one bench is
/// cut into lists of about equal cost, these are shortened, and a local search moves set-ups and
/// parts within and between benches. The rest of the current plans is a candidate, too. With a
/// budget: the plan that tests the most weight within it. For the fewest tests, the shortest list
/// of one bench is cut, and the search adds no test. @throws BadInput for no bench or more
/// than max_benches, for bench_defects(), for a job that weighs pairs without a budget, and as
/// make_run_plan().
[[nodiscard]] BenchPlan make_bench_plan(const CheckedJob& job, const BenchOptions& options,
                                        RunControl& control);
[[nodiscard]] BenchPlan make_bench_plan(const Job& job, const BenchOptions& options,
                                        RunControl& control);

/// The documents of sheet_formats.hpp for all benches: one table per bench; CSV with a column
/// `bench`; JSON, format "changeover-benches/1": title, benches, objective, cost, makespan, tests,
/// changes, why_stopped, pairs_needed, pairs_tested, triples_needed, triples_tested, lower_bound
/// {cost, tests, makespan, cost_reason, makespan_reason}, of a model proved_fewest_tests,
/// cost_unit, places, sheets [{bench, tests,
/// changes, cost, steps [{step, take_out, put_in, set_up, places, new_pairs (their number), cost,
/// cost_so_far, begin, end}]}], candidates [{name, how, tests, changes, cost, makespan}],
/// handovers [{part, from, to, step, early, after}], of parts of which there are few, notes; in
/// each step replaced [[out, in]] if costs depend on what is replaced. With hours a day a step also
/// has day, hour and date of its begin, and finish {day, hour, date}; an hour is in the unit of
/// costs, counted from the beginning of the day.
struct BenchDocument {
  const Job* job = nullptr;
  const BenchPlan* plan = nullptr;
  BenchObjective objective = BenchObjective::makespan;
  std::string title = "Run sheets";
  std::vector<std::string> notes = {};
  std::optional<Amount> budget = {};
  std::string first_day = {};  ///< of the first tests, as 2025-03-31; empty: days have numbers only
  bool weekends = false;       ///< Saturdays and Sundays are worked on, too
  const DoneRecord* done = nullptr;        ///< as in SheetDocument
  std::vector<std::string> question = {};  ///< as in SheetDocument
  RequestList list = {};                   ///< the benches as they were asked for, for a workbook
};

/// The run sheets of all benches, in the formats of written() (sheet_formats.hpp). A page has each
/// bench on its own sheet of paper. A workbook has a sheet per bench, `Bench 1`, `Bench 2`, …, like
/// that of one list, then `Plan`, `Parts` and the other sheets of such a workbook, and a sheet
/// `Benches`: it is all that is needed to go on. read_setups() and read_done() (plan/job.hpp) read
/// the sheet of a bench back.
[[nodiscard]] std::string written(const BenchDocument& document, std::string_view format,
                                  std::size_t width = 80);

}  // namespace changeover
