#include "plan/search/lists/lists_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/candidates.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

class ListsPlanner {
 public:
  ListsPlanner(const Job& job, const PlanOptions& options, RunControl& control,
               const FirstLists& first)
      : job_(&job),
        options_(&options),
        control_(&control),
        first_(&first),
        weights_(weights_of(job, most_tests())) {}

  RunPlan run() {
    const RunScope scope(*control_);
    RunPlan plan;
    plan.bound = bound_of_valid_job(*job_);
    if (job_->needed.size() == 0 && job_->triples.empty()) {
      plan.candidates.push_back(counted(*job_, {"no test", "nothing is left to test", {}}));
      settle(*job_, plan, *control_);
      return plan;
    }
    for (const Start& start : first_->sure()) {
      add(plan, start);
    }
    keep_what_there_is(plan, [&] {
      add_rest(plan);
      for (const Start& start : first_->more ? first_->more() : std::vector<Start>()) {
        add(plan, start);
      }
      search(plan);
    });
    std::stable_sort(plan.candidates.begin(), plan.candidates.end(), cheaper);
    if (options_->budget && plan.candidates.front().cost > *options_->budget) {
      find_affordable(plan);
    } else if (options_->budget) {
      plan.complete = plan.candidates.front();
    }
    settle(*job_, plan, *control_);
    return plan;
  }

 private:
  [[nodiscard]] std::uint64_t most_tests() const {
    return 2 * (of_triples() ? job_->triples.size() : job_->needed.size()) + 16;
  }

  [[nodiscard]] bool of_triples() const { return !job_->triples.empty(); }
  [[nodiscard]] std::string what_meets() const { return of_triples() ? "triples" : "pairs"; }

  void add(RunPlan& plan, const Start& start) const {
    Candidate candidate = counted_complete(*job_, start);
    if (candidate.cost < plan.bound.cost) {
      throw InternalError(start.name + " costs less than the lower bound");
    }
    plan.candidates.push_back(std::move(candidate));
    tell_if_best(plan, *options_, cheaper);
  }

  // The current list without set-ups that break a rule, and with missing tests added.
  void add_rest(RunPlan& plan) const {
    const std::vector<Block> rest = sound_rest(*job_, *options_);
    if (rest.empty()) {
      return;
    }
    Lists lists(*job_, weights_, {rest});
    if (lists.open() == 0) {
      add(plan, rest_as_it_is(rest));
    }
    if (complete(lists, *control_)) {
      prune(lists, *control_);
      add(plan, rest_mended(lists.lists().front()));
    }
  }

  void search(RunPlan& plan) const {
    ListsSearch search{.steps = options_->steps,
                       .attempts = options_->attempts,
                       .phase = "local search among lists of " + what_meets()};
    const auto best = [&]() -> const Candidate& {
      return *std::min_element(plan.candidates.begin(), plan.candidates.end(), cheaper);
    };
    while (best().cost > plan.bound.cost && !control_->stop_wanted()) {
      std::vector<Candidate> all = plan.candidates;
      std::stable_sort(all.begin(), all.end(), cheaper);
      constexpr std::size_t few = 3;
      std::vector<BenchLists> starts;
      for (std::size_t i = 0; i < std::min(few, all.size()); ++i) {
        starts.push_back({all[i].setups});
      }
      const FoundLists found =
          search_lists(ListsJob::alike(*job_, weights_, 1), starts, search, *control_);
      plan.steps += found.steps;
      std::erase_if(plan.candidates, [&](const Candidate& c) { return c.name == search_name; });
      add(plan, {search_name,
                 fmt::format("any number of changes a step; started from the {}", all.front().name),
                 found.lists.front()});
      ++search.round;
      if (!options_->until_stopped) {
        break;
      }
    }
  }

  void find_affordable(RunPlan& plan) const {
    const Amount budget = *options_->budget;
    plan.complete = plan.candidates.front();
    std::vector<Candidate> within = affordable(*job_, plan.candidates, budget, *control_);
    keep_what_there_is(plan, [&] {
      const WithinBudget most{.job = ListsJob::alike(*job_, weights_, 1),
                              .budget = budget,
                              .whole = plan.bound.cost,
                              .what_meets = "most " + what_meets()};
      within.push_back(counted(
          *job_, {search_name, "any number of changes a step, within the budget",
                  heaviest_within(plan, most, within.front().setups, *options_, *control_)}));
    });
    std::stable_sort(within.begin(), within.end(), tests_more);
    check_within(within, budget, std::nullopt);
    plan.candidates = std::move(within);
  }

  const Job* job_;
  const PlanOptions* options_;
  RunControl* control_;
  const FirstLists* first_;
  Weights weights_;
};

}  // namespace

RunPlan plan_by_lists(const Job& job, const PlanOptions& options, RunControl& control,
                      const FirstLists& first) {
  return ListsPlanner(job, options, control, first).run();
}

std::vector<Block> heaviest_within(RunPlan& plan, const WithinBudget& within,
                                   const std::vector<Block>& from, const PlanOptions& options,
                                   RunControl& control) {
  const auto in_weights = [&](Amount amount) {
    return static_cast<std::int64_t>(amount.millionths / within.job.weights.front().unit);
  };
  ListsSearch search{
      .aim = Aim::most_weight,
      .budget = in_weights(within.budget),
      .whole = in_weights(within.whole),
      .steps = options.steps,
      .attempts = options.attempts,
      .phase = fmt::format("looking for the {} within the budget", within.what_meets)};
  std::vector<Block> best = from;
  do {
    // Weights are rounded up: a list may exceed the budget by weight although its cost is within
    // it.
    if (Lists(within.job, {best}).total() > search.budget) {
      break;
    }
    const FoundLists found = search_lists(within.job, {{best}}, search, control);
    best = found.lists.front();
    plan.steps += found.steps;
    ++search.round;
  } while (options.until_stopped && !control.stop_wanted());
  return best;
}

}  // namespace changeover
