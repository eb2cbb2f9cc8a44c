// The tests of a job on several benches side by side: which tests on which bench, and in which order on each.
//
//     Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));
//     RunControl control({.threads = 1});
//     BenchPlan plan = make_bench_plan(job, {.benches = 2}, control);
//     to_string(plan.largest);               // what the bench costs that costs most: "63"
//     plan.sheets[0].steps.size();           // tests on the first bench
//
// Every bench begins empty and can have every part: it has parts of its own, or they are carried over at no cost. What stays
// mounted stays so on every bench; slots and forbidden pairs hold on each. A pair has met if it was on some bench in one
// set-up. Costs add up on a bench; with costs in hours, the largest is when all is done (the *makespan*).
//
// Bounds. Put the lists of all benches end to end: this is one list that does the job and costs no more than they do together, since what
// stays mounted from one list to the next need not be put in again. So all benches together cost at least cost_bound() [docs/theorems.md,
// Theorem 5, says so of the changes of machines' lists put end to end], and the least total is that of one bench. If costs depend on
// what is replaced, this holds at the least price of each part, and so does the bound, but several benches may cost less together than
// one. The
// bench that costs most costs at least the N-th part of that; at least what a test of the dearest needed pair costs; and at
// least the smallest amount for which N benches can test all pairs, if each tests the most pairs that a list within this amount can.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// What is to be least: what all benches cost together, and the largest among equals; or the other way round.
enum class BenchObjective { makespan, cost };

struct BenchOptions {
  std::uint64_t benches = 2;
  BenchObjective objective = BenchObjective::makespan;
  PlanOptions plan = {};  ///< of the searches; neither budget nor rest
};

/// The most benches.
inline constexpr std::uint64_t max_benches = 64;

/// Lists, one a bench, and how they came about.
struct BenchCandidate {
  std::string name;
  std::string how;
  std::vector<std::vector<Block>> lists;
  std::uint64_t tests = 0;
  std::uint64_t changes = 0;
  Amount cost;     ///< of all benches
  Amount largest;  ///< of the bench that costs most
};

/// The lists as run sheets: the referee, which shares nothing with what made them. A pair is new where it first meets if
/// all of bench 1 comes before bench 2, and so on.
struct BenchCount {
  std::vector<RunSheet> sheets;
  std::uint64_t tests = 0;
  std::uint64_t changes = 0;
  Amount cost;
  Amount largest;
  std::uint64_t pairs_needed = 0;
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_needed = 0;
  std::uint64_t triples_tested = 0;
  std::vector<std::string> faults;  ///< broken constraints, a line each

  [[nodiscard]] bool does_the_job() const {
    return faults.empty() && pairs_tested == pairs_needed && triples_tested == triples_needed;
  }
};

/// Counts everything, for a job without a start, first set-ups and tests done. @throws as run_sheet().
[[nodiscard]] BenchCount count_benches(const Job& job,
                                       const std::vector<std::vector<Block>>& lists);

struct BenchPlan : BenchCount {
  std::vector<BenchCandidate> candidates;  ///< the best first: it is the plan
  CostBound bound;                         ///< of all benches together
  Amount largest_bound;                    ///< of the bench that costs most
  std::string largest_reason;              ///< in one line
  std::uint64_t steps = 0;                 ///< moves of local search
  std::optional<std::string> shortage;     ///< as in RunPlan
};

/// The best plan that was found for these benches; there always is one. The plan for one bench is cut into lists of about equal
/// cost, these are shortened, and a local search moves set-ups and parts on all benches and between them.
/// @throws BadInput for no bench or more than max_benches, for a job with a start, first set-ups, tests done or weights, and as make_run_plan().
[[nodiscard]] BenchPlan make_bench_plan(const CheckedJob& job, const BenchOptions& options,
                                        RunControl& control);
[[nodiscard]] BenchPlan make_bench_plan(const Job& job, const BenchOptions& options,
                                        RunControl& control);

/// What sheet_formats.hpp writes of one list, for all benches: a table a bench; CSV with a column bench; JSON, format
/// "changeover-benches/1": title, benches, objective, cost, makespan, tests, changes, pairs_needed, pairs_tested, triples_needed,
/// triples_tested, lower_bound {cost, makespan, cost_reason, makespan_reason}, cost_unit, places,
/// sheets [{bench, tests, changes, cost, steps [{step, take_out, put_in, set_up, places, new_pairs
/// (their number), cost, cost_so_far}]}], candidates [{name, how, tests, changes, cost,
/// makespan}], notes; in each step replaced [[out, in]] if costs depend on what is replaced.
struct BenchDocument {
  const Job* job = nullptr;
  const BenchPlan* plan = nullptr;
  BenchObjective objective = BenchObjective::makespan;
  std::string title = "Run sheets";
  std::vector<std::string> notes = {};
};

/// As written() of sheet_formats.hpp. A page has each bench on a sheet of paper of its own; a workbook a sheet per bench, `Bench 1`,
/// `Bench 2`, …, as that of one list, then `Plan` and `Parts`. read_setups() and read_done() (plan/job.hpp) read the sheet of a
/// bench back.
[[nodiscard]] std::string written(const BenchDocument& document, std::string_view format,
                                  std::size_t width = 80);

}  // namespace changeover
