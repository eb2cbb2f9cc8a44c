#include "plan_state.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "core/each.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

constexpr std::size_t most_bytes_of_a_list = std::size_t{1} << 28;

using Setups = std::vector<Block>;
using BoundState = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::string>;
using CandidateState = std::tuple<std::string, std::string, Setups>;
using Figures = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t,
                           std::uint64_t, std::uint64_t, std::uint64_t>;
using BenchCandidateState = std::tuple<std::string, std::string, std::vector<Setups>, Figures>;
using StepState = std::tuple<Block, std::uint64_t, Block>;
using MaybeNumber = std::optional<std::uint64_t>;
using MaybeText = std::optional<std::string>;
using PlanState = std::tuple<std::vector<CandidateState>, std::optional<CandidateState>, BoundState,
                             MaybeNumber, std::uint64_t, int, int, MaybeText>;
using BenchPlanState =
    std::tuple<std::vector<std::vector<StepState>>, std::vector<BenchCandidateState>,
               std::optional<BenchCandidateState>, BoundState, std::uint64_t, std::string,
               MaybeNumber, std::uint64_t, int, MaybeText>;

MaybeNumber number_of(const std::optional<Amount>& amount) {
  return amount ? MaybeNumber(amount->millionths) : std::nullopt;
}

std::optional<Amount> amount_of(const MaybeNumber& millionths) {
  return millionths ? std::optional(Amount{*millionths}) : std::nullopt;
}

BoundState kept(const CostBound& bound) {
  return {bound.cost.millionths, bound.tests, bound.introductions, bound.reason};
}

CostBound bound_of(const BoundState& state) {
  const auto& [cost, tests, introductions, reason] = state;
  return {.cost = {cost}, .tests = tests, .introductions = introductions, .reason = reason};
}

CandidateState kept(const Candidate& candidate) {
  return {candidate.name, candidate.how, candidate.setups};
}

Candidate candidate_of(const Job& job, const CandidateState& state) {
  Candidate candidate;
  std::tie(candidate.name, candidate.how, candidate.setups) = state;
  candidate.take_figures(run_sheet(job, candidate.setups));
  return candidate;
}

BenchCandidateState kept(const BenchCandidate& candidate) {
  return {candidate.name, candidate.how, candidate.lists,
          Figures(candidate.tests, candidate.changes, candidate.cost.millionths,
                  candidate.makespan.millionths, candidate.pairs_tested, candidate.triples_tested,
                  candidate.weight.millionths)};
}

BenchCandidate candidate_of(const BenchCandidateState& state) {
  BenchCandidate candidate;
  Figures figures;
  std::tie(candidate.name, candidate.how, candidate.lists, figures) = state;
  std::tie(candidate.tests, candidate.changes, candidate.cost.millionths,
           candidate.makespan.millionths, candidate.pairs_tested, candidate.triples_tested,
           candidate.weight.millionths) = figures;
  return candidate;
}

PlanState kept(const RunPlan& plan) {
  return {
      each_of<CandidateState>(plan.candidates, [](const Candidate& each) { return kept(each); }),
      plan.complete ? std::optional(kept(*plan.complete)) : std::nullopt,
      kept(plan.bound),
      number_of(plan.most_weight),
      plan.steps,
      static_cast<int>(plan.why_stopped),
      static_cast<int>(plan.objective),
      plan.shortage};
}

RunPlan plan_of(const Job& job, const PlanState& state) {
  const auto& [candidates, complete, bound, most_weight, steps, why, objective, shortage] = state;
  if (candidates.empty()) {
    throw BadInput("a plan has set-ups");
  }
  RunPlan plan;
  plan.candidates = each_of<Candidate>(
      candidates, [&](const CandidateState& each) { return candidate_of(job, each); });
  plan.sheet = run_sheet(job, plan.candidates.front().setups);
  if (complete) {
    plan.complete = candidate_of(job, *complete);
  }
  plan.bound = bound_of(bound);
  plan.most_weight = amount_of(most_weight);
  plan.steps = steps;
  plan.why_stopped = static_cast<WhyStopped>(why);
  plan.objective = static_cast<PlanObjective>(objective);
  plan.shortage = shortage;
  return plan;
}

BenchPlanState kept(const BenchPlan& plan) {
  std::vector<std::vector<StepState>> schedule;
  for (const std::vector<BenchStep>& bench : plan.schedule) {
    schedule.push_back(each_of<StepState>(bench, [](const BenchStep& step) {
      return StepState(step.setup, step.begin.millionths, step.again);
    }));
  }
  return {std::move(schedule),
          each_of<BenchCandidateState>(plan.candidates,
                                       [](const BenchCandidate& each) { return kept(each); }),
          plan.complete ? std::optional(kept(*plan.complete)) : std::nullopt,
          kept(plan.bound),
          plan.makespan_bound.millionths,
          plan.makespan_reason,
          number_of(plan.most_weight),
          plan.steps,
          static_cast<int>(plan.why_stopped),
          plan.shortage};
}

BenchPlan plan_of(const Job& job, const std::vector<Bench>& benches, const BenchPlanState& state) {
  const auto& [steps_of_benches, candidates, complete, bound, makespan_bound, makespan_reason,
               most_weight, steps, why, shortage] = state;
  BenchSchedule schedule;
  for (const std::vector<StepState>& bench : steps_of_benches) {
    schedule.push_back(each_of<BenchStep>(bench, [&](const StepState& step) {
      const auto& [setup, begin, again] = step;
      if (std::ranges::any_of(again, [&](Element x) { return x >= job.names.size(); })) {
        throw BadInput("a part that is put in again is none of the job");
      }
      return BenchStep{.setup = setup, .begin = {begin}, .again = again};
    }));
  }
  BenchPlan plan;
  static_cast<BenchCount&>(plan) = count_benches(job, benches, schedule);
  plan.candidates = each_of<BenchCandidate>(
      candidates, [](const BenchCandidateState& each) { return candidate_of(each); });
  if (complete) {
    plan.complete = candidate_of(*complete);
  }
  plan.bound = bound_of(bound);
  plan.makespan_bound = {makespan_bound};
  plan.makespan_reason = makespan_reason;
  plan.most_weight = amount_of(most_weight);
  plan.steps = steps;
  plan.why_stopped = static_cast<WhyStopped>(why);
  plan.shortage = shortage;
  return plan;
}

// The list with the content of its file. False if that is gone, or can be read only once.
bool hold(RequestList& list) {
  const std::string path = list_file(list.file);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return false;
  }
  std::string bytes;
  try {
    bytes = read_to_end(*open_input(path), most_bytes_of_a_list, "give a shorter list");
  } catch (const Error&) {
    return false;
  }
  if (bytes.starts_with("PK\x03\x04")) {
    list.sheet = path.size() < list.file.size() ? list.file.substr(path.size() + 1) : "";
    list.workbook = std::move(bytes);
  } else {
    list.text = std::move(bytes);
  }
  list.file.clear();
  return true;
}

}  // namespace

std::optional<JobRequest> without_files(const JobRequest& request) {
  JobRequest whole = request;
  for (const auto& option : job_table().options) {
    const auto* const field = std::get_if<RequestList JobRequest::*>(&option.field);
    if (field != nullptr && !(whole.**field).file.empty() && !hold(whole.**field)) {
      return std::nullopt;
    }
  }
  return whole;
}

py::tuple state_of(const Planned& plan) {
  if (!plan.whole) {
    throw BadInput(
        "a plan of a file that is gone, or can be read only once, cannot be pickled or copied; "
        "read the parts from a regular file");
  }
  const PlanAnswer& answer = plan.answer;
  return py::make_tuple(to_json(plan.request), to_json(*plan.whole), answer.notes,
                        answer.plan ? std::optional(kept(*answer.plan)) : std::nullopt,
                        answer.benches ? std::optional(kept(*answer.benches)) : std::nullopt);
}

std::unique_ptr<Planned> planned_again(const py::tuple& state) {
  using Fields = std::tuple<std::string, std::string, std::vector<std::string>,
                            std::optional<PlanState>, std::optional<BenchPlanState>>;
  const auto fields = state.cast<Fields>();
  const auto& plan = std::get<std::optional<PlanState>>(fields);
  const auto& benches = std::get<std::optional<BenchPlanState>>(fields);
  const JobRequest whole = job_request(std::get<1>(fields));
  auto again = std::make_unique<Planned>(Planned{.request = job_request(std::get<0>(fields)),
                                                 .asked = checked({.request = whole, .notes = {}}),
                                                 .whole = whole});
  PlanAnswer& answer = again->answer;
  answer.notes = std::get<std::vector<std::string>>(fields);
  answer.options = plan_options(again->asked);
  answer.objective = bench_objective(again->request);
  stoppable([&] {
    if (plan) {
      answer.plan = plan_of(again->job(), *plan);
    } else if (benches) {
      answer.benches = plan_of(again->job(), again->asked->benches, *benches);
    } else {
      throw BadInput("a plan has set-ups");
    }
    return true;
  });
  return again;
}

}  // namespace changeover::python
