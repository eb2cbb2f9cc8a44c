#include "changeover/plan/run_plan.hpp"

#include <algorithm>
#include <array>

#include "changeover/core/error.hpp"
#include "plan/job/check_in_full.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/choices/choice_plan.hpp"
#include "plan/search/first_plan.hpp"
#include "plan/search/lists/lists_plan.hpp"
#include "plan/search/pairs_plan.hpp"
#include "plan/search/triple_plan.hpp"
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
  starts.reserve(plan.candidates.size());
  for (const Candidate& candidate : plan.candidates) {
    starts.push_back({candidate.name + " at mean prices", candidate.how, candidate.setups});
  }
  return starts;
}

// Plans for costs that depend on what is replaced: the ordinary search at the mean price of each
// part, and then a search among lists with the true costs.
RunPlan plan_for_replacing(const Job& job, const PlanOptions& options, RunControl& control) {
  if (!job.weights.empty()) {
    refuse_replacing(job, "putting heavy pairs first");
  }
  return plan_by_lists(job, options, control,
                       {.sure = [&] { return at_mean_prices(job, options, control); }});
}

enum class Fewest { cost, cost_or_tests };

// A way to plan jobs without defects.
struct Strategy {
  bool (*serves)(const Job&);
  Fewest fewest;  // the objectives that it supports
  RunPlan (*plan)(const Job&, const PlanOptions&, RunControl&);
};

// The first strategy that supports a job plans it. `first` and `replacing` derive a simpler job,
// which they do not support, and plan it by this list. Plans for several benches (benches.hpp) are
// not a strategy: they have another kind of answer, and use this list for each bench.
constexpr std::array strategies{
    Strategy{[](const Job& job) { return !job.first.empty(); }, Fewest::cost_or_tests,
             plan_with_first},
    Strategy{[](const Job& job) { return job.model != nullptr; }, Fewest::cost_or_tests,
             plan_for_choices},
    Strategy{[](const Job& job) { return job.replaces(); }, Fewest::cost, plan_for_replacing},
    Strategy{[](const Job& job) { return !job.triples.empty(); }, Fewest::cost, plan_for_triples},
    Strategy{[](const Job&) { return true; }, Fewest::cost, plan_for_pairs},
};

}  // namespace

RunPlan plan_of_valid_job(const Job& job, const PlanOptions& options, RunControl& control) {
  const auto strategy =
      std::ranges::find_if(strategies, [&](const Strategy& each) { return each.serves(job); });
  if (options.objective == PlanObjective::tests && strategy->fewest == Fewest::cost) {
    throw BadInput(
        "only plans of a model can have the objective of fewest tests; choose another objective");
  }
  RunPlan plan = strategy->plan(job, options, control);
  raise_numbers(job, plan.bound);
  return plan;
}

RunPlan make_run_plan(const Job& job, const PlanOptions& options, RunControl& control) {
  check_in_full(job);
  return plan_of_valid_job(job, options, control);
}

RunPlan make_run_plan(const CheckedJob& job, const PlanOptions& options, RunControl& control) {
  return plan_of_valid_job(*job, options, control);
}

}  // namespace changeover
