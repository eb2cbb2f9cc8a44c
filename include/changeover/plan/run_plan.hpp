// The cheapest run sheet for a job that we can find, what it was compared with, and how far it can
// be from the cheapest there is.
//
//     RunControl control({.time = std::chrono::seconds(10)});
//     RunPlan plan =
//         make_run_plan(make_job(9, 3, parse_amount("1"), parse_amount("5")), {}, control);
//     plan.sheet.cost;  plan.bound.cost;             // e.g. 117 and 117
//     for (const Candidate& c : plan.candidates) {   // cheapest first: the first one is the sheet
//       std::cout << c.name << ": " << to_string(c.cost) << '\n';
//     }
//
// Candidates. Single-, double- and m-change designs over the parts with needed pairs, those that
// are known or that local search (search/local_search.hpp) makes of them, relabelled so that dear
// parts stand where introductions are rare; a list that takes the best next step again and again; a
// covering with few set-ups, in a cheap order; and the result of a local search over lists with any
// number of changes a step, in rounds that start from the best of the others or forget it; without
// a time, they end when a round finds nothing better or the gap to the bound is under one percent.
// If a plan is under way, its rest, with what it lacks and without what it need not; so no new plan
// is dearer than going on. Under a budget: the plan that tests the most needed pairs, at least as
// many as the longest affordable part of the cheapest complete plan does.
//
// If the job weighs its pairs, the plan under a budget tests the most weight, and a list for all
// pairs is put into an order, of set-ups and of parts that nothing else tells apart, in which heavy
// pairs meet early and which costs no more.
//
// A small job, of at most 12 parts and 64 pairs, is then searched through: its cheapest list is
// found or proved, unless more than PlanOptions::states have to be looked at.
//
// Contract. Every candidate is counted by run_sheet() and breaks no constraint; all but those of a
// budget do the job; one that is an m-change covering design is verified as such. Without a time
// limit the result depends on the job, the options and the seed only, not on the number of threads.
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

// A list of set-ups as a run sheet: what to take out and put in at each step, what it tests and
// costs.
//
//     RunSheet sheet = run_sheet(job, setups);
//     sheet.does_the_job();  // all needed pairs, no forbidden one, room for all
//     sheet.steps[3].put_in;  to_string(sheet.cost);
//
// This is the referee of all plans: it reads the job and the set-ups, counts in the plainest way,
// and shares nothing with what made them. Contract: whatever the lists hold, faults are listed in
// `faults` and never thrown, but for an element that is no part.

struct RunStep {
  Block take_out;  ///< increasing, like the others
  Block put_in;
  Block setup;
  std::vector<std::pair<Element, Element>> new_pairs;  ///< needed pairs that meet here first
  std::vector<Triple> new_triples;                     ///< likewise
  /// if the job asks what is replaced: a part out and the one in its place, by the first; parts put
  /// in that are in none went to empty places
  std::vector<std::pair<Element, Element>> replaced;
  Amount cost;  ///< of this step
  Amount cost_so_far;
  Amount weight_so_far;  ///< of needed pairs that have met, if the job weighs them
};

struct RunSheet {
  std::vector<RunStep> steps;
  std::uint64_t changes = 0;  ///< introductions
  Amount change_cost;         ///< of all introductions
  Amount cost;                ///< of everything
  std::uint64_t pairs_needed = 0;
  std::uint64_t pairs_tested = 0;  ///< of the needed ones
  std::uint64_t triples_needed = 0;
  std::uint64_t triples_tested = 0;
  Amount weight_needed;  ///< of all needed pairs, if the job weighs them
  Amount weight_tested;
  /// broken constraints, slots and what must come first included, but not missing pairs
  std::vector<std::string> faults;

  [[nodiscard]] bool does_the_job() const {
    return faults.empty() && pairs_tested == pairs_needed && triples_tested == triples_needed;
  }
  /// The number of introductions of every step after the first, if they agree, there is such a step
  /// and all set-ups are full: the list is then an m-change list.
  [[nodiscard]] std::optional<std::uint64_t> constant_change() const;
};

/// Counts everything. @throws BadInput if an element is not below job.parts(); ImpossibleParameters
/// if the cost overflows. O(v² + introductions · room), and what assigning the parts put in to
/// those taken out takes if the job asks what is replaced.
[[nodiscard]] RunSheet run_sheet(const Job& job, const std::vector<Block>& setups);

// A lower bound on the cost of a job, with its reason.
//
//     CostBound bound = cost_bound(make_job(9, 3, parse_amount("10"), parse_amount("1")));
//     to_string(bound.cost);                    // "145": 12 tests and 25 changes
//
// Proof. Let F be the parts that do not stay mounted, f the number of those that do, K = at_once −
// f the room for F, capped by the number of colours that colour the graph of pairs of F that may
// meet (a set-up is a clique of it), P the number of needed pairs within F, d_x the number of
// needed pairs at x, S the parts of F that are mounted at the start. Consider a cheapest list of T
// set-ups, and of these one with the fewest introductions; let it introduce parts of F I times,
// part x i_x times.
//  (1) *Pairs.* A step that introduces j parts newly covers at most p(j) = C(j,2) + j(K − j) pairs,
//      and the first one at most C(j,2) + j·s + min(C(s,2), needed pairs within S), s = min(|S|, K
//      − j). p is concave, so I introductions in T steps cover the most if the steps after the
//      first are as equal as can be. This gives I ≥ I(T), the fewest introductions by which T steps
//      can cover P.
//  (2) *Tests.* Part x meets at most K − 1 parts a test, so it is in at least ⌈d_x / (K − 1)⌉ tests
//      (in one if it has only pairs with mounted parts), and a test holds K: T ≥ ⌈Σ_x ⌈d_x/(K−1)⌉ /
//      K⌉. If all pairs are needed this is the bound of Schönheim [Schonheim1964].
//  (3) *Introductions.* Each part with a needed pair that is not in S is introduced at least once.
//  (4) If all pairs of n > K parts of F are needed and no other, and |S| ≤ K: I + |S| ≥ K − 1 + b
//      for the least number b of blocks of a linear SCCD(n,K) (bounds/lower_bound.hpp). For put S
//      before the list and restrict it to the n parts. While some set-up B_i has fewer than K of
//      them, add to it a part of B_{i−1} or of B_{i+1} that it lacks: this introduces nothing that
//      was not introduced before. If it lacks none, it contains both neighbours, which can be
//      filled from it likewise; were this to end before all are full, all would be the same set of
//      fewer than n parts. Now take out repetitions and refine each step of j changes into j steps
//      of one: a linear SCCD of 1 + (I + |S| − K) blocks.
//  (5) *Costs.* Every introduction of x makes x meet some needed part at last: else take it away,
//      up to where it leaves, and the list is cheaper or has fewer introductions. So i_x ≤ d_x, and
//      I introductions cost at least one of each part of (3), and the others at the lowest costs
//      that these limits allow.
//  (6) *Degrees.* Where x is introduced it meets at most K − 1 parts of F, where it stays at most
//      the j parts that come: Σ_x max(0, d_x − (K−1)·i_x) ≤ Y, d_x within F, where Y is the sum of
//      j(K − j) over all steps, at the first one j·s + 2·min(C(s,2), needed pairs within S). For
//      given T and I this is the most if the steps after the first are as equal as can be. So
//      introductions beyond the first of each part must make up for Σ_x d_x − Y; an introduction of
//      x makes up for K − 1 at most, for d_x in all. The cheapest way, if parts of an introduction
//      could be had, bounds their cost.
//  (7) *Stays.* Among parts of F of which every two must meet, at most K come once only, and so on
//      for two, three, … times [docs/theorems.md, Theorem 5]; with the price of each part this is a
//      linear program with a solution in closed form (src/plan/search/bounds/stays_cost.hpp). The
//      parts at the start count as a set-up; if they are more than K, they count instead of K.
//  (8) *Steps.* In a cheapest list with fewest introductions and then fewest tests, every set-up
//      after the first introduces a part with a needed pair; else take it away. So I ≥ T − 1 + e,
//      where e is what the first one introduces at least: what the slots need and is not at the
//      start, and if nothing is, the parts of F of a pair.
// *Slots.* K is also at most the sum, over the slots, of the most parts of F with a needed pair
// that a set-up has of it, and of those in no slot; parts without a needed pair that some slot
// needs take room, and are mounted once at least. In (2), x meets at most so many parts of a slot a
// test, and a test holds at most so many; so each slot by itself bounds the tests. In (5), i_x ≤
// d_x falls away for parts of slots that need some. All else is true of any list, and so of those
// that obey the slots.
// *First set-ups.* If some set-ups must come first, the bound is what they cost and that of what is
// left after them.
// *What is replaced.* If costs depend on it, each introduction of x costs at least the least of x's
// own cost and of those in place of any part that does not stay mounted, which is never taken out.
// The bound is that at these prices, or that of docs/theorems.md, Theorem 20.
//
// It is rounded up to a multiple of what divides all costs, and is the least of T·test + (the
// largest of (5), (6) and (7)) over T ≥ (2) and I ≥ I(T), (3), (4), (8). With forbidden pairs,
// pairs that need not meet, a start or tests already done, (4) falls away unless its condition
// holds as it stands; the others stay true. (6) is left out of large
// jobs, where it takes long.

struct CostBound {
  Amount cost;
  std::uint64_t tests = 0;          ///< no list has fewer
  std::uint64_t introductions = 0;  ///< no list has fewer
  std::string reason;               ///< one line with the numbers filled in
};

/// No list of set-ups that does the job costs less. If the scope of this thread (run/control.hpp)
/// wants to stop, the bound is that of (2), (3) and (5), which is known soon.
/// @throws BadInput as check(); ImpossibleParameters if a cost overflows. O(P·K).
[[nodiscard]] CostBound cost_bound(const Job& job);

/// A list of set-ups and how it came about.
struct Candidate {
  std::string name;  ///< "double-change design", "local search", …
  std::string how;   ///< one line
  std::vector<Block> setups;
  std::uint64_t changes = 0;
  Amount change_cost = {};
  Amount cost = {};
  std::uint64_t pairs_tested = 0;
  std::uint64_t triples_tested = 0;
  Amount weight = {};  ///< of the pairs tested, if the job weighs them

  /// Changes, costs and what is tested, as this sheet of the set-ups counts them.
  void take_figures(const RunSheet& sheet);
  [[nodiscard]] std::uint64_t tests() const { return setups.size(); }
};

/// What a plan is to have least of.
enum class PlanObjective {
  cost,  ///< what it costs
  tests  ///< tests, and of plans with so many what it costs; for jobs of a model only
};

/// A plan that is better than those before it, while the search goes on.
struct PlanNews {
  std::string name;  ///< how it came about
  std::uint64_t tests = 0;
  Amount cost = {};   ///< of several benches that are to be done early: the end of the last test
  Amount bound = {};  ///< no plan has less
};

struct PlanOptions {
  PlanObjective objective = PlanObjective::cost;
  std::uint64_t steps = 0;     ///< of each local search, in one round; 0: as many as suit the job
  unsigned attempts = 4;       ///< local searches a round at most, each with its own random numbers
  bool until_stopped = false;  ///< go on with longer searches until the control says stop
  std::optional<Amount> budget = {};
  std::vector<Block> rest = {};  ///< of a plan that is under way: going on with it is a candidate
  std::uint64_t design_moves = 2'000'000;  ///< of the search for better designs; 0: none
  std::uint64_t states = 400'000;  ///< most of the search through all lists of a small job; 0: none
  /// Called on the thread of the caller for each better plan that tests all, before any budget.
  std::function<void(const PlanNews&)> on_better = {};
};

struct RunPlan {
  RunSheet sheet;  ///< of the first candidate
  std::vector<Candidate>
      candidates;  ///< cheapest first; under a budget, most weight or most pairs first
  std::optional<Candidate> complete;  ///< under a budget: the cheapest plan that tests all
  /// of testing all needed pairs: cost_bound(), or better if all lists were looked through
  CostBound bound;
  std::optional<Amount>
      most_weight;  ///< under a budget, if the job weighs pairs: no list within it tests more
  std::uint64_t steps = 0;  ///< moves of local search, over all attempts
  WhyStopped why_stopped = WhyStopped::running;
  PlanObjective objective = PlanObjective::cost;  ///< by which the candidates are ordered
  /// What was missing, in one line, if the search ended early for want of memory, threads or the
  /// like: the plan is then the best of what was found before.
  std::optional<std::string> shortage;

  /// The sheet does the job at the cost of the bound: nothing is cheaper.
  [[nodiscard]] bool proved_cheapest() const {
    return sheet.does_the_job() && sheet.cost == bound.cost;
  }
  /// The sheet does the job with the tests of the bound: nothing has fewer.
  [[nodiscard]] bool proved_fewest() const {
    return sheet.does_the_job() && sheet.steps.size() == bound.tests;
  }
};

/// The best plan that was found; there always is one, also if the control says stop at once: it
/// comes within about a second for a thousand parts. The check of a job that is none yet heeds no
/// limit: who wants to stop it too makes a CheckedJob, in a scope of their own (run/control.hpp).
/// @throws BadInput as check(Job); ImpossibleParameters if costs overflow; MissingResource if a
/// plan needs more memory than the control allows; InternalError if a candidate is not what it
/// should be. Bound by: attempts · steps moves of local search, each O(stretch · at_once), besides
/// the search for designs.
[[nodiscard]] RunPlan make_run_plan(const CheckedJob& job, const PlanOptions& options,
                                    RunControl& control);
[[nodiscard]] RunPlan make_run_plan(const Job& job, const PlanOptions& options,
                                    RunControl& control);

/// The same plan with its parts exchanged at random among those that nothing in the job tells
/// apart: cost, slot, pairs, mounted, at the start. Always the same for a seed; the cost stays, and
/// the sheet is counted anew. `exchanged` is set to the number of parts that are another now.
/// @throws as run_sheet(). O(v³/64).
[[nodiscard]] RunPlan shuffled(const Job& job, RunPlan plan, std::uint64_t seed,
                               std::uint64_t& exchanged);

// Which plan is cheapest when changes become dearer or cheaper against tests: where it breaks even.
//
//     WhatIf answer = what_if(job, plan, {}, control);
//     for (const WhatIf::Range& range : answer.ranges) {   // by ratio, without gaps
//       std::cout << range.plan.name << (range.to ? " up to " + range.to->to_string() : "")
//                 << '\n';
//     }
//
// A plan with T tests and C changes costs T + rC tests at the ratio r of the change cost to the
// test cost: a line in r. The cheapest plans are the lower envelope of the lines of all candidates.
// Where change costs differ from part to part, r is the factor by which all of them are multiplied,
// and C the cost of all changes in units of the test cost.
//
// At every break-even ratio, and far out on both sides, the search of plan/run_plan.hpp is run
// again at that ratio; a cheaper list joins the candidates, until nothing is cheaper or the control
// says stop.

/// A non-negative ratio, not reduced.
struct Ratio {
  std::uint64_t over = 0;
  std::uint64_t under = 1;

  /// In decimals, four digits of it: "0.625", "12.5".
  [[nodiscard]] std::string to_string() const;
};

struct WhatIf {
  struct Range {
    std::optional<Ratio> from;  ///< nothing: from 0
    std::optional<Ratio> to;    ///< nothing: without end
    Candidate plan;             ///< cheapest between them; at both ends as cheap as its neighbour
  };
  bool by_factor = false;  ///< change costs differ: ratios are factors of all change costs
  std::vector<Range> ranges;
  std::optional<Ratio> asked;           ///< where the job stands; nothing if its tests cost nothing
  std::optional<std::string> shortage;  ///< as in RunPlan
  std::vector<std::string>
      notes;  ///< what else is to be said of the job, a line each; what_if() leaves it empty
};

/// The envelope of some candidates, without any search. O(n log n).
/// @throws ImpossibleParameters if costs overflow.
[[nodiscard]] WhatIf envelope(const Job& job, const std::vector<Candidate>& candidates);

/// The envelope of the candidates of a plan and of what searching at its break-even ratios finds.
/// @throws as make_run_plan(), which is what it costs for each ratio.
[[nodiscard]] WhatIf what_if(const Job& job, const RunPlan& plan, const PlanOptions& options,
                             RunControl& control);

// A run sheet for people and for programs.
//
//     SheetDocument document{.job = &job, .plan = &plan, .title = "Pump bench"};
//     written(document, "table", 100);    // for a terminal of 100 columns
//     written(document, "html");  // one page to print, with boxes to tick; needs nothing else
//
// All say for each step what to take out and put in, the set-up, how many needed pairs it tests
// first, and the cost so far; all but CSV add what the plan was compared with and the lower bound
// with its reason. Costs of one document have the same number of decimals. Names are escaped as
// each format asks.
//
// CSV, one row a step, in LF lines; read_setups() (plan/job.hpp) reads it back:
//
//     step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far,result
//     2,Valve 2,"""Motor, small""",Pump A,"Motor, small",1,6,13,
//
// Every place of the bench has a column; with slots those of a slot stand together, called `slot_1
// CPU`. A part that stays keeps its place, and so does what is mounted at the start where
// Job::places says; so do the places their numbers. If costs are times, the column `clock` runs
// along. What is taken out and put in is a list for people; the result is to be filled in. No cell
// is a formula to a spreadsheet: a text that would be one begins with an apostrophe
// (io/write/csv_cell.hpp), which read_setups() takes back; numbers stay numbers. Workbook (.xlsx):
// the sheet `Run sheet` with the columns of the CSV and one for notes, as people print and fill it
// in; `Plan` with costs, bound and what was compared; `Parts`, `Slots` and `Never`, which are read
// as lists of these; `Done` with the tests that were done before; and, hidden, the question
// (job_request.hpp), so that the workbook is all that is needed to go on. Names are text, whatever
// they look like, and so are costs of more than 15 digits; other numbers are numbers. read_setups()
// and read_done() read it back. JSON, one object: format "changeover-plan/1", title, parts [{name,
// change_cost, slot (or null; with slots only)}], at_once, slots [{name, least, most}], test_cost,
// mounted, start, first [[part]], tests_done, met_only_in_failed, trust_failed, tests, changes,
// cost, pairs_needed, pairs_tested, proved_cheapest, lower_bound {cost, tests, changes, reason},
// budget (or null), triples_needed, triples_tested, weight {needed, tested, most (or null)} (or
// null), cost_unit (or null), places [{number, slot (or null)}], steps [{step, take_out, put_in,
// set_up, places [part or null, in the order of places], new_pairs [[a,b]], cost, cost_so_far,
// weight_so_far (where pairs are weighed)}], candidates [{name, how, tests, changes, cost,
// pairs_tested, triples_tested, weight}], notes [text]. If costs depend on what is replaced, also
// replace_costs [[number, or null where a part meets itself or one of another slot]] by part out
// and part in, and in each step replaced [[out, in]]. Of a model also parameters [{name, values
// [{value, part, names, out_of_range}]}], rules (how many), objective, proved_fewest_tests, and in
// each step values {parameter: value}. Costs are exact decimals.
//
// Of a model all formats say for each step what to set, and the value of each parameter; CSV and
// workbooks have a column for each, headed by its name, or by `slot_3 cost` where another column is
// called so. A value with several names has the next one each time that it is set. The workbook's
// sheet `Costs` is what read_value_costs() reads.

/// What is written; job and plan must outlive it.
struct SheetDocument {
  const Job* job = nullptr;
  const RunPlan* plan = nullptr;
  std::optional<Amount> budget = {};
  std::string title = "Run sheet";
  bool compact = false;  ///< pages and tables: what is put in and taken out, not the whole set-up
  std::vector<std::string> notes = {};  ///< what else is to be said of the job, a line each
  const DoneRecord* done = nullptr;     ///< tests that were done before, for a workbook
  std::vector<std::string> question =
      {};  ///< what was asked, as a document in pieces, for a workbook: its head first
};

/// The document as "table" for a terminal (lists are broken between parts where a line would be
/// longer than `width`), "csv", "json"
/// (one line), "markdown" (tables in the style of GitHub), "html" (a page without scripts, pictures
/// or anything from outside) or "xlsx"
/// (the bytes of a workbook), as described above; the same for the same document. @throws BadOption
/// for another format;
/// MissingResource if there is no room for the temporary files of a workbook.
[[nodiscard]] std::string written(const SheetDocument& document, std::string_view format,
                                  std::size_t width = 80);

/// The ranges of ratios with the plan that is cheapest in each and where the job stands: "table",
/// "csv", "json" or
/// "markdown". The job is the one that was asked about. @throws BadOption for another format.
[[nodiscard]] std::string written(const Job& job, const WhatIf& answer, std::string_view format);

}  // namespace changeover
