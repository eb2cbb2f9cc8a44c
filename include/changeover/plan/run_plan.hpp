// The cheapest run sheet for a job that we can find, what it was compared with, and how far it can be from
// the cheapest there is.
//
//     RunControl control({.time = std::chrono::seconds(10)});
//     RunPlan plan = make_run_plan(make_job(9, 3, parse_amount("1"), parse_amount("5")), {}, control);
//     plan.sheet.cost;  plan.bound.cost;             // e.g. 117 and 117
//     for (const Candidate& c : plan.candidates) {   // cheapest first: the first one is the sheet
//       std::cout << c.name << ": " << to_string(c.cost) << '\n';
//     }
//
// Candidates. Single-, double- and m-change designs over the parts with needed pairs, those that are known
// or that local search (search/local_search.hpp) makes of them, relabelled so that dear parts stand where
// introductions are rare; a list that takes the best next step again and again; a covering with few set-ups,
// in a cheap order; and the result of a local search over lists with any number of changes a step, in rounds that start
// from the best of the others or forget it; without a time, they end when a round finds nothing better or the gap to the
// bound is under one percent. If a plan is under way, its rest, with what it lacks and without what it need not; so no new plan
// is dearer than going on. Under a budget: the plan that tests the most needed pairs, at least as many as the longest
// affordable part of the cheapest complete plan does.
//
// If the job weighs its pairs, the plan under a budget tests the most weight, and a list for all pairs is put into an order, of
// set-ups and of parts that nothing else tells apart, in which heavy pairs meet early and which costs no more.
//
// A small job, of at most 12 parts and 64 pairs, is then searched through: its cheapest list is found or proved, unless more than
// PlanOptions::states have to be looked at.
//
// Contract. Every candidate is counted by run_sheet() and breaks no constraint; all but those of a
// budget do the job; one that is an m-change covering design is verified as such. Without a time limit the
// result depends on the job, the options and the seed only, not on the number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/cost_bound.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/run_sheet.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

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

struct PlanOptions {
  std::uint64_t steps = 0;     ///< of each local search, in one round; 0: as many as suit the job
  unsigned attempts = 4;       ///< local searches a round at most, each with its own random numbers
  bool until_stopped = false;  ///< go on with longer searches until the control says stop
  std::optional<Amount> budget = {};
  std::vector<Block> rest = {};  ///< of a plan that is under way: going on with it is a candidate
  std::uint64_t design_moves = 2'000'000;  ///< of the search for better designs; 0: none
  std::uint64_t states = 400'000;  ///< most of the search through all lists of a small job; 0: none
};

struct RunPlan {
  RunSheet sheet;  ///< of the first candidate
  std::vector<Candidate>
      candidates;  ///< cheapest first; under a budget, most weight or most pairs first
  std::optional<Candidate> complete;  ///< under a budget: the cheapest plan that tests all
  CostBound
      bound;  ///< of testing all needed pairs: cost_bound(), or better if all lists were looked through
  std::optional<Amount>
      most_weight;  ///< under a budget, if the job weighs pairs: no list within it tests more
  std::uint64_t steps = 0;  ///< moves of local search, over all attempts
  WhyStopped why_stopped = WhyStopped::running;
  /// What was missing, in one line, if the search ended early for want of memory, threads or the like: the
  /// plan is then the best of what was found before.
  std::optional<std::string> shortage;

  /// The sheet does the job at the cost of the bound: nothing is cheaper.
  [[nodiscard]] bool proved_cheapest() const {
    return sheet.does_the_job() && sheet.cost == bound.cost;
  }
};

/// The best plan that was found; there always is one, also if the control says stop at once: it comes within
/// about a second for a thousand parts. The check of a job that is none yet heeds no limit: who wants to stop it too makes a
/// CheckedJob, in a scope of their own (run/scope.hpp).
/// @throws BadInput as check(Job); ImpossibleParameters if costs overflow; MissingResource if a plan needs
/// more memory than the control allows; InternalError if a candidate is not what it should be. Bound by: attempts · steps moves of local search, each
/// O(stretch · at_once), besides the search for designs.
[[nodiscard]] RunPlan make_run_plan(const CheckedJob& job, const PlanOptions& options,
                                    RunControl& control);
[[nodiscard]] RunPlan make_run_plan(const Job& job, const PlanOptions& options,
                                    RunControl& control);

/// The same plan with its parts exchanged at random among those that nothing in the job tells apart: cost, slot, pairs,
/// mounted, at the start. Always the same for a seed; the cost stays, and the sheet is counted anew. `exchanged` is set to the
/// number of parts that are another now. @throws as run_sheet(). O(v³/64).
[[nodiscard]] RunPlan shuffled(const Job& job, RunPlan plan, std::uint64_t seed,
                               std::uint64_t& exchanged);

// Which plan is cheapest when changes become dearer or cheaper against tests: where it breaks even.
//
//     WhatIf answer = what_if(job, plan, {}, control);
//     for (const WhatIf::Range& range : answer.ranges) {   // by ratio, without gaps
//       std::cout << range.plan.name << (range.to ? " up to " + range.to->to_string() : "") << '\n';
//     }
//
// A plan with T tests and C changes costs T + rC tests at the ratio r of the change cost to the test cost: a
// line in r. The cheapest plans are the lower envelope of the lines of all candidates. Where change costs
// differ from part to part, r is the factor by which all of them are multiplied, and C the cost of all
// changes in units of the test cost.
//
// At every break-even ratio, and far out on both sides, the search of plan/run_plan.hpp is run again at
// that ratio; a cheaper list joins the candidates, until nothing is cheaper or the control says stop.

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

}  // namespace changeover
