// Finds a run sheet for a job that is as cheap as possible, shows what it was compared with, and
// bounds how much cheaper any run sheet can be.
//
//     RunControl control({.time = std::chrono::seconds(10)});
//     RunPlan plan =
//         make_run_plan(make_job(9, 3, parse_amount("1"), parse_amount("5")), {}, control);
//     plan.sheet.cost;  plan.bound.cost;             // e.g. 117 and 117
//     for (const Candidate& c : plan.candidates) {   // cheapest first: the first one is the sheet
//       std::cout << c.name << ": " << to_string(c.cost) << '\n';
//     }
//
// Candidates, the cheapest of which is the plan:
//   designs   single-, double- and m-change designs over the parts with needed pairs, known ones or
//             those that local search (search/local_search.hpp) finds, relabelled so that expensive
//             parts stand where introductions are rare
//   greedy    a list that takes the best next step again and again
//   covering  a covering with few set-ups, in a cheap order
//   search    a local search over lists with any number of changes per step, in rounds that start
//             from the best candidate or from nothing; without a time limit they end when a round
//             finds nothing better or the gap to the bound is below one percent
//   rest      the rest of the current plan, if there is one, with missing steps added and needless
//             ones removed; so no new plan costs more than continuing
//
// With a budget: the plan that tests the most needed pairs within it, at least as many as the
// longest affordable part of the cheapest complete plan.
//
// If the job weighs its pairs, the plan for a budget tests the most weight. A list for all pairs is
// then ordered, by its set-ups and by parts that are interchangeable, so that heavy pairs meet
// early at no extra cost.
//
// A small job, of at most 12 parts and 64 pairs, is also searched exhaustively: its cheapest list
// is found or proved, unless that takes more than PlanOptions::states states.
//
// Contract. Every candidate is counted by run_sheet() and breaks no constraint. All candidates but
// those for a budget do the job. A candidate that is an m-change covering design is verified as
// such. Without a time limit the result depends only on the job, the options and the seed, not on
// the number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

// A list of set-ups as a run sheet: what to take out and put in at each step, what the step tests,
// and what it costs.
//
//     RunSheet sheet = run_sheet(job, setups);
//     sheet.does_the_job();  // all needed pairs, no forbidden one, room for all
//     sheet.steps[3].put_in;  to_string(sheet.cost);
//
// This is the check of all plans: it reads the job and the set-ups, counts in the plainest way, and
// shares no code with the planner. Contract: broken constraints are listed in `faults`, never
// thrown, except for an element that is no part.

struct RunStep {
  Block take_out;  ///< increasing, like all lists of parts here
  Block put_in;
  Block setup;
  std::vector<std::pair<Element, Element>> new_pairs;  ///< needed pairs that meet here first
  std::vector<Triple> new_triples;                     ///< likewise
  /// If costs depend on what is replaced: pairs of a part taken out and the part in its place,
  /// sorted by the first. Parts put in that are in no pair went to empty places.
  std::vector<std::pair<Element, Element>> replaced;
  Amount cost;  ///< of this step
  Amount cost_so_far;
  Amount weight_so_far;  ///< of needed pairs that have met so far, if the job weighs them
};

struct RunSheet {
  std::vector<RunStep> steps;
  std::uint64_t changes = 0;  ///< introductions
  Amount change_cost;         ///< of all introductions
  Amount cost;                ///< of the whole list
  std::uint64_t pairs_needed = 0;
  std::uint64_t pairs_tested = 0;  ///< of the needed pairs
  std::uint64_t triples_needed = 0;
  std::uint64_t triples_tested = 0;
  Amount weight_needed;  ///< of all needed pairs, if the job weighs them
  Amount weight_tested;
  /// Broken constraints, including slots and set-ups that must come first; not missing pairs.
  std::vector<std::string> faults;

  [[nodiscard]] bool does_the_job() const {
    return faults.empty() && pairs_tested == pairs_needed && triples_tested == triples_needed;
  }
  /// The number of introductions per step after the first, if it is always the same, there is such
  /// a step, and all set-ups are full: the list is then an m-change list.
  [[nodiscard]] std::optional<std::uint64_t> constant_change() const;
};

/// Counts everything. @throws BadInput if an element is not below job.parts(); ImpossibleParameters
/// if the cost overflows. O(v² + introductions · room), and the time for assigning the parts put in
/// to those taken out, if costs depend on what is replaced.
[[nodiscard]] RunSheet run_sheet(const Job& job, const std::vector<Block>& setups);

// A lower bound on the cost of a job, with its reason.
//
//     CostBound bound = cost_bound(make_job(9, 3, parse_amount("10"), parse_amount("1")));
//     to_string(bound.cost);                    // "145": 12 tests and 25 changes
//
// The proof is docs/theorems.md, Theorem 23. It combines: how many pairs a step can cover; the
// tests that a part needs (for all pairs, the bound of Schönheim [Schonheim1964]); the blocks of a
// linear single-change design; and the prices of introductions, limited by the degrees of the parts
// and by their stays [docs/theorems.md, Theorem 5]. Where costs depend on what is replaced, that of
// Theorem 20 counts, if it is better.

struct CostBound {
  Amount cost;
  std::uint64_t tests = 0;          ///< lower bound on the tests of a list
  std::uint64_t introductions = 0;  ///< lower bound on the introductions of a list
  std::string reason;               ///< one line with its numbers
};

/// A lower bound on the cost of any list of set-ups that does the job. If the scope of this thread
/// (run/control.hpp) requests a stop, the bound uses (2), (3) and (5) of the theorem only, which
/// take little time. @throws BadInput as check(); ImpossibleParameters if a cost overflows. O(P·K).
[[nodiscard]] CostBound cost_bound(const Job& job);

/// A list of set-ups, and how it was made.
struct Candidate {
  std::string name;  ///< "double-change design", "local search", …
  std::string how;   ///< one line
  std::vector<Block> setups;
  std::uint64_t changes = 0;
  Amount change_cost = {};
  Amount cost = {};
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_tested = 0;
  Amount weight = {};  ///< of the tested pairs, if the job weighs pairs

  /// Copies the changes, the costs, the numbers of tested pairs and triples, and the weight from
  /// this run sheet.
  void take_figures(const RunSheet& sheet);
  [[nodiscard]] std::uint64_t tests() const { return setups.size(); }
};

/// What a plan minimises.
enum class PlanObjective {
  cost,  ///< what it costs
  tests  ///< tests, and then the cost; for jobs of a model only
};

/// A plan that is better than all before it, reported during the search.
struct PlanNews {
  std::string name;  ///< how it was made
  std::uint64_t tests = 0;
  Amount cost = {};   ///< cost; for benches that minimise the makespan, the end of the last test
  Amount bound = {};  ///< lower bound for any plan
};

struct PlanOptions {
  PlanObjective objective = PlanObjective::cost;
  std::uint64_t steps = 0;     ///< of each local search, in one round; 0: chosen for the job
  unsigned attempts = 4;       ///< most local searches per round, each with its own random numbers
  bool until_stopped = false;  ///< continue with longer searches until the control stops them
  std::optional<Amount> budget = {};
  std::vector<Block> rest =
      {};  ///< remaining set-ups of the current plan; continuing it is a candidate
  std::uint64_t design_moves = 2'000'000;  ///< moves of the search for better designs; 0: no search
  std::uint64_t states = 400'000;  ///< limit for the exhaustive search of a small job; 0: no search
  /// Called on the caller's thread for each better plan that tests everything, before any budget.
  std::function<void(const PlanNews&)> on_better = {};
};

struct RunPlan {
  RunSheet sheet;  ///< of the first candidate
  std::vector<Candidate>
      candidates;  ///< cheapest first; with a budget, most weight or most pairs first
  std::optional<Candidate> complete;  ///< with a budget: the cheapest plan that tests everything
  /// On the cost of testing all needed pairs: cost_bound(), or better after an exhaustive search.
  CostBound bound;
  std::optional<Amount>
      most_weight;          ///< with a budget and weights: no list within the budget tests more
  std::uint64_t steps = 0;  ///< moves of local search in all attempts
  /// `found`: nothing better is possible. `time_limit`: a clock stopped the search or a part of it.
  WhyStopped why_stopped = WhyStopped::running;
  PlanObjective objective = PlanObjective::cost;  ///< the order of the candidates
  /// If the search ended early because memory, threads or another resource ran out: what was
  /// missing, in one line. The plan is then the best one found before.
  std::optional<std::string> shortage;

  /// The sheet does the job at the cost of the bound, so no list is cheaper.
  [[nodiscard]] bool proved_cheapest() const {
    return sheet.does_the_job() && sheet.cost == bound.cost;
  }
  /// The sheet does the job with the number of tests of the bound, so no list has fewer.
  [[nodiscard]] bool proved_fewest() const {
    return sheet.does_the_job() && sheet.steps.size() == bound.tests;
  }
};

/// Returns the best plan found. There always is one: also if the control requests a stop at once,
/// within about a second for a thousand parts. Checking a plain Job is not limited by the control;
/// to limit it, make a CheckedJob in a scope of your own (run/control.hpp). @throws BadInput as
/// check(Job); ImpossibleParameters if costs overflow; MissingResource if a plan needs more memory
/// than the control allows; InternalError if a candidate fails its check. Time: attempts · steps
/// moves of local search, each O(stretch · at_once), and the search for designs.
[[nodiscard]] RunPlan make_run_plan(const CheckedJob& job, const PlanOptions& options,
                                    RunControl& control);
[[nodiscard]] RunPlan make_run_plan(const Job& job, const PlanOptions& options,
                                    RunControl& control);

/// Returns the same plan with its parts exchanged at random among those that are interchangeable:
/// equal in cost, slot, pairs, mounted, and start. The result depends only on the seed; the cost
/// stays, and the sheet is counted again. `exchanged` is set to the number of parts that changed.
/// @throws as run_sheet(). O(v³/64).
[[nodiscard]] RunPlan shuffled(const Job& job, RunPlan plan, std::uint64_t seed,
                               std::uint64_t& exchanged);

// Break-even analysis: which plan is cheapest as changes cost more or less, relative to tests.
//
//     WhatIf answer = what_if(job, plan, {}, control);
//     for (const WhatIf::Range& range : answer.ranges) {   // by ratio, without gaps
//       std::cout << range.plan.name << (range.to ? " up to " + range.to->to_string() : "")
//                 << '\n';
//     }
//
// A plan with T tests and C changes costs T + rC, in units of the test cost, where r is the ratio
// of the change cost to the test cost: a line in r. The cheapest plans are the lower envelope of
// the lines of all candidates. If parts have different change costs, r is a factor that multiplies
// all of them, and C is the cost of all changes in units of the test cost.
//
// The search of make_run_plan() is run again at every break-even ratio, and far out on both sides.
// A cheaper list joins the candidates. This ends when no list is cheaper or the control requests a
// stop.

/// A non-negative ratio, not reduced.
struct Ratio {
  std::uint64_t over = 0;
  std::uint64_t under = 1;

  /// Decimal text with four digits: "0.625", "12.5".
  [[nodiscard]] std::string to_string() const;
};

struct WhatIf {
  struct Range {
    std::optional<Ratio> from;  ///< nullopt: from 0
    std::optional<Ratio> to;    ///< nullopt: without end
    Candidate plan;             ///< cheapest in the range; at its ends, as cheap as the neighbour's
  };
  bool by_factor = false;  ///< change costs differ: ratios are factors of all change costs
  std::vector<Range> ranges;
  WhyStopped why_stopped = WhyStopped::running;  ///< as in RunPlan
  std::optional<Ratio> asked;  ///< the ratio of the job itself; nullopt if its tests cost nothing
  std::optional<std::string> shortage;  ///< as in RunPlan
  std::vector<std::string> notes;  ///< remarks on the job, one per line; what_if() leaves it empty
};

/// The envelope of some candidates, without any search. O(n log n).
/// @throws ImpossibleParameters if costs overflow.
[[nodiscard]] WhatIf envelope(const Job& job, const std::vector<Candidate>& candidates);

/// The envelope of the candidates of a plan and of the lists found at its break-even ratios.
/// @throws as make_run_plan(), which is what it costs for each ratio.
[[nodiscard]] WhatIf what_if(const Job& job, const RunPlan& plan, const PlanOptions& options,
                             RunControl& control);

// A run sheet for people and for programs.
//
//     SheetDocument document{.job = &job, .plan = &plan, .title = "Pump bench"};
//     written(document, "table", 100);    // for a terminal of 100 columns
//     written(document, "html");  // one page to print, with boxes to tick; needs nothing else
//
// All formats say for each step what to take out and put in, the set-up, the number of needed pairs
// that it tests first, and the cost so far. All but CSV also have the candidates, and the lower
// bound with its reason. All costs of a document have the same number of decimals. Names are
// escaped as each format requires.
//
// CSV: one row per step, LF line ends; read_setups() (plan/job.hpp) reads it back:
//
//     step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far,result
//     2,Valve 2,"""Motor, small""",Pump A,"Motor, small",1,6,13,
//
// Every place of the bench has a column; with slots, the places of a slot are adjacent and named
// `slot_1 CPU`. A part that stays keeps its place. Parts that are mounted at the start keep theirs
// where Job::places gives it, and these places keep their numbers. If costs are times, a column
// `clock` has the time of day. The columns of parts taken out and put in are lists for people; the
// column `result` is to be filled in. No cell is a formula in a spreadsheet: a text that would be
// one begins with an apostrophe, which read_setups() removes. Numbers stay
// numbers.
//
// Workbook (.xlsx): the sheet `Run sheet` has the columns of the CSV and one for notes, to print
// and fill in. `Plan` has the costs, the bound and the candidates. `Parts`, `Slots` and `Never` can
// be read as lists. `Done` has the earlier tests. The request (job_request.hpp) is on a hidden
// sheet, so the workbook alone is enough to continue. Names are stored as text, whatever they look
// like, and so are costs of more than 15 digits; other numbers are stored as numbers. read_setups()
// and read_done() read the workbook back.
//
// JSON, one object: format "changeover-plan/1", title, parts [{name, change_cost, slot (or null;
// with slots only)}], at_once, slots [{name, least, most}], test_cost, mounted, start, first
// [[part]], tests_done, met_only_in_failed, trust_failed, tests, changes, cost, pairs_needed,
// pairs_tested, proved_cheapest, why_stopped, lower_bound {cost, tests, changes, reason}, budget
// (or null), triples_needed, triples_tested, weight {needed, tested, most (or null)} (or null),
// cost_unit (or null), places [{number, slot (or null)}], steps [{step, take_out, put_in, set_up,
// places [part or null, in the order of places], new_pairs [[a,b]], cost, cost_so_far,
// weight_so_far (where pairs are weighed)}], candidates [{name, how, tests, changes, cost,
// pairs_tested, triples_tested, weight}], notes [text]. If costs depend on what is replaced, also
// replace_costs [[number, or null where a part meets itself or one of another slot]] by part out
// and part in, and in each step replaced [[out, in]]. For a model also parameters [{name, values
// [{value, part, names, out_of_range}]}], rules (how many), objective, proved_fewest_tests, and in
// each step values
// {parameter: value}. Costs are exact decimals.
//
// For a model all formats say for each step what to set, and the value of each parameter. CSV and
// workbooks have a column for each parameter, headed by its name, or by `slot_3 cost` where another
// column has that name. A value with several names uses the next one each time it is set.
// read_value_costs() reads the workbook's sheet `Costs`.

/// What is written; the job and the plan must outlive it.
struct SheetDocument {
  const Job* job = nullptr;
  const RunPlan* plan = nullptr;
  std::optional<Amount> budget = {};
  std::string title = "Run sheet";
  bool compact =
      false;  ///< pages and tables without the whole set-up: only what is put in and taken out
  std::vector<std::string> notes = {};  ///< remarks on the job, one per line
  const DoneRecord* done = nullptr;     ///< earlier tests, for a workbook
  std::vector<std::string> question =
      {};  ///< the request as a document, in pieces, for a workbook; its head is first
};

/// Writes the document as "table" for a terminal (lists are broken between parts to fit into
/// `width`), "csv", "json" (one line), "markdown" (tables in the style of GitHub), "html" (a page
/// without scripts, pictures or external resources) or "xlsx" (the bytes of a workbook), as
/// described above. The same document always gives the same bytes. @throws BadOption for another
/// format; MissingResource if there is no space for the temporary files of a workbook.
[[nodiscard]] std::string written(const SheetDocument& document, std::string_view format,
                                  std::size_t width = 80);

/// Writes the ranges of ratios with the cheapest plan of each, and the ratio of the job, as
/// "table", "csv", "json" or "markdown". The job must be the one that was analysed. @throws
/// BadOption for another format.
[[nodiscard]] std::string written(const Job& job, const WhatIf& answer, std::string_view format);

}  // namespace changeover
