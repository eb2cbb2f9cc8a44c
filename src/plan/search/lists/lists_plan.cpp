#include "plan/search/lists/lists_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "changeover/run/control.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/candidates.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/one_list.hpp"

namespace changeover {
namespace {

const char* what_meets(const Job& job) {
  return !job.triples.empty() ? "triples" : job.weights.empty() ? "pairs" : "heaviest pairs";
}

ListsJob lists_job(const Job& job, std::size_t tests) {
  return ListsJob::alike(job, Weights::of(job, tests + job.needed.size() + job.triples.size()), 1);
}

std::optional<std::vector<Block>> mended(const Job& job, const std::vector<Block>& list,
                                         RunControl& control) {
  const ListsJob one = lists_job(job, list.size());
  Lists lists(one, {list});
  if (!complete(lists, control)) {
    return std::nullopt;
  }
  prune(lists, control);
  return lists.lists().front();
}

void search(const Job& job, RunPlan& plan, const PlanOptions& options, RunControl& control) {
  const ListsJob lists = lists_job(job, job.needed.size() + job.triples.size() + 16);
  ListsSearch search{.steps = options.steps,
                     .attempts = options.attempts,
                     .phase = fmt::format("local search among lists of {}", what_meets(job))};
  const auto best = [&]() -> const Candidate& {
    return *std::ranges::min_element(plan.candidates, cheaper);
  };
  while (best().cost > plan.bound.cost && !control.stop_wanted()) {
    std::vector<Candidate> all = plan.candidates;
    std::ranges::stable_sort(all, cheaper);
    constexpr std::size_t few = 3;
    std::vector<BenchLists> starts;
    for (std::size_t i = 0; i < std::min(few, all.size()); ++i) {
      starts.push_back({all[i].setups});
    }
    const FoundLists found = search_lists(lists, starts, search, control);
    plan.steps += found.steps;
    std::erase_if(plan.candidates, [&](const Candidate& c) { return c.name == search_name; });
    add_complete(
        job, plan, options,
        {search_name,
         fmt::format("any number of changes per step; started from the {}", all.front().name),
         found.lists.front()});
    ++search.round;
    if (!options.until_stopped) {
      break;
    }
  }
}

}  // namespace

RunPlan plan_by_lists(const Job& job, const PlanOptions& options, RunControl& control,
                      const FirstLists& first) {
  return plan_one_list(
      job, options, control,
      {.sure = [&](const RunPlan&) { return first.sure(); },
       .mended = [&](const std::vector<Block>& rest) { return mended(job, rest, control); },
       .search =
           [&](RunPlan& plan) {
             for (const Start& start : first.more ? first.more() : std::vector<Start>()) {
               add_complete(job, plan, options, start);
             }
             search(job, plan, options, control);
           },
       .within =
           [&](RunPlan& plan, Amount budget, const Candidate& best) {
             return std::vector<Start>{
                 {search_name, "any number of changes per step, within the budget",
                  heaviest_within(job, plan, budget, best.setups, options, control)}};
           }});
}

std::vector<Block> heaviest_within(const Job& job, RunPlan& plan, Amount budget,
                                   const std::vector<Block>& from, const PlanOptions& options,
                                   RunControl& control) {
  ListsJob one = lists_job(job, from.size());
  for (Element x = 0; x < job.parts() && !job.replaces(); ++x) {
    // Rounding up free changes must not exceed the budget.
    std::uint64_t& weight = one.weights.front().change[x];
    weight = job.change_costs[x].millionths == 0 ? 0 : weight;
  }
  const std::uint64_t unit = one.weights.front().unit;
  ListsSearch search{.aim = Aim::most_weight,
                     .budget = static_cast<std::int64_t>(budget.millionths / unit),
                     .whole = static_cast<std::int64_t>(plan.bound.cost.millionths / unit),
                     .steps = options.steps,
                     .attempts = options.attempts,
                     .phase = fmt::format("looking for the {}{} within the budget",
                                          job.weights.empty() ? "most " : "", what_meets(job))};
  std::vector<Block> best = from;
  do {
    // Weights are rounded up: a list may exceed the budget by weight although its cost is within
    // it.
    if (Lists(one, {best}).total() > search.budget) {
      break;
    }
    const FoundLists found = search_lists(one, {{best}}, search, control);
    best = found.lists.front();
    plan.steps += found.steps;
    ++search.round;
  } while (options.until_stopped && !control.stop_wanted());
  return best;
}

}  // namespace changeover
