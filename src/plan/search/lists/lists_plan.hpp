// Plans for one bench by the search among lists (lists_search.hpp).
#pragma once

#include <functional>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/lists/lists.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// Complete lists to start with. The fast ones are always made, also if the control requests a
/// stop; there is at least one.
struct FirstLists {
  std::function<std::vector<Start>()> sure;
  std::function<std::vector<Start>()> more = {};
};

/// make_run_plan() for a job without first set-ups and without defects: these lists, the rest of
/// the current list, and a local search that starts from the best of them.
[[nodiscard]] RunPlan plan_by_lists(const Job& job, const PlanOptions& options, RunControl& control,
                                    const FirstLists& first);

/// The list within the budget that tests the most weight, at least as much as `from`, which is
/// within it. Adds its moves to those of the plan.
[[nodiscard]] std::vector<Block> heaviest_within(const Job& job, RunPlan& plan, Amount budget,
                                                 const std::vector<Block>& from,
                                                 const PlanOptions& options, RunControl& control);

}  // namespace changeover
