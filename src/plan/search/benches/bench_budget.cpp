#include "plan/search/benches/bench_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "plan/search/benches/bench_candidate.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/weighted.hpp"

namespace changeover {
namespace {

bool brings_more(const BenchCandidate& a, const BenchCandidate& b) {
  return std::tuple(b.weight, b.triples_tested, b.pairs_tested, a.cost, a.makespan) <
         std::tuple(a.weight, a.triples_tested, a.pairs_tested, b.cost, b.makespan);
}

class WithinBudget {
 public:
  WithinBudget(const BenchField& field, const BenchOptions& options, RunControl& control,
               BenchPlan& plan)
      : field_(&field), options_(&options), control_(&control), plan_(&plan) {}

  void run(Amount budget) {
    Amount spent;
    for (std::size_t w = 0; w < field_->size(); ++w) {
      spent += field_->spent(w);
    }
    std::vector<BenchCandidate> within;
    BenchCandidate none =
        counted(*field_, "first tests", "no test after them", BenchLists(field_->size()));
    if (none.cost > budget) {
      throw BadInput(fmt::format(
          "budget of {}: the tests that come first alone cost {}; raise the budget, or leave some "
          "of them out",
          to_string(budget), to_string(none.cost)));
    }
    constexpr std::size_t few = 3;
    for (std::size_t i = 0; i < std::min(few, plan_->candidates.size()); ++i) {
      const BenchCandidate& whole = plan_->candidates[i];
      if (i == 0 || !control_->stop_wanted()) {
        BenchCandidate part =
            counted(*field_, "beginning of: " + whole.name, "", affordable(whole, budget));
        part.how = fmt::format("the first {} of its {}", part.tests, count_of(whole.tests, "test"));
        within.push_back(std::move(part));
      }
    }
    if (!field_->asked().weights.empty()) {
      plan_->most_weight = most_weight(budget);
    }
    std::stable_sort(within.begin(), within.end(), brings_more);
    keep_what_there_is(
        plan_->shortage, [&] { search_within(budget, within); },
        [] { return "not enough memory to go on searching"; });
    within.push_back(std::move(none));
    std::erase_if(within, [&](const BenchCandidate& c) { return c.cost > budget; });
    std::stable_sort(within.begin(), within.end(), brings_more);
    plan_->candidates = std::move(within);
  }

 private:
  // The longest beginning, in time, that is within the budget.
  [[nodiscard]] BenchLists affordable(const BenchCandidate& whole, Amount budget) const {
    const BenchLists lists = without_first(*field_, whole.lists);
    const BenchSchedule schedule = field_->schedule(lists);
    struct Begin {
      Amount at;
      std::size_t bench = 0;
    };
    std::vector<Begin> begins;
    for (std::size_t i = 0, w = 0; i < schedule.size(); ++i) {
      if (!field_->benches()[i].down) {
        for (std::size_t step = field_->whole(w).first.size(); step < schedule[i].size(); ++step) {
          begins.push_back({schedule[i][step].begin, w});
        }
        ++w;
      }
    }
    std::stable_sort(begins.begin(), begins.end(),
                     [](const Begin& a, const Begin& b) { return a.at < b.at; });
    const auto beginning = [&](std::size_t tests) {
      BenchLists part(lists.size());
      for (std::size_t i = 0; i < tests; ++i) {
        const std::size_t w = begins[i].bench;
        part[w].push_back(lists[w][part[w].size()]);
      }
      return part;
    };
    std::size_t low = 0;
    for (std::size_t high = begins.size(); low < high;) {
      const std::size_t middle = low + (high - low + 1) / 2;
      counted(*field_, "", "", beginning(middle)).cost <= budget ? low = middle : high = middle - 1;
    }
    return beginning(low);
  }

  void search_within(Amount budget, std::vector<BenchCandidate>& within) {
    const ListsJob job = field_->lists_job(field_->most_tests(), true);
    const std::uint64_t unit = job.weights.front().unit;
    ListsSearch search{.aim = Aim::most_weight,
                       .budget = static_cast<std::int64_t>(budget.millionths / unit),
                       .whole = static_cast<std::int64_t>(plan_->bound.cost.millionths / unit),
                       .steps = options_->plan.steps,
                       .attempts = options_->plan.attempts,
                       .phase = "looking for the most pairs within the budget"};
    do {
      std::vector<BenchLists> starts;
      for (const BenchCandidate& candidate : within) {
        const BenchLists lists = without_first(*field_, candidate.lists);
        if (Lists(job, lists).total() <= search.budget) {
          starts.push_back(lists);
        }
      }
      if (starts.empty() || control_->stop_wanted()) {
        return;
      }
      const FoundLists found = search_lists(job, starts, search, *control_);
      plan_->steps += found.steps;
      BenchCandidate candidate =
          counted(*field_, between_benches,
                  "tests and parts moved between benches, within the budget", found.lists);
      std::erase_if(within, [&](const BenchCandidate& c) {
        return c.name == candidate.name && brings_more(candidate, c);
      });
      if (std::none_of(within.begin(), within.end(),
                       [&](const BenchCandidate& c) { return c.name == candidate.name; })) {
        within.push_back(std::move(candidate));
      }
      std::stable_sort(within.begin(), within.end(), brings_more);
      ++search.round;
    } while (options_->plan.until_stopped);
  }

  // A bound on the weight within the budget: end to end the lists are one list, for which the least
  // costs are enough. Parts at the start of a bench are charged once more, with a test.
  [[nodiscard]] std::optional<Amount> most_weight(Amount budget) const {
    if (!field_->alike()) {
      return std::nullopt;
    }
    Job job = field_->asked();
    const Job& own = field_->whole(0);
    job.test_cost = own.test_cost;
    job.change_costs = own.change_costs;
    job.at_once = own.at_once;
    job.mounted = own.mounted;
    job.slots = own.slots;
    job.slot_of = own.slot_of;
    job.start = own.start;
    job.first.clear();
    for (std::size_t w = 1; w < field_->size() && !own.start.empty(); ++w) {
      budget += job.test_cost;
      for (const Element x : own.start) {
        budget += job.change_costs[x];
      }
    }
    return most_weight_within(job, budget);
  }

  const BenchField* field_;
  const BenchOptions* options_;
  RunControl* control_;
  BenchPlan* plan_;
};

}  // namespace

void keep_within_budget(const BenchField& field, const BenchOptions& options, Amount budget,
                        RunControl& control, BenchPlan& plan) {
  WithinBudget(field, options, control, plan).run(budget);
}

}  // namespace changeover
