#include "plan/search/choices/choice_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/candidates.hpp"
#include "plan/search/choices/choice_search.hpp"
#include "plan/search/exact_plan.hpp"
#include "plan/search/one_list.hpp"
#include "run/threads.hpp"

namespace changeover {
namespace {

class ChoicePlanner {
 public:
  ChoicePlanner(const Job& job, const PlanOptions& options, RunControl& control)
      : job_(job), options_(options), control_(control) {}

  RunPlan run() {
    RunPlan plan = plan_one_list(
        job_, options_, control_,
        {.sure = [&](const RunPlan&) { return std::vector<Start>{greedy()}; },
         .mended = [&](const std::vector<Block>& rest) { return mended(rest); },
         .search =
             [&](RunPlan& made) {
               add_swept(made);
               search(made);
             },
         .within = [&](RunPlan& made, Amount budget,
                       const Candidate& from) { return within(*made.complete, budget, from); },
         .better = [&](const Candidate& a, const Candidate& b) { return is_better(a, b); }});
    plan.steps += steps_;
    return plan;
  }

 private:
  [[nodiscard]] bool few_tests() const { return options_.objective == PlanObjective::tests; }

  [[nodiscard]] bool is_better(const Candidate& a, const Candidate& b) const {
    return few_tests()
               ? std::tuple(a.tests(), a.cost, a.changes) < std::tuple(b.tests(), b.cost, b.changes)
               : cheaper(a, b);
  }
  [[nodiscard]] const Candidate& best(const RunPlan& plan) const {
    return *std::ranges::min_element(plan.candidates,
                                     [&](const auto& a, const auto& b) { return is_better(a, b); });
  }
  // Whether no better list is possible.
  [[nodiscard]] bool is_done(const RunPlan& plan) const {
    const Candidate& now = best(plan);
    return now.cost == plan.bound.cost && (!few_tests() || now.tests() == plan.bound.tests);
  }

  void add(RunPlan& plan, const Start& start) const {
    add_complete(job_, plan, options_, start,
                 [&](const Candidate& a, const Candidate& b) { return is_better(a, b); });
  }

  // Replaces a candidate of the same name if the list is better.
  void replace(RunPlan& plan, const Start& start) const {
    Candidate candidate = counted_complete(job_, start);
    const auto old = std::ranges::find(plan.candidates, start.name, &Candidate::name);
    if (old != plan.candidates.end() && !is_better(candidate, *old)) {
      return;
    }
    if (old != plan.candidates.end()) {
      plan.candidates.erase(old);
    }
    add(plan, start);
  }

  // Makes the tables, too.
  [[nodiscard]] Start greedy() {
    {
      RunControl undisturbed({});
      const RunScope without_limit(undisturbed);
      choices_.emplace(job_);
    }
    Random random(control_.seed(), 3'000'000);
    ChoiceList list(*choices_, {});
    complete_greedily(*choices_, list, few_tests() ? GreedyAim::tests : GreedyAim::cost, random,
                      control_);
    if (!control_.stop_wanted()) {
      prune_choices(*choices_, list);
    }
    return {"greedy list",
            few_tests() ? "always the test that brings most"
                        : "always the test that brings most for its cost",
            list.setups()};
  }

  [[nodiscard]] std::vector<Block> mended(const std::vector<Block>& rest) const {
    Random random(control_.seed(), 4'000'000);
    ChoiceList list(*choices_, in_order(rest));
    complete_greedily(*choices_, list, GreedyAim::cost, random, control_);
    prune_choices(*choices_, list);
    return list.setups();
  }

  // Many tests with few changes: good where tests cost little.
  void add_swept(RunPlan& plan) const {
    constexpr std::uint64_t few_parameters = 8;
    if (few_tests() || !job_.triples.empty() || job_.slots.size() < few_parameters) {
      return;
    }
    constexpr std::uint64_t tries = 8;
    std::optional<ChoiceList> best;
    for (std::uint64_t i = 0; i < tries && !control_.stop_wanted(); ++i) {
      Random random(control_.seed(), 9'000'000 + i);
      const auto rows = swept(*choices_, random);
      if (!rows) {
        return;
      }
      ChoiceList list(*choices_, *rows);
      complete_greedily(*choices_, list, GreedyAim::cost, random, control_);
      prune_choices(*choices_, list);
      if (!best || list.cost() < best->cost()) {
        best = std::move(list);
      }
    }
    if (best) {
      add(plan, {"sweeps", "one parameter after the other takes its next value", best->setups()});
    }
  }

  // Moves of a first annealing.
  [[nodiscard]] std::uint64_t suitable_moves(const Candidate& like) const {
    constexpr std::uint64_t a_cell = 6'000;
    constexpr std::uint64_t least = 300'000;
    constexpr std::uint64_t most = 20'000'000;
    const std::uint64_t cells = like.tests() * job_.slots.size();
    return options_.steps != 0 ? options_.steps : std::clamp(cells * a_cell, least, most);
  }

  void search(RunPlan& plan) {
    const std::uint64_t moves = suitable_moves(plan.candidates.front());
    shorten(plan, few_tests() ? moves / 4 : moves / 20);
    if (!few_tests() && is_small(job_) && options_.states > 0) {
      look_at_all(plan);
    }
    std::uint64_t steps = moves;
    Rounds rounds(options_);
    while (!is_done(plan) && !control_.stop_wanted()) {
      const auto before = std::pair(best(plan).tests(), best(plan).cost);
      if (few_tests() && rounds.now() > 0) {
        shorten(plan, steps / 4);
      }
      anneal(plan, steps, rounds.now());
      if (!rounds.go_on(std::pair(best(plan).tests(), best(plan).cost) != before,
                        {.most_idle = 2})) {
        break;
      }
      steps = std::min(2 * steps, longest);
    }
  }

  static constexpr std::uint64_t longest = std::uint64_t{1} << 34;

  // Lists with few tests, in a cheap order.
  void shorten(RunPlan& plan, std::uint64_t moves) {
    const std::vector<Block> from = shortest(plan);
    std::vector<std::vector<Block>> found(options_.attempts);
    const unsigned turn = shortened_++;
    in_parallel(control_, options_.attempts, [&](std::size_t i) {
      Random random(control_.seed(), 5'000'000 + std::uint64_t{turn} * options_.attempts + i);
      ChoiceList list(*choices_, {});
      if (i % 2 == 0 && turn > 0) {
        list = ChoiceList(*choices_, from);
      } else {
        complete_greedily(*choices_, list, GreedyAim::tests, random, control_);
      }
      steps_ += remove_tests(*choices_, list, plan.bound.tests,
                             std::max<std::uint64_t>(moves / 8, 1000), random, control_);
      found[i] = list.setups();
    });
    const auto fewest = std::ranges::min_element(found, {}, &std::vector<Block>::size);
    if (fewest->empty() || (turn > 0 && fewest->size() >= from.size())) {
      return;
    }
    replace(plan, {short_list_name, "as few tests as were found, in any order", *fewest});
    const AnnealedChoices ordered = annealed(*fewest,
                                             {.steps = std::max<std::uint64_t>(moves, 1000),
                                              .fixed_tests = FixedTests{},
                                              .phase = "putting few tests into a cheap order"},
                                             6'000'000 + turn);
    if (ordered.setups) {
      replace(plan,
              {short_list_name, "as few tests as were found, in a cheap order", *ordered.setups});
    }
  }

  [[nodiscard]] static std::vector<Block> shortest(const RunPlan& plan) {
    return std::ranges::min_element(plan.candidates, {}, &Candidate::tests)->setups;
  }

  AnnealedChoices annealed(const std::vector<Block>& from, const ChoiceAnnealing& annealing,
                           std::uint64_t stream) {
    Random random(control_.seed(), stream);
    AnnealedChoices found = anneal_choices(*choices_, ChoiceList(*choices_, in_order(from)),
                                           annealing, random, control_);
    steps_ += found.steps;
    return found;
  }

  // Each set-up in the order of the parameters.
  [[nodiscard]] std::vector<Block> in_order(std::vector<Block> setups) const {
    for (Block& setup : setups) {
      std::ranges::sort(setup, {}, [&](Element x) { return job_.slot_of[x]; });
    }
    return setups;
  }

  [[nodiscard]] std::optional<std::chrono::duration<double>> time_for(std::size_t attempt,
                                                                      std::size_t attempts) const {
    constexpr double share = 0.95;  // the rest is for what the clock does not see
    return time_of_attempt(control_, attempt, attempts, share);
  }

  // The temperatures of attempts: hot ones forget where they started.
  static constexpr std::array<double, 4> heats{1.0, 0.3, 0.6, 0.15};
  static constexpr std::array<FixedTests, 4> fixed_styles{
      {{1.3, 0.6, 0.06}, {15, 1.5, 0.15}, {4, 0.8, 0.15}, {8, 0.6, 0.1}}};

  // Searches of one round. Where a clock ends it, no more than run side by side: one that cools
  // slowly finds better lists than several that share the time.
  [[nodiscard]] std::size_t attempts_of_a_round() const {
    const std::size_t most = options_.attempts;
    return !few_tests() && options_.until_stopped && control_.time_left()
               ? std::min<std::size_t>(most, control_.threads())
               : most;
  }

  void anneal(RunPlan& plan, std::uint64_t steps, unsigned round) {
    const Candidate from = best(plan);
    const std::vector<Block> few = shortest(plan);
    const std::size_t attempts = attempts_of_a_round();
    std::vector<AnnealedChoices> found(attempts);
    in_parallel(control_, attempts, [&](std::size_t i) {
      const bool from_few = !few_tests() && (i + round) % 4 == 2;
      found[i] =
          annealed(from_few ? few : from.setups,
                   {.steps = steps,
                    .hot = heats[(i + round) % heats.size()],
                    .time = time_for(i, attempts),
                    .fixed_tests =
                        few_tests() ? std::optional(fixed_styles[(i + round) % fixed_styles.size()])
                                    : std::nullopt,
                    .phase = fmt::format("local search {} of {}", i + 1, attempts)},
                   7'000'000 + std::uint64_t{round} * options_.attempts + i);
    });
    const AnnealedChoices* cheapest = nullptr;
    for (const AnnealedChoices& each : found) {
      if (each.setups && (cheapest == nullptr || each.cost < cheapest->cost)) {
        cheapest = &each;
      }
    }
    if (cheapest != nullptr) {
      replace(plan, {search_name,
                     fmt::format("any number of changes per step; started from the {}", from.name),
                     *cheapest->setups});
    }
  }

  void look_at_all(RunPlan& plan) const {
    ExactPlan exact = exact_plan(job_, best(plan).cost, options_.states, control_);
    if (auto found = take_exact(plan, std::move(exact))) {
      add(plan, *std::move(found));
    }
  }

  std::vector<Start> within(const Candidate& complete, Amount budget, const Candidate& from) {
    std::vector<AnnealedChoices> found(options_.attempts);
    const std::uint64_t steps = suitable_moves(complete);
    in_parallel(control_, options_.attempts, [&](std::size_t i) {
      found[i] = annealed(
          from.setups,
          {.steps = steps,
           .hot = heats[i % heats.size()],
           .time = time_for(i, options_.attempts),
           .budget = static_cast<std::int64_t>(budget.millionths / choices_->weights().unit),
           .phase =
               fmt::format("local search {} of {} within the budget", i + 1, options_.attempts)},
          8'000'000 + i);
    });
    std::vector<Start> starts;
    for (AnnealedChoices& each : found) {
      if (each.setups) {
        starts.push_back({search_name, "any number of changes per step, within the budget",
                          *std::move(each.setups)});
      }
    }
    return starts;
  }

  static constexpr const char* short_list_name = "short list";

  const Job& job_;
  const PlanOptions& options_;
  RunControl& control_;
  std::optional<ChoiceJob> choices_;
  std::atomic<std::uint64_t> steps_{0};
  unsigned shortened_ = 0;
};

}  // namespace

RunPlan plan_for_choices(const Job& job, const PlanOptions& options, RunControl& control) {
  if (!job.weights.empty()) {
    throw BadInput("plans of a model do not support weights of pairs; leave the weights out");
  }
  return ChoicePlanner(job, options, control).run();
}

}  // namespace changeover
