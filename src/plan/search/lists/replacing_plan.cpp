#include "plan/search/lists/replacing_plan.hpp"

#include "plan/job/prices.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/lists/lists_plan.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

// The candidates of the same job at mean prices, for which less than half of the time is used.
std::vector<Start> at_mean_prices(const Job& job, const PlanOptions& options, RunControl& control) {
  PlanOptions once = options;
  once.on_better = nullptr;  // their costs differ
  once.until_stopped = false;
  once.budget.reset();
  once.rest.clear();
  once.states = 0;
  constexpr double share = 0.4;
  ShareOfTime part(control, share);
  const RunPlan plan = plan_of_valid_job(at_prices(job, Price::mean), once, part.control());
  std::vector<Start> starts;
  for (const Candidate& candidate : plan.candidates) {
    starts.push_back({candidate.name + " at mean prices", candidate.how, candidate.setups});
  }
  return starts;
}

}  // namespace

RunPlan plan_for_replacing(const Job& job, const PlanOptions& options, RunControl& control) {
  if (!job.weights.empty()) {
    refuse_replacing(job, "putting heavy pairs first");
  }
  return plan_by_lists(job, options, control,
                       {.sure = [&] { return at_mean_prices(job, options, control); }});
}

}  // namespace changeover
