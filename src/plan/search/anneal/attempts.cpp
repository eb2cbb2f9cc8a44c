#include "plan/search/anneal/attempts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/words.hpp"
#include "plan/search/anneal/cooling.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/lists/lists.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "run/threads.hpp"

namespace changeover {
namespace {

// With a budget: the penalty of an uncovered pair as a multiple of the cost of a pair in the best
// list, and the temperatures as multiples of the penalty.
struct BudgetStyle {
  double penalty;
  double hot;
  double cold;
};
constexpr std::array<BudgetStyle, 4> budget_styles{{
    {2.0, 0.30, 0.10},
    {1.8, 0.25, 0.10},
    {2.0, 0.25, 0.08},
    {2.3, 0.25, 0.10},
}};

// Beyond that, a list has far more set-ups than needed.
std::size_t most_tests(const Job& job, std::size_t tests) {
  return tests + std::min<std::size_t>(static_cast<std::size_t>(job.needed.size()), tests + 16);
}

}  // namespace

bool Attempts::are_short(const Candidate& like) const {
  constexpr std::uint64_t places = 300;  // that change
  return like.tests() * (job_->room() - job_->mounted.size()) < places;
}

std::uint64_t Attempts::suitable_steps(const Candidate& like) const {
  constexpr std::uint64_t a_place = 12'000;
  constexpr std::uint64_t least = 200'000;
  constexpr std::uint64_t most = 100'000'000;
  return std::clamp<std::uint64_t>(like.tests() * job_->room() * a_place, least, most);
}

std::uint64_t Attempts::steps_until(std::chrono::duration<double> left) const {
  constexpr double before_any = 5e6;  // moves per second
  const double speed = busy_ > 0 ? static_cast<double>(annealed_) / busy_ : before_any;
  constexpr double most = 1e18;
  return static_cast<std::uint64_t>(std::min(most, std::max(1.0, speed * left.count())));
}

std::optional<Start> Attempts::covering(const Candidate& from, std::uint64_t steps) {
  constexpr double share = 0.05;
  constexpr std::uint64_t few = 200;  // moves per place
  std::optional<std::chrono::duration<double>> time;
  if (const auto left = control_->time_left()) {
    time = *left * share;
    if (steps_until(*time) < few * from.tests() * job_->room()) {
      return std::nullopt;
    }
  }
  const std::size_t limit = most_tests(*job_, from.setups.size());
  const Weights true_weights = Weights::of(*job_, limit);
  // Only set-ups count; changes break ties.
  Weights weights{.test = 1000, .change = std::vector<std::uint64_t>(job_->names.size(), 1)};
  Sequence sequence(*job_, weights, from.setups);
  Random random(control_->seed(), 1'000'000);
  const AnnealedPlan found = anneal(sequence,
                                    {.steps = steps,
                                     .time = time,
                                     .most_tests = limit,
                                     .phase = "looking for a covering with few tests"},
                                    random, *control_);
  steps_ += found.steps;
  std::vector<Block> setups = found.setups.value_or(from.setups);
  if (repair(sequence, *control_)) {
    Lists mended(*job_, weights, {sequence.setups()});
    prune(mended, *control_);
    if (mended.tests() < setups.size()) {
      setups = mended.lists().front();
    }
  }
  setups = order_cheaply(*job_, true_weights, std::move(setups), *control_);
  Lists ordered(*job_, true_weights, {setups});
  prune(ordered, *control_);
  return Start{
      "ordered covering",
      fmt::format("a covering with {}, in a cheap order", count_of(ordered.tests(), "set-up")),
      ordered.lists().front()};
}

Start Attempts::cheaper_than(const Candidate& best, const std::vector<Candidate>& others,
                             std::uint64_t steps, unsigned attempts, unsigned round) {
  std::size_t longest = best.setups.size();
  for (const Candidate& other : others) {
    longest = std::max(longest, other.setups.size());
  }
  const std::size_t limit = most_tests(*job_, longest);
  const Weights weights = Weights::of(*job_, limit);
  struct Result {
    std::int64_t cost = 0;
    std::vector<Block> setups;
    std::string from;
  };
  struct Took {
    std::uint64_t steps = 0;
    double seconds = 0;
  };
  std::vector<Took> took(attempts);
  // If an attempt is cut short, the result is at least the best list so far.
  std::vector<Result> results(attempts,
                              {std::numeric_limits<std::int64_t>::max(), best.setups, best.name});
  in_parallel(*control_, attempts, [&](std::size_t i) {
    const auto take = [&](Lists& lists, const std::string& from, std::int64_t below) {
      prune(lists, *control_);
      if (lists.total() < below) {
        results[i] = {lists.total(), lists.lists().front(), from};
      }
    };
    Lists of_best(*job_, weights, {best.setups});
    take(of_best, best.name, results[i].cost);
    const std::int64_t before = results[i].cost;
    if (control_->stop_wanted()) {
      return;
    }
    constexpr double share =
        0.95;  // the rest is for repair, and for what the time limit does not include
    const auto time = time_of_attempt(*control_, i, attempts, share);
    // With too few moves per place, forgetting a good list, or one from earlier rounds, does not
    // pay.
    constexpr std::uint64_t few = 100;
    const std::uint64_t moves = time ? std::min(steps, steps_until(*time)) : steps;
    const bool stay_near = moves / few < best.tests() * job_->room() ||
                           (are_short(best) ? round % 4 != 0 : round > 0 && i % 2 == 1);
    const HeatStyle& style = stay_near ? warm_style : heat_styles[(i + round) % heat_styles.size()];
    const Candidate& from =
        stay_near || i % 2 == 0 || others.empty() ? best : others[(i / 2 + round) % others.size()];
    Random random(control_->seed(), std::uint64_t{round} * attempts + i);
    Sequence sequence(*job_, weights, from.setups);
    const auto began = control_->elapsed();
    const AnnealedPlan found =
        anneal(sequence,
               {.steps = steps,
                .hot = style.hot,
                .cold = style.cold,
                .time = time,
                .most_tests = limit,
                .phase = fmt::format("local search {} of {}", i + 1, attempts)},
               random, *control_);
    steps_ += found.steps;
    took[i] = {found.steps, (control_->elapsed() - began).count()};
    if (found.setups) {
      if (found.cost < results[i].cost) {
        results[i] = {found.cost, *found.setups, from.name};
      }
      Lists met(*job_, weights, {*found.setups});
      take(met, from.name, results[i].cost);
    }
    if (repair(sequence, *control_)) {
      Lists mended(*job_, weights, {sequence.setups()});
      take(mended, from.name, std::min(before, results[i].cost + 1));
    }
  });
  for (const Took& one : took) {
    annealed_ += one.steps;
    busy_ += one.seconds;
  }
  const Result& cheapest =
      *std::min_element(results.begin(), results.end(),
                        [](const Result& a, const Result& b) { return a.cost < b.cost; });
  return {search_name,
          fmt::format("any number of changes per step; started from the {}", cheapest.from),
          cheapest.setups};
}

Start Attempts::within(Amount budget, const Candidate& best, std::uint64_t steps,
                       unsigned attempts) {
  const std::size_t limit = most_tests(*job_, best.setups.size());
  const Weights weights = Weights::of(*job_, limit);
  // The weights are the costs, rounded up: a list whose weight is within the budget costs no more.
  const auto most = static_cast<std::int64_t>(budget.millionths / weights.unit);
  std::vector<AnnealedPlan> results(attempts);
  in_parallel(*control_, attempts, [&](std::size_t i) {
    Sequence sequence(*job_, weights, best.setups);
    const BudgetStyle& style = budget_styles[i % budget_styles.size()];
    const double per_pair = static_cast<double>(bound_->cost.millionths) /
                            static_cast<double>(weights.unit) /
                            static_cast<double>(job_->needed.size());
    const double penalty = 1.5 * style.penalty * std::max(1.0, per_pair);
    Random random(control_->seed(), 2'000'000 + i);
    results[i] =
        anneal(sequence,
               {.steps = steps,
                .hot = style.hot * penalty,
                .cold = style.cold * penalty,
                .penalty = penalty,
                .budget = most,
                .most_tests = limit,
                .phase = fmt::format("local search {} of {} within the budget", i + 1, attempts)},
               random, *control_);
    steps_ += results[i].steps;
  });
  Start start{search_name, "any number of changes per step, within the budget", best.setups};
  std::size_t least = static_cast<std::size_t>(job_->needed.size() - best.pairs_tested);
  for (AnnealedPlan& result : results) {
    if (result.setups && result.uncovered < least) {
      least = result.uncovered;
      start.setups = std::move(*result.setups);
    }
  }
  return start;
}

}  // namespace changeover
