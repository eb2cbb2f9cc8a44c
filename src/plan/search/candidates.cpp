#include "plan/search/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/words.hpp"
#include "plan/job/setups/setup_list.hpp"
#include "plan/search/budget.hpp"

namespace changeover {
namespace {

// A list that changes the same number of parts at every step and tests all pairs is a change
// covering design: the verifier must agree.
void verify_as_design(const Job& job, const RunSheet& sheet) {
  const auto change = sheet.constant_change();
  const std::uint64_t v = job.parts();
  const bool triples = !job.triples.empty();
  if (!change || !sheet.does_the_job() || sheet.pairs_needed != v * (v - 1) / 2 || *change == 0 ||
      (triples && sheet.triples_needed != v * (v - 1) * (v - 2) / 6)) {
    return;
  }
  Design design({.v = v,
                 .k = sheet.steps.front().setup.size(),
                 .change = *change,
                 .strength = triples ? 3U : 2U});
  for (const RunStep& step : sheet.steps) {
    design.append(step.setup);
  }
  if (!verify(design).valid()) {
    throw InternalError("the verifier rejects a plan that was counted as complete");
  }
}

// Whether a list may contain this set-up.
bool is_sound(const Job& job, const Block& setup) {
  std::vector<bool> seen(job.names.size());
  for (const Element x : setup) {
    if (x >= job.parts()) {
      throw BadInput(fmt::format("a set-up names part {} of {}; name parts that there are",
                                 std::uint64_t{x} + 1, job.parts()));
    }
    if (seen[x]) {
      return false;
    }
    seen[x] = true;
  }
  return !setup_defect(job, setup);
}

}  // namespace

Candidate counted(const Job& job, const Start& start) {
  RunControl undisturbed({});
  const RunScope scope(undisturbed);
  const RunSheet sheet = run_sheet(job, start.setups);
  if (!sheet.faults.empty()) {
    throw InternalError(fmt::format("{}: {}", start.name, sheet.faults.front()));
  }
  verify_as_design(job, sheet);
  Candidate candidate{.name = start.name, .how = start.how, .setups = start.setups};
  candidate.take_figures(sheet);
  return candidate;
}

Candidate counted_complete(const Job& job, const Start& start) {
  Candidate candidate = counted(job, start);
  if (candidate.pairs_tested != job.needed.size() ||
      candidate.triples_tested != job.triples.size()) {
    throw InternalError(start.name + " leaves something untested");
  }
  return candidate;
}

void add_complete(const Job& job, RunPlan& plan, const PlanOptions& options, const Start& start,
                  const CandidateOrder& better) {
  std::vector<Candidate>& all = plan.candidates;
  try {
    all.push_back(counted_complete(job, start));
  } catch (const ImpossibleParameters&) {
    if (all.empty()) {
      throw;
    }
    return;
  }
  const Candidate& now = all.back();
  if (now.cost < plan.bound.cost || now.tests() < plan.bound.tests) {
    throw InternalError(start.name + " is below the lower bound");
  }
  const bool best =
      std::all_of(all.begin(), all.end() - 1, [&](const Candidate& c) { return better(now, c); });
  if (options.on_better && best) {
    options.on_better(
        {.name = now.name, .tests = now.tests(), .cost = now.cost, .bound = plan.bound.cost});
  }
}

std::vector<Block> sound_rest(const Job& job, const PlanOptions& options) {
  std::vector<Block> rest;
  for (const Block& setup : options.rest) {
    if (is_sound(job, setup)) {
      rest.push_back(setup);
    }
  }
  // With more tests than pairs, some test nothing new. Without them a list costs no more, unless
  // costs depend on what is replaced.
  const std::uint64_t most = job.triples.empty() ? job.needed.size() : job.triples.size();
  if (rest.size() <= most || job.replaces()) {
    return rest;
  }
  const std::vector<RunStep> steps = run_sheet(job, rest).steps;
  std::size_t next = 0;
  std::erase_if(rest, [&](const Block&) {
    const RunStep& step = steps[next++];
    return step.new_pairs.empty() && step.new_triples.empty();
  });
  return rest;
}

Start rest_as_it_is(std::vector<Block> rest) {
  return {"rest of the sheet", "the tests of the sheet that are not done, as they are",
          std::move(rest)};
}

Start rest_mended(std::vector<Block> setups) {
  return {"rest of the sheet, completed", "with what it lacked, without what is not needed",
          std::move(setups)};
}

bool cheaper(const Candidate& a, const Candidate& b) {
  return std::tuple(a.cost, a.changes, a.tests()) < std::tuple(b.cost, b.changes, b.tests());
}

bool tests_more(const Candidate& a, const Candidate& b) {
  return a.weight != b.weight                   ? a.weight > b.weight
         : a.triples_tested != b.triples_tested ? a.triples_tested > b.triples_tested
         : a.pairs_tested != b.pairs_tested     ? a.pairs_tested > b.pairs_tested
                                                : cheaper(a, b);
}

std::vector<Candidate> affordable(const Job& job, const std::vector<Candidate>& plans,
                                  Amount budget, RunControl& control) {
  std::vector<Candidate> within;
  for (const Candidate& plan : plans) {
    if (!within.empty() && control.stop_wanted()) {
      break;
    }
    Start part{"beginning of: " + plan.name, "", {}};
    for (const RunStep& step : run_sheet(job, plan.setups).steps) {
      if (step.cost_so_far > budget) {
        break;
      }
      part.setups.push_back(step.setup);
    }
    part.how =
        fmt::format("the first {} of its {}", part.setups.size(), count_of(plan.tests(), "test"));
    within.push_back(counted(job, part));
  }
  std::stable_sort(within.begin(), within.end(), tests_more);
  return within;
}

void check_within(const std::vector<Candidate>& plans, Amount budget,
                  std::optional<Amount> most_weight) {
  for (const Candidate& plan : plans) {
    if (plan.cost > budget) {
      throw InternalError(plan.name + " exceeds the budget");
    }
    if (most_weight && plan.weight > *most_weight) {
      throw InternalError(plan.name + " tests more weight than can be");
    }
  }
}

void keep_what_there_is(RunPlan& plan, const std::function<void()>& work) {
  keep_what_there_is(plan.shortage, work, [&] {
    return fmt::format("not enough memory to go on searching among lists of {}",
                       count_of(plan.candidates.front().tests(), "test"));
  });
}

void settle(const Job& job, RunPlan& plan, const RunControl& control) {
  plan.sheet = run_sheet(job, plan.candidates.front().setups);
  plan.why_stopped = why_it_ended(control, plan.proved_cheapest());
}

void Candidate::take_figures(const RunSheet& sheet) {
  changes = sheet.changes;
  change_cost = sheet.change_cost;
  cost = sheet.cost;
  pairs_tested = sheet.pairs_tested;
  triples_tested = sheet.triples_tested;
  weight = sheet.weight_tested;
}

}  // namespace changeover
