#include "plan/search/pairs_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/candidates.hpp"
#include "plan/search/exact_plan.hpp"
#include "plan/search/lists/lists_plan.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/one_list.hpp"
#include "plan/search/starts/starts.hpp"
#include "plan/search/weighted.hpp"

namespace changeover {
namespace {

class PairsPlanner {
 public:
  PairsPlanner(const Job& job, const PlanOptions& options, RunControl& control)
      : job_(&job), options_(&options), control_(&control) {}

  RunPlan run() {
    ListWork work{.sure =
                      [&](const RunPlan& plan) {
                        require_memory(
                            bytes_of_plans(plan.bound.tests),
                            fmt::format("a plan of {}", count_of(plan.bound.tests, "test")));
                        return std::vector<Start>{greedy_start(*job_, *control_)};
                      },
                  .mended = [&](const std::vector<Block>& rest) { return mended(rest); },
                  .search = [&](RunPlan& plan) { search(plan); },
                  .within =
                      [&](RunPlan& plan, Amount budget, const Candidate& best) {
                        return std::vector<Start>{within(plan, budget, best)};
                      }};
    if (!job_->weights.empty()) {
      work.most_weight = [&](Amount budget) { return most_weight_within(*job_, budget); };
      work.at_last = [&](const Candidate& cheapest) {
        return Start{cheapest.name, cheapest.how + ", heavy pairs early",
                     heavy_first(*job_, cheapest.setups, *control_)};
      };
    }
    return plan_one_list(*job_, *options_, *control_, work);
  }

 private:
  // The approximate memory of candidates and sheets with this many tests.
  [[nodiscard]] std::uint64_t bytes_of_plans(std::uint64_t tests) const {
    constexpr std::uint64_t a_test = 500;
    constexpr std::uint64_t a_part = 40;
    constexpr std::uint64_t a_pair = 16;
    return tests * (a_test + a_part * (job_->mounted.size() + 2)) +
           a_pair * job_->parts() * job_->parts();
  }

  // The approximate memory of all local searches: slots, counts and copies.
  [[nodiscard]] std::uint64_t bytes_of_search(const Candidate& like) const {
    constexpr std::uint64_t a_test = 300;
    constexpr std::uint64_t a_part = 12;
    constexpr std::uint64_t a_pair = 12;
    const std::uint64_t searches = std::min<std::uint64_t>(control_->threads(), options_->attempts);
    return searches * (like.tests() * (a_test + a_part * job_->room() + job_->parts() / 8) +
                       a_pair * job_->parts() * job_->parts());
  }

  [[nodiscard]] std::optional<std::vector<Block>> mended(const std::vector<Block>& rest) const {
    const Weights weights = Weights::of(*job_, rest.size() + job_->needed.size());
    Sequence sequence(*job_, weights, rest);
    if (!repair(sequence, *control_)) {
      return std::nullopt;
    }
    Lists lists(*job_, weights, {sequence.setups()});
    prune(lists, *control_);
    return lists.lists().front();
  }

  void add(RunPlan& plan, const Start& start) const { add_complete(*job_, plan, *options_, start); }

  void search(RunPlan& plan) {
    std::vector<Candidate>& all = plan.candidates;
    add_designs(plan);
    const auto best = [&]() -> const Candidate& {
      return *std::min_element(all.begin(), all.end(), cheaper);
    };
    require_memory(bytes_of_search(best()),
                   fmt::format("searching among lists of {}", count_of(best().tests(), "test")));
    Attempts attempts(*job_, plan.bound, *control_);
    std::uint64_t steps = options_->steps == 0 ? attempts.suitable_steps(best()) : options_->steps;
    keep_what_there_is(plan, [&] {
      if (!control_->stop_wanted() && best().tests() > 1) {
        const auto fewest = std::min_element(
            all.begin(), all.end(),
            [](const Candidate& a, const Candidate& b) { return a.tests() < b.tests(); });
        const auto covering =
            attempts.covering(*fewest, options_->steps == 0 ? steps / 8 : steps / 4);
        if (covering) {
          add(plan, *covering);
        }
      }
      // Longer and longer searches, each from the best so far, as long as that helps or is wished.
      Rounds rounds(*options_);
      while (best().cost > plan.bound.cost && !control_->stop_wanted()) {
        const unsigned round = rounds.now();
        const Amount before = best().cost;
        const Round next = round_of(attempts, steps, attempts.are_short(best()));
        add(plan, attempts.cheaper_than(best(), next_best(all), next.steps, next.attempts, round));
        if (round == 0 && best().cost > plan.bound.cost && options_->states > 0 &&
            is_small(*job_)) {
          look_at_all(plan, best().cost);
        }
        const bool many = attempts.are_short(best());
        if (!rounds.go_on(best().cost < before, limits(many)) || is_close(plan, best().cost)) {
          break;
        }
        constexpr std::uint64_t longest = std::uint64_t{1} << 60;
        steps = std::min(longest, many ? steps + steps / 4 : 3 * steps);
      }
    });
    plan.steps += attempts.steps();
    std::stable_sort(all.begin(), all.end(), cheaper);
    drop_repeated(all);
  }

  void add_designs(RunPlan& plan) const {
    for (const Start& start : design_starts(*job_, options_->design_moves, *control_)) {
      add(plan, start);
    }
  }

  struct Round {
    std::uint64_t steps = 0;
    unsigned attempts = 0;
  };

  // The next round with this many steps; or one that uses up the time, if little would be left
  // after it. For long lists, few long annealing runs find more than many short ones.
  [[nodiscard]] Round round_of(const Attempts& attempts, std::uint64_t steps, bool many) const {
    if (options_->steps != 0) {
      return {steps, options_->attempts};
    }
    const auto left = control_->time_left();
    if (!options_->until_stopped || !left) {
      constexpr unsigned usual = 2;
      return {steps, std::min(usual, options_->attempts)};
    }
    const unsigned each_thread_one = std::min(control_->threads(), options_->attempts);
    const std::uint64_t all = attempts.steps_until(*left);
    const std::uint64_t much = many ? 2 : 8;
    // The time limit ends a schedule with more steps than there is time for.
    return {all / much < steps ? 4 * all : steps, each_thread_one};
  }

  // One fruitless round says little of a short list; all lists of a small job are looked at anyway.
  [[nodiscard]] Rounds::Limits limits(bool many) const {
    return {.most = many ? 8U : 3U,
            .most_idle = many && !is_small(*job_) ? 3U : 1U,
            .least = many ? 5U : 2U};
  }

  // Whether that is good enough for a search without a given time.
  [[nodiscard]] bool is_close(const RunPlan& plan, Amount now) const {
    constexpr std::uint64_t small_gap = 200;  // one in so many
    return !options_->until_stopped &&
           (now - plan.bound.cost).millionths < plan.bound.cost.millionths / small_gap;
  }

  // Finishes a small job: finds its cheapest list, or proves that the best so far is one. If that
  // takes too long, the bound improves.
  void look_at_all(RunPlan& plan, Amount best) const {
    constexpr std::uint64_t bytes_a_state = 128;
    require_memory(options_->states * bytes_a_state, "looking at all lists of a small job");
    ExactPlan exact = exact_plan(*job_, best, options_->states, *control_);
    if (auto found = take_exact(plan, std::move(exact))) {
      add(plan, *std::move(found));
    }
  }

  [[nodiscard]] Start within(RunPlan& plan, Amount budget, const Candidate& best) const {
    if (!job_->weights.empty()) {
      return {search_name, "the heaviest pairs within the budget",
              heaviest_within(*job_, plan, budget, best.setups, *options_, *control_)};
    }
    Attempts attempts(*job_, plan.bound, *control_);
    const std::uint64_t steps =
        options_->steps == 0 ? attempts.suitable_steps(*plan.complete) : options_->steps;
    Start found = attempts.within(budget, best, steps, options_->attempts);
    plan.steps += attempts.steps();
    return found;
  }

  // The cheapest few candidates from other methods, and the cheapest of all.
  static std::vector<Candidate> next_best(std::vector<Candidate> all) {
    constexpr std::size_t few = 3;
    std::stable_sort(all.begin(), all.end(), cheaper);
    const std::string best = all.front().name;
    std::erase_if(all, [&](const Candidate& c) { return c.name == best || c.name == search_name; });
    all.resize(std::min(all.size(), few));
    return all;
  }

  // Lists the search once, and only if it found a better list than the others.
  static void drop_repeated(std::vector<Candidate>& all) {
    bool seen = false;
    std::size_t others_best = 0;
    while (others_best < all.size() && all[others_best].name == search_name) {
      ++others_best;
    }
    std::erase_if(all, [&, position = std::size_t{0}](const Candidate& c) mutable {
      const std::size_t at = position++;
      if (c.name != search_name) {
        return false;
      }
      const bool worse = at > others_best;
      return std::exchange(seen, true) || worse;
    });
  }

  const Job* job_;
  const PlanOptions* options_;
  RunControl* control_;
};

}  // namespace

RunPlan plan_for_pairs(const Job& job, const PlanOptions& options, RunControl& control) {
  return PairsPlanner(job, options, control).run();
}

}  // namespace changeover
