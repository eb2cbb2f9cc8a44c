// The tests of a job on several benches side by side: which tests on which bench, in which order on
// each, and when.
//
//     Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));
//     RunControl control({.threads = 1});
//     BenchPlan plan = make_bench_plan(job, {.benches = 2}, control);
//     to_string(plan.makespan);              // when the last test ends: "63"
//     plan.sheets[0].steps.size();           // tests on the first bench
//
// A pair has met if it was on some bench in one set-up. Every bench obeys the job, or what it says
// itself (Bench): what stays mounted, slots, room, costs; forbidden pairs hold on each. What is
// mounted on a bench at its start need not be put in there.
//
// Time. A step of a bench, its changes and then its test, takes as long as it costs, with costs in
// hours that many hours, and steps of a bench do not overlap. A bench *holds* a part from the
// beginning of the step that puts it in to the end of the last test with it before it is taken out,
// also while the bench waits in between; a part that is mounted at the start and stays in the first
// set-up, from the beginning. A bench that waits may give up a part that stays, after the last test
// before: it then holds it from the next step on again, which puts it in again and pays for it. At
// no time may more benches hold a part than there are of it (Job::quantities); a bench that has a
// part of its own is not counted. The *makespan* is the end of the last test.
//
// Days. A bench with so many hours a day begins a step only if it ends on the same day; a step of
// more hours begins in the morning and goes on for as many days as it takes. All benches begin a
// day together, and time counts hours of work: a day has as many as the bench that works longest,
// the others rest at its end. A bench without hours, or with 24, never rests; the day has 24 then.
//
// Bounds. Put the lists of all benches end to end: this is one list that does the job. If no bench
// has anything mounted at its start it costs no more than they do together, since what stays
// mounted from one list to the next need not be put in again. So all benches together cost at least
// cost_bound(). src/plan/search/benches/bench_bounds.hpp has the better bounds, and those of the
// makespan, each with its proof.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// A bench; what it does not say is as the job says.
struct Bench {
  std::string name = {};                         ///< empty: "Bench 1" and so on
  std::optional<std::uint64_t> at_once = {};     ///< how many parts fit
  std::optional<Amount> test_cost = {};          ///< of running one test there
  Amount change_factor = {1'000'000};            ///< by which all change costs are multiplied there
  std::vector<Slot> slots = {};                  ///< limits of some of the job's slots, by name
  std::optional<Block> mounted = {};             ///< parts that are in every set-up there
  std::optional<Block> start = {};               ///< parts that are mounted before its first test
  std::optional<std::vector<Block>> first = {};  ///< set-ups that must be run first there
  Block own = {};  ///< parts of which the bench has one of its own, besides those that are shared
  Block without = {};  ///< parts that cannot be mounted there
  std::optional<Amount> hours =
      {};                        ///< of work a day; costs are hours, or what Job::cost_unit says
  bool down = false;             ///< it is out of order: no test is planned for it
  std::uint64_t tests_done = 0;  ///< tests before its first; only for numbering
  std::vector<Block> rest = {};  ///< of its plan that is under way
  std::vector<MountedPlace> places = {};  ///< those that are known, with what is in them

  bool operator==(const Bench&) const = default;
};

/// What a bench is called: its name, or "Bench 3" for the third.
[[nodiscard]] std::string name_of(const std::vector<Bench>& benches, std::size_t bench);

/// An hour in the unit of the costs of a job: 60 where these are minutes, 1 where nothing is said.
[[nodiscard]] std::uint64_t costs_of_hour(const Job& job);

/// What is to be least: the makespan, and what all benches cost together among equals; or the other
/// way round.
enum class BenchObjective { makespan, cost };

struct BenchOptions {
  std::uint64_t benches = 2;
  BenchObjective objective = BenchObjective::makespan;
  PlanOptions plan = {};  ///< of the searches; a budget is of all benches together; without a rest
  std::vector<Bench> each = {};  ///< the benches, if they are not so many that are alike
};

/// The most benches.
inline constexpr std::uint64_t max_benches = 64;

/// A test of a bench, and when.
struct BenchStep {
  Block setup;
  Amount begin;  ///< of the changes before the test
  Block again =
      {};  ///< parts of the set-up before that were given up meanwhile and are put in again
};

/// By bench, in their order.
using BenchSchedule = std::vector<std::vector<BenchStep>>;

/// From when to when.
struct StepTime {
  Amount begin;
  Amount end;
};

/// Lists, one a bench, and how they came about.
struct BenchCandidate {
  std::string name;
  std::string how;
  std::vector<std::vector<Block>> lists;
  std::uint64_t tests = 0;
  std::uint64_t changes = 0;
  Amount cost;      ///< of all benches
  Amount makespan;  ///< when the last test ends
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_tested = 0;
  Amount weight = {};  ///< of the pairs tested, if the job weighs them
};

/// The lists as run sheets: the referee, which shares nothing with what made them. A pair is new
/// where it first meets if all of bench 1 comes before bench 2, and so on.
struct BenchCount {
  std::vector<Bench> benches;  ///< what was counted
  BenchSchedule schedule;
  std::vector<RunSheet>
      sheets;  ///< a part that was given up is taken out and put in by the step that has it again
  std::vector<std::vector<StepTime>> times;  ///< by bench and step
  std::uint64_t tests = 0;
  std::uint64_t changes = 0;
  Amount cost;  ///< of all benches
  /// when the last test ends; where no bench waits or rests, the largest cost of one
  Amount makespan;
  std::uint64_t pairs_needed = 0;
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_needed = 0;
  std::uint64_t triples_tested = 0;
  Amount weight_needed;  ///< of all needed pairs, if the job weighs them
  Amount weight_tested;
  std::vector<std::string> faults;  ///< broken constraints, a line each

  [[nodiscard]] bool does_the_job() const {
    return faults.empty() && pairs_tested == pairs_needed && triples_tested == triples_needed;
  }
};

/// Counts everything and holds it against the definitions above. @throws as run_sheet(); BadInput
/// if there are not as many lists as benches.
[[nodiscard]] BenchCount count_benches(const Job& job, const std::vector<Bench>& benches,
                                       const BenchSchedule& schedule);

/// Of benches that are alike, have every part, begin empty and never wait.
[[nodiscard]] BenchCount count_benches(const Job& job,
                                       const std::vector<std::vector<Block>>& lists);

/// Why no benches like these can do the job, or why they are malformed, a line each, at most ten;
/// none if they can. Complete as defects(Job) is.
[[nodiscard]] std::vector<std::string> bench_defects(const Job& job,
                                                     const std::vector<Bench>& benches);

/// The needed pairs that no set-up of any bench can hold, for what slots, room and benches allow,
/// as cannot_meet(Job).
[[nodiscard]] PairSet cannot_meet(const Job& job, const std::vector<Bench>& benches);

struct BenchPlan : BenchCount {
  std::vector<BenchCandidate> candidates;  ///< the best first: it is the plan
  std::optional<BenchCandidate> complete;  ///< under a budget: the cheapest plan that tests all
  CostBound bound;                         ///< of all benches together, testing everything
  Amount makespan_bound;                   ///< of the makespan, testing everything
  std::string makespan_reason;             ///< in one line
  std::optional<Amount>
      most_weight;  ///< under a budget, if the job weighs pairs: no lists within it test more
  std::uint64_t steps = 0;              ///< moves of local search
  std::optional<std::string> shortage;  ///< as in RunPlan
};

/// The best plan that was found for these benches; there always is one. The plan for one bench is
/// cut into lists of about equal cost, these are shortened, and a local search moves set-ups and
/// parts on all benches and between them; the rest of plans under way is a candidate. Under a
/// budget: the plan that tests the most weight within it.
/// @throws BadInput for no bench or more than max_benches, for bench_defects(), for a job that
/// weighs pairs without a budget, and as make_run_plan().
[[nodiscard]] BenchPlan make_bench_plan(const CheckedJob& job, const BenchOptions& options,
                                        RunControl& control);
[[nodiscard]] BenchPlan make_bench_plan(const Job& job, const BenchOptions& options,
                                        RunControl& control);

/// What sheet_formats.hpp writes of one list, for all benches: one table per bench; CSV with a
/// column bench; JSON, format "changeover-benches/1": title, benches, objective, cost, makespan,
/// tests, changes, pairs_needed, pairs_tested, triples_needed, triples_tested, lower_bound {cost,
/// makespan, cost_reason, makespan_reason}, cost_unit, places, sheets [{bench, tests, changes,
/// cost, steps [{step, take_out, put_in, set_up, places, new_pairs (their number), cost,
/// cost_so_far, begin, end}]}], candidates [{name, how, tests, changes, cost, makespan}], notes; in
/// each step replaced [[out, in]] if costs depend on what is replaced.
struct BenchDocument {
  const Job* job = nullptr;
  const BenchPlan* plan = nullptr;
  BenchObjective objective = BenchObjective::makespan;
  std::string title = "Run sheets";
  std::vector<std::string> notes = {};
  std::optional<Amount> budget = {};
  std::string first_day = {};  ///< of the first tests, as 2025-03-31; empty: days have numbers only
  bool weekends = false;       ///< Saturdays and Sundays are worked on, too
};

/// As written() of sheet_formats.hpp. A page has each bench on a sheet of paper of its own; a
/// workbook a sheet per bench, `Bench 1`, `Bench 2`, …, as that of one list, then `Plan` and
/// `Parts`. read_setups() and read_done() (plan/job.hpp) read the sheet of a bench back.
[[nodiscard]] std::string written(const BenchDocument& document, std::string_view format,
                                  std::size_t width = 80);

}  // namespace changeover
