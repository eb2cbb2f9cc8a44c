#include "plan/search/bounds/step_bound.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "plan/search/bounds/dearest_parts.hpp"
#include "plan/search/bounds/job_numbers.hpp"
#include "plan/search/bounds/step_program.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_step_parts = 200;
constexpr double some_of_a_test = 1e-6;

struct StepCost {
  Amount cost;
  double tests = 0;
  double introductions = 0;
  std::optional<DearTimes> dear = {};
};

// For integer numbers of tests: the minimum is a convex function of their number.
StepCost least_by_steps(StepProgram& program) {
  const auto found = [](const StepProgram& from) {
    return StepCost{from.proved(), from.tests(), from.introductions(), from.dear_times()};
  };
  StepCost best{program.proved(), program.tests(), program.introductions()};
  try {
    program.solve();
    best = found(program);
    const double tests = program.tests();
    const double below = std::floor(tests + some_of_a_test);
    if (tests - below > some_of_a_test) {
      StepProgram more = program;
      more.tests_at_least(static_cast<std::uint64_t>(below) + 1);
      more.solve();
      StepProgram fewer = std::move(program);
      fewer.tests_at_most(static_cast<std::uint64_t>(below));
      fewer.solve(fewer.in_program(more.proved()) * (1 + some_of_a_test) + some_of_a_test);
      const StepCost with_more = found(more);
      const StepCost with_fewer = found(fewer);
      best = with_fewer.cost < with_more.cost ? with_fewer : with_more;
    }
  } catch (const Stopped&) {
    // the bound so far is valid
  }
  return best;
}

}  // namespace

void raise_by_steps(const Job& job, const std::string& least_known, CostBound& bound) {
  Amount mounting;
  const std::optional<DearestParts> parts = dearest_parts_of(job, mounting);
  constexpr std::uint64_t largest = std::uint64_t{1} << 60U;
  if (!parts || parts->parts.size() > most_step_parts || bound.cost.millionths > largest) {
    return;
  }
  const JobNumbers n = numbers_of(job);
  StepProgram program(job, n, *parts, bound.tests);
  const StepCost least = least_by_steps(program);
  const Amount cost = rounded_up(job, least.cost + mounting);
  if (cost <= bound.cost) {
    return;
  }
  bound.cost = cost;
  const auto up = [](double number) {
    return static_cast<std::uint64_t>(std::ceil(number - 0.01));
  };
  const bool model = job.model != nullptr;
  std::string dear;
  if (least.dear) {
    const bool all = least.dear->parts == job.names.size();
    dear = fmt::format(", {}{} at least {} in all{}",
                       all ? "" : fmt::format("the {} dearest ", least.dear->parts),
                       model ? "values are set" : "parts are put in",
                       count_of(least.dear->times, "time"), all ? "" : ", whatever the others do");
  }
  bound.reason = fmt::format(
      "{}{}, and {} is tested only with what {} then: about {} with {} cost least (docs/plan.md, "
      "The lower bound)",
      least_known, dear, model ? "a value that is set" : "what is put in",
      model ? "the other parameters have" : "is mounted", count_of(up(least.tests), "test"),
      count_of(up(least.introductions) + n.mounted_introductions, "change"));
}

}  // namespace changeover
