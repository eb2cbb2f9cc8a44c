#include "plan/search/bounds/step_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
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
  std::optional<CostlyTimes> costly = {};
};

StepCost step_cost_of(const StepProgram& from) {
  return {from.proved(), from.tests(), from.introductions(), from.costly_times()};
}

// One of the programs into which one was split: each list obeys one of them.
struct StepBranch {
  StepProgram program;
  StepCost least;
};

// Parts come a whole number of times: the branch that proves least is split by a number that is
// not whole, as long as that is quick. `best` is what all branches prove.
void split_by_times(std::vector<StepBranch> open, StepCost& best) {
  constexpr std::size_t most_branches = 128;
  constexpr std::uint64_t most_numbers = std::uint64_t{1} << 23U;  // in all tables: 64 MiB
  constexpr double more_than_needed = 1.2;
  const auto weakest = [&] {
    return std::min_element(open.begin(), open.end(), [](const StepBranch& a, const StepBranch& b) {
      return a.least.cost < b.least.cost;
    });
  };
  const auto solved = [](StepBranch branch, double enough) {
    branch.program.solve(enough);
    const StepCost least = step_cost_of(branch.program);
    branch.least = least.cost > branch.least.cost ? least : branch.least;
    return branch;
  };
  for (;;) {
    const auto now = weakest();
    best = now->least;
    const auto broken = now->program.broken();
    const bool full =
        open.size() >= most_branches || (open.size() + 1) * now->program.numbers() > most_numbers;
    if (!broken || full) {
      return;
    }
    const double enough = now->program.in_program(best.cost) * more_than_needed + 1;
    const auto below = static_cast<std::uint64_t>(std::floor(broken->times));
    StepBranch more = *now;
    more.program.come_at_least(broken->parts, below + 1);
    StepBranch fewer = *now;
    fewer.program.come_at_most(broken->parts, below);
    *now = solved(std::move(more), enough);
    open.push_back(solved(std::move(fewer), enough));
  }
}

// For integer numbers of tests: the minimum is a convex function of their number.
StepCost least_by_steps(StepProgram& program) {
  StepCost best{program.proved(), program.tests(), program.introductions()};
  try {
    program.solve();
    best = step_cost_of(program);
    std::vector<StepBranch> open;
    const double tests = program.tests();
    const double below = std::floor(tests + some_of_a_test);
    if (tests - below > some_of_a_test) {
      StepProgram more = program;
      more.tests_at_least(static_cast<std::uint64_t>(below) + 1);
      more.solve();
      StepProgram fewer = std::move(program);
      fewer.tests_at_most(static_cast<std::uint64_t>(below));
      fewer.solve(fewer.in_program(more.proved()) * (1 + some_of_a_test) + some_of_a_test);
      const StepCost with_more = step_cost_of(more);
      const StepCost with_fewer = step_cost_of(fewer);
      best = with_fewer.cost < with_more.cost ? with_fewer : with_more;
      open.push_back({std::move(more), with_more});
      open.push_back({std::move(fewer), with_fewer});
    } else {
      open.push_back({std::move(program), best});
    }
    split_by_times(std::move(open), best);
  } catch (const Stopped&) {
    // the bound so far is valid
  }
  return best;
}

// Numbers of a linear program need not be whole: "12 tests", "11.5 tests".
std::string amount_of(double number, std::string_view what) {
  const double whole = std::round(number);
  return std::abs(number - whole) < 0.01 ? count_of(static_cast<std::uint64_t>(whole), what)
                                         : fmt::format("{:.1f} {}s", number, what);
}

}  // namespace

void raise_by_steps(const Job& job, const std::string& least_known, CostBound& bound) {
  Amount mounting;
  const std::optional<CostliestParts> parts = costliest_parts_of(job, mounting);
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
  const bool model = job.model != nullptr;
  std::string costly;
  if (least.costly) {
    const bool all = least.costly->parts == job.names.size();
    costly =
        fmt::format(", {}{} at least {} in all{}",
                    all ? "" : fmt::format("the {} most expensive ", least.costly->parts),
                    model ? "values are set" : "parts are put in",
                    count_of(least.costly->times, "time"), all ? "" : ", whatever the others do");
  }
  bound.reason = fmt::format(
      "{}{}, and {} is tested only with what {} then: the least that this allows is {} with {} "
      "(docs/plan.md, The lower bound)",
      least_known, costly, model ? "a value that is set" : "what is put in",
      model ? "the other parameters have" : "is mounted", amount_of(least.tests, "test"),
      amount_of(least.introductions + static_cast<double>(n.mounted_introductions), "change"));
}

}  // namespace changeover
