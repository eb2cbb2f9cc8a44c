#include "plan/search/first_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

// The list counted for this job, with the same name and description.
Candidate counted_for(const Job& job, Candidate candidate) {
  RunControl undisturbed({});
  const RunScope scope(undisturbed);
  const RunSheet sheet = run_sheet(job, candidate.setups);
  if (!sheet.faults.empty()) {
    throw InternalError(fmt::format("{}: {}", candidate.name, sheet.faults.front()));
  }
  candidate.take_figures(sheet);
  return candidate;
}

Candidate with_first(const Job& job, Candidate candidate) {
  if (candidate.setups.empty()) {
    candidate.name = "first tests";
    candidate.how = "no test after them";
  }
  candidate.setups.insert(candidate.setups.begin(), job.first.begin(), job.first.end());
  return counted_for(job, std::move(candidate));
}

Candidate without_first(const Job& job, const Job& rest, Candidate candidate) {
  const auto begin = candidate.setups.begin();
  candidate.setups.erase(begin, begin + static_cast<std::ptrdiff_t>(job.first.size()));
  return counted_for(rest, std::move(candidate));
}

// The rest of a plan, its sheet and candidates, after the first set-ups.
RunPlan rest_of(const Job& job, const Job& rest, const RunPlan& plan) {
  RunPlan left = plan;
  for (Candidate& candidate : left.candidates) {
    candidate = without_first(job, rest, std::move(candidate));
  }
  if (left.complete) {
    left.complete = without_first(job, rest, *left.complete);
  }
  left.sheet = run_sheet(rest, left.candidates.front().setups);
  return left;
}

// A set-up with its parts sorted, since equal set-ups may list them in any order.
Block in_order(Block setup) {
  std::sort(setup.begin(), setup.end());
  return setup;
}

CostBound after(const Job& job, CostBound rest) {
  const RunSheet first = run_sheet(job, job.first);
  rest.cost += first.cost;
  rest.tests += first.steps.size();
  rest.introductions += first.changes;
  rest.reason = fmt::format(
      "the first {} {}; after {}, {}",
      first.steps.size() == 1 ? "test costs" : fmt::format("{} tests cost", first.steps.size()),
      to_string(first.cost), first.steps.size() == 1 ? "it" : "them", rest.reason);
  return rest;
}

}  // namespace

std::vector<Block> without_first_of(std::vector<Block> list, const std::vector<Block>& first) {
  std::map<Block, std::uint64_t> left;
  for (const Block& setup : first) {
    ++left[in_order(setup)];
  }
  std::erase_if(list, [&](const Block& setup) {
    const auto found = left.find(in_order(setup));
    return found != left.end() && found->second > 0 && found->second-- > 0;
  });
  return list;
}

CostBound bound_with_first(const Job& job) {
  return after(job, bound_of_valid_job(after_first(job)));
}

RunPlan plan_with_first(const Job& job, const PlanOptions& options, RunControl& control) {
  const Job rest = after_first(job);
  const Amount spent = run_sheet(job, job.first).cost;
  PlanOptions left = options;
  if (options.budget) {
    if (spent > *options.budget) {
      throw BadInput(fmt::format(
          "budget of {}: the tests that come first alone cost {}; raise the budget, or leave some "
          "of them out",
          to_string(*options.budget), to_string(spent)));
    }
    left.budget = *options.budget - spent;
  }
  if (options.on_better) {
    left.on_better = [&](PlanNews news) {
      news.tests += job.first.size();
      news.cost += spent;
      news.bound += spent;
      options.on_better(news);
    };
  }
  // Going on with a sheet, they are the first of its rest.
  left.rest = without_first_of(std::move(left.rest), job.first);
  RunPlan plan = plan_of_valid_job(rest, left, control);
  for (Candidate& candidate : plan.candidates) {
    candidate = with_first(job, std::move(candidate));
  }
  if (plan.complete) {
    plan.complete = with_first(job, *std::move(plan.complete));
  }
  plan.sheet = run_sheet(job, plan.candidates.front().setups);
  plan.bound = after(job, plan.bound);
  if (plan.most_weight) {
    *plan.most_weight += run_sheet(job, job.first).weight_tested;
  }
  return plan;
}

RunPlan shuffled_with_first(const Job& job, RunPlan plan, std::uint64_t seed,
                            std::uint64_t& exchanged) {
  const Job rest = after_first(job);
  const RunPlan mixed = shuffled(rest, rest_of(job, rest, plan), seed, exchanged);
  plan.candidates.front() = with_first(job, mixed.candidates.front());
  plan.sheet = run_sheet(job, plan.candidates.front().setups);
  return plan;
}

WhatIf what_if_with_first(const Job& job, const RunPlan& plan, const PlanOptions& options,
                          RunControl& control) {
  const Job rest = after_first(job);
  // All lists begin with the same set-ups, whose cost does not influence which one is cheapest.
  WhatIf answer = what_if(rest, rest_of(job, rest, plan), options, control);
  for (WhatIf::Range& range : answer.ranges) {
    range.plan = with_first(job, std::move(range.plan));
  }
  return answer;
}

}  // namespace changeover
