#include "changeover/plan/run_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/first_plan.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

// The cost of a candidate at ratio r is tests + r·slope, in common units.
struct Line {
  std::uint64_t tests = 0;
  std::uint64_t slope = 0;
  const Candidate* plan = nullptr;
};

// The ratio where the steeper line, which has fewer tests, meets the other.
Ratio meeting(const Line& steep, const Line& flat) {
  return {flat.tests - steep.tests, steep.slope - flat.slope};
}

bool less(const Ratio& a, const Ratio& b) {
  return Wide{a.over} * b.under < Wide{b.over} * a.under;
}

std::vector<Line> lines_of(const Job& job, const std::vector<Candidate>& candidates) {
  std::vector<Line> lines;
  const bool by_factor = !job.one_change_cost();
  for (const Candidate& plan : candidates) {
    if (plan.pairs_tested != job.needed.size()) {
      continue;
    }
    lines.push_back(by_factor ? Line{(job.test_cost * plan.tests()).millionths,
                                     plan.change_cost.millionths, &plan}
                              : Line{plan.tests(), plan.changes, &plan});
  }
  std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) {
    return std::tie(a.tests, a.slope) < std::tie(b.tests, b.slope);
  });
  return lines;
}

// The job at another ratio of change to test cost.
Job at_ratio(const Job& job, const Ratio& ratio) {
  const std::uint64_t divisor = std::max<std::uint64_t>(1, std::gcd(ratio.over, ratio.under));
  const Amount over{ratio.over / divisor};
  const Amount under{ratio.under / divisor};
  Job other = job;
  if (job.one_change_cost()) {
    other.test_cost = under * 1000;
    other.change_costs.assign(job.names.size(), over * 1000);
  } else {
    // Keeps the numbers small: comparing costs needs no more digits.
    constexpr double scale = 1e6;
    const double factor =
        static_cast<double>(over.millionths) / static_cast<double>(under.millionths);
    double largest = static_cast<double>(job.test_cost.millionths);
    for (const std::vector<Amount>* const costs : {&job.change_costs, &job.replace_costs}) {
      for (const Amount cost : *costs) {
        largest = std::max(largest, factor * static_cast<double>(cost.millionths));
      }
    }
    const auto scaled = [&](double cost) {
      return Amount{
          static_cast<std::uint64_t>(std::llround(cost / std::max(1.0, largest) * scale))};
    };
    other.test_cost = scaled(static_cast<double>(job.test_cost.millionths));
    for (std::vector<Amount>* const costs : {&other.change_costs, &other.replace_costs}) {
      for (Amount& cost : *costs) {
        cost = scaled(factor * static_cast<double>(cost.millionths));
      }
    }
  }
  return other;
}

// The cheapest list that the search for such a job finds at other costs.
Start cheapest_anew(const Job& job, const PlanOptions& options, RunControl& control) {
  PlanOptions once = options;
  once.on_better = nullptr;
  once.until_stopped = false;
  once.budget.reset();
  once.rest.clear();
  once.attempts = std::min(options.attempts, 2U);
  const Candidate found = plan_of_valid_job(job, once, control).candidates.front();
  return {found.name, found.how, found.setups};
}

}  // namespace

std::string Ratio::to_string() const {
  return fmt::format("{:.4g}", static_cast<double>(over) / static_cast<double>(under));
}

WhatIf envelope(const Job& job, const std::vector<Candidate>& candidates) {
  WhatIf answer;
  answer.by_factor = !job.one_change_cost();
  if (answer.by_factor) {
    answer.asked = Ratio{1, 1};
  } else if (job.test_cost.millionths > 0) {
    answer.asked = Ratio{job.change_costs.front().millionths, job.test_cost.millionths};
  }
  const std::vector<Line> lines = lines_of(job, candidates);
  std::vector<Line> hull;  // from r = 0 on: increasing tests, decreasing changes
  for (const Line& line : lines) {
    if (!hull.empty() && line.slope >= hull.back().slope) {
      continue;
    }
    if (!hull.empty() && line.tests == hull.back().tests) {
      hull.pop_back();
    }
    while (hull.size() >= 2 &&
           !less(meeting(hull[hull.size() - 2], hull.back()), meeting(hull.back(), line))) {
      hull.pop_back();
    }
    hull.push_back(line);
  }
  for (std::size_t i = 0; i < hull.size(); ++i) {
    answer.ranges.push_back(
        {.from = i == 0 ? std::nullopt : std::optional(meeting(hull[i - 1], hull[i])),
         .to = i + 1 == hull.size() ? std::nullopt : std::optional(meeting(hull[i], hull[i + 1])),
         .plan = *hull[i].plan});
  }
  return answer;
}

WhatIf what_if(const Job& job, const RunPlan& plan, const PlanOptions& options,
               RunControl& control) {
  refuse_triples(job, "comparing ratios of costs");
  if (!job.first.empty()) {
    return what_if_with_first(job, plan, options, control);
  }
  const RunScope scope(control);
  std::vector<Candidate> candidates = plan.candidates;
  if (plan.complete) {
    candidates.push_back(*plan.complete);
  }
  std::set<std::pair<std::uint64_t, std::uint64_t>> searched;
  const auto cheaper_list = [&](const Job& other, const CostBound& bound, const Candidate& best) {
    Attempts attempts(other, bound, control);
    const std::uint64_t steps =
        options.steps == 0 ? attempts.suitable_steps(best) / 2 : options.steps;
    return attempts.cheaper_than(best, candidates, steps, std::min(options.attempts, 2U), 0);
  };
  // Searches for a list that is cheaper at this ratio than the known ones.
  const auto search = [&](Ratio ratio) {
    const std::uint64_t divisor = std::max<std::uint64_t>(1, std::gcd(ratio.over, ratio.under));
    if (!searched.emplace(ratio.over / divisor, ratio.under / divisor).second ||
        control.stop_wanted() || job.needed.size() == 0) {
      return false;
    }
    const Job other = at_ratio(job, ratio);
    const CostBound bound = bound_of_valid_job(other);
    std::optional<Candidate> best;
    for (const Candidate& candidate : candidates) {
      if (control.stop_wanted()) {
        return false;
      }
      Candidate there = candidate;
      there.cost = run_sheet(other, candidate.setups).cost;
      if (candidate.pairs_tested == job.needed.size() && (!best || there.cost < best->cost)) {
        best = std::move(there);
      }
    }
    if (!best || best->cost == bound.cost) {
      return false;
    }
    const Start start = other.model != nullptr || other.replaces()
                            ? cheapest_anew(other, options, control)
                            : cheaper_list(other, bound, *best);
    if (run_sheet(other, start.setups).cost >= best->cost) {
      return false;
    }
    const RunSheet sheet = run_sheet(job, start.setups);
    if (!sheet.does_the_job()) {
      throw InternalError("a plan for other costs leaves pairs untested");
    }
    candidates.push_back({.name = start.name, .how = start.how, .setups = start.setups});
    candidates.back().take_figures(sheet);
    return true;
  };
  constexpr std::uint64_t far = 1000;
  std::optional<std::string> shortage = plan.shortage;
  const auto search_all = [&] {
    search({1, far});
    search({far, 1});
    constexpr unsigned most_rounds = 12;
    for (unsigned round = 0; round < most_rounds; ++round) {
      bool found = false;
      for (const WhatIf::Range& range : envelope(job, candidates).ranges) {
        found = (range.to && search(*range.to)) || found;
      }
      if (!found) {
        break;
      }
    }
  };
  keep_what_there_is(shortage, search_all,
                     [] { return "not enough memory to search at all ratios"; });
  WhatIf answer = envelope(job, candidates);
  answer.shortage = shortage;
  answer.why_stopped = why_it_ended(control, false);
  return answer;
}

}  // namespace changeover
