// Plans for one bench by the search among lists (lists_search.hpp).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/lists/lists.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// Complete lists to begin with. Those that are sure are made at once, also if the control says
/// stop; there is one at least.
struct FirstLists {
  std::function<std::vector<Start>()> sure;
  std::function<std::vector<Start>()> more = {};
};

/// make_run_plan() for a job without first set-ups and without defects: these lists, the rest of a
/// list under way, and a local search that starts from the best of them.
[[nodiscard]] RunPlan plan_by_lists(const Job& job, const PlanOptions& options, RunControl& control,
                                    const FirstLists& first);

/// A budget, in which as much as can be is to meet.
struct WithinBudget {
  ListsJob job;
  Amount budget;
  Amount whole;            ///< what it costs at least that everything meets
  std::string what_meets;  ///< in a word or two, as in "most triples"
};

/// The list that tests the most weight, no less than `from`, which is within the budget. Adds its
/// moves to those of the plan.
[[nodiscard]] std::vector<Block> heaviest_within(RunPlan& plan, const WithinBudget& within,
                                                 const std::vector<Block>& from,
                                                 const PlanOptions& options, RunControl& control);

}  // namespace changeover
