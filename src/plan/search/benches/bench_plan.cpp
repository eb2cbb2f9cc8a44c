// Plans for several benches.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/search/benches/bench_bounds.hpp"
#include "plan/search/benches/bench_budget.hpp"
#include "plan/search/benches/bench_candidate.hpp"
#include "plan/search/benches/bench_field.hpp"
#include "plan/search/benches/cut_list.hpp"
#include "plan/search/benches/some_benches.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/candidates.hpp"
#include "plan/search/first_plan.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/valid_job.hpp"

namespace changeover {
namespace {

class BenchPlanner {
 public:
  BenchPlanner(const Job& job, const std::vector<Bench>& benches, const BenchOptions& options,
               RunControl& control)
      : field_(job, benches), options_(&options), control_(&control) {}

  BenchPlan run() {
    const RunScope scope(*control_);
    const BenchBounds bounds = bounds_in_time();
    plan_.bound = bounds.cost;
    plan_.makespan_bound = bounds.makespan;
    plan_.makespan_reason = bounds.makespan_reason;
    if (field_.common().needed.size() == 0) {
      add("no test",
          field_.asked().needed.size() == 0 ? "nothing is left to test"
                                            : "no test after those that come first",
          BenchLists(field_.size()));
    } else {
      // Within a budget half of the time is for the plan that keeps within it.
      ShareOfTime part = part_of_the_time(options_->plan.budget ? 0.5 : 1.0);
      RunControl* const whole = std::exchange(control_, &part.control());
      find_complete();
      control_ = whole;
    }
    std::stable_sort(
        plan_.candidates.begin(), plan_.candidates.end(),
        [&](const BenchCandidate& a, const BenchCandidate& b) { return better(a, b); });
    if (options_->plan.budget) {
      plan_.complete = plan_.candidates.front();
      if (plan_.complete->cost > *options_->plan.budget) {
        keep_within_budget(field_, *options_, *options_->plan.budget, *control_, plan_);
      }
    }
    const BenchLists& lists = plan_.candidates.front().lists;
    static_cast<BenchCount&>(plan_) =
        lists == counted_lists_ ? std::move(count_)
                                : count_benches(field_.asked(), field_.benches(),
                                                field_.schedule(without_first(field_, lists)));
    plan_.why_stopped = why_it_ended(*control_, !options_->plan.budget && is_best_possible());
    return std::move(plan_);
  }

 private:
  // Bounds for many unlike benches take long, and the plans need most of the time.
  [[nodiscard]] BenchBounds bounds_in_time() const {
    ShareOfTime part = part_of_the_time(0.2);
    const RunScope scope(part.control());
    BenchBounds bounds = bench_bounds(field_);
    raise_by_some_benches(field_, bounds);
    return bounds;
  }

  [[nodiscard]] PlanObjective objective_of_one() const {
    return few_tests() ? PlanObjective::tests : PlanObjective::cost;
  }

  [[nodiscard]] bool by_cost() const { return options_->objective == BenchObjective::cost; }

  [[nodiscard]] bool few_tests() const { return options_->objective == BenchObjective::tests; }

  // Smaller is better.
  using Rank = std::tuple<std::uint64_t, Amount, Amount, std::uint64_t>;
  [[nodiscard]] Rank rank(const BenchCandidate& c) const {
    return {few_tests() ? c.tests : 0, by_cost() ? c.cost : c.makespan,
            by_cost() ? c.makespan : c.cost, c.tests};
  }

  [[nodiscard]] bool better(const BenchCandidate& a, const BenchCandidate& b) const {
    return rank(a) < rank(b);
  }

  [[nodiscard]] const BenchCandidate& best() const {
    return *std::min_element(
        plan_.candidates.begin(), plan_.candidates.end(),
        [&](const BenchCandidate& a, const BenchCandidate& b) { return better(a, b); });
  }

  [[nodiscard]] bool is_best_possible() const {
    return by_cost() ? best().cost == plan_.bound.cost && field_.size() == 1
                     : best().makespan == plan_.makespan_bound &&
                           (!few_tests() || best().tests == plan_.bound.tests);
  }

  void add(const std::string& name, const std::string& how, const BenchLists& lists) {
    BenchCount count;
    BenchCandidate candidate = counted(field_, name, how, lists, &count);
    const Job& asked = field_.asked();
    if (candidate.pairs_tested != asked.needed.size() ||
        candidate.triples_tested != asked.triples.size()) {
      throw InternalError(name + " leaves something untested");
    }
    if (candidate.cost < plan_.bound.cost || candidate.makespan < plan_.makespan_bound) {
      throw InternalError(name + " costs less than the lower bound");
    }
    if (plan_.candidates.empty() || better(candidate, best())) {
      tell(candidate);
      count_ = std::move(count);
      counted_lists_ = candidate.lists;
    }
    const auto same = std::find_if(plan_.candidates.begin(), plan_.candidates.end(),
                                   [&](const BenchCandidate& c) { return c.name == name; });
    if (same == plan_.candidates.end()) {
      plan_.candidates.push_back(std::move(candidate));
    } else if (better(candidate, *same)) {
      *same = std::move(candidate);
    }
  }

  void tell(const BenchCandidate& candidate) const {
    if (options_->plan.on_better) {
      options_->plan.on_better({.name = candidate.name,
                                .tests = candidate.tests,
                                .cost = by_cost() ? candidate.cost : candidate.makespan,
                                .bound = by_cost() ? plan_.bound.cost : plan_.makespan_bound});
    }
  }

  // Runs what may end early.
  void keep_what_there_is(const std::function<void()>& work) {
    changeover::keep_what_there_is(plan_.shortage, work,
                                   [] { return "not enough memory to go on searching"; });
  }

  // The bench that can test everything at the least cost, if there is one.
  [[nodiscard]] std::optional<std::size_t> bench_for_all() const {
    std::optional<std::size_t> found;
    Amount least;
    ShareOfTime part = part_of_the_time(0.1);
    const RunScope scope(part.control());
    for (std::size_t w = 0; w < field_.size(); ++w) {
      const Job& rest = field_.rest(w);
      const bool can = rest.needed.size() == field_.common().needed.size() &&
                       rest.triples.size() == field_.common().triples.size();
      if (can && field_.alike()) {
        return w;
      }
      if (!can || (found && part.control().stop_wanted())) {
        continue;
      }
      if (const Amount bound = bound_of_valid_job(rest).cost; !found || bound < least) {
        found = w;
        least = bound;
      }
    }
    return found;
  }

  void find_complete() {
    std::vector<BenchLists> starts;
    if (const auto alone = bench_for_all()) {
      plan_for_one(*alone, starts);
    } else {
      ShareOfTime part = part_of_the_time(0.15);
      starts.push_back(replan_each(BenchLists(field_.size()), part.control(), true));
      add("one bench after the other", "each tests what it can of what those before it cannot",
          starts.back());
    }
    keep_what_there_is([&] { add_rest(); });
    keep_what_there_is([&] { search(std::move(starts)); });
  }

  // For the first lists: the search for all benches needs more.
  [[nodiscard]] ShareOfTime part_of_the_time(double share) const {
    return {*control_, field_.size() > 1 ? share : 1.0};
  }

  // The list of one bench, and pieces of it for all.
  void plan_for_one(std::size_t alone, std::vector<BenchLists>& starts) {
    PlanOptions once = options_->plan;
    once.objective = objective_of_one();
    once.until_stopped = options_->plan.until_stopped && field_.size() == 1 && !field_.has_clock();
    once.budget.reset();
    once.on_better = nullptr;
    once.rest.clear();
    const Job& rest = field_.rest(alone);
    // A good list is good in pieces, too, if no part is scarce and no bench rests.
    ShareOfTime part = part_of_the_time(field_.has_clock() ? 0.3 : 0.7);
    const RunPlan one = plan_of_valid_job(rest, once, part.control());
    plan_.shortage = one.shortage;
    plan_.steps += one.steps;
    BenchLists lists(field_.size());
    lists[alone] = one.candidates.front().setups;
    take_exact_bound(one.bound, alone);
    add("one bench",
        field_.size() == 1 ? "the " + one.candidates.front().name
                           : "the " + one.candidates.front().name + ", the other benches idle",
        lists);
    if (field_.size() == 1) {
      starts.push_back(lists);
      return;
    }
    constexpr std::size_t few = 3;
    for (std::size_t i = 0; i < std::min(few, one.candidates.size()); ++i) {
      starts.push_back(cut_list(field_, rest, one.candidates[i].setups));
    }
    if (field_.alike()) {
      add("one list, cut", "the " + one.candidates.front().name + " in pieces of about equal cost",
          starts.front());
    }
  }

  // An exhaustive search of a small job may have found a better bound.
  void take_exact_bound(const CostBound& found, std::size_t alone) {
    const bool end_to_end = field_.alike() && field_.rest(alone).start.empty() &&
                            !field_.rest(alone).replaces() && field_.spent(alone).millionths == 0;
    if (field_.size() > 1 && !end_to_end) {
      return;
    }
    CostBound bound = found;
    bound.cost += field_.spent(alone);
    bound.tests = std::max(bound.tests + field_.whole(alone).first.size(), plan_.bound.tests);
    if (bound.cost > plan_.bound.cost) {
      plan_.bound = bound;
    }
    plan_.bound.tests = bound.tests;
    if (field_.size() == 1 && plan_.bound.cost > plan_.makespan_bound) {
      plan_.makespan_bound = plan_.bound.cost;
      plan_.makespan_reason = plan_.bound.reason;
    }
  }

  // The current lists without set-ups that break a rule, and with missing tests added.
  void add_rest() {
    BenchLists rest(field_.size());
    bool any = false;
    for (std::size_t w = 0; w < field_.size(); ++w) {
      PlanOptions options;
      options.rest = without_first_of(field_.bench(w).rest, field_.whole(w).first);
      rest[w] = sound_rest(field_.rest(w), options);
      any = any || !rest[w].empty();
    }
    if (!any) {
      return;
    }
    Lists lists(field_.lists_job(field_.most_tests()), rest);
    if (lists.open() == 0) {
      add("rest of the sheets", "the tests of the sheets that are not done, as they are", rest);
    }
    if (complete(lists, *control_)) {
      prune(lists, *control_);
      add("rest of the sheets, completed", "with what they lacked, without what is not needed",
          lists.lists());
    }
  }

  void search(std::vector<BenchLists> starts) {
    if (field_.size() == 1 && !field_.has_clock()) {
      return;  // the search for one bench has done everything
    }
    const ListsJob job = field_.lists_job(field_.most_tests());
    {
      Lists lists(job, starts.front());
      if (!complete(lists, *control_)) {
        return;
      }
      prune(lists, *control_);
      add("one list, cut and shortened", "without what other benches test anyway", lists.lists());
      ShareOfTime part = part_of_the_time(0.08);
      add("each bench replanned", "cut, and each bench replanned for what only it tests",
          replan_each(lists.lists(), part.control()));
    }
    for (std::size_t i = 0; i < starts.size(); ++i) {
      Lists lists(job, starts[i]);
      if (complete(lists, *control_)) {
        starts[i] = lists.lists();
      }
    }
    Lists from_nothing(job, BenchLists(field_.size()));
    if (complete(from_nothing, *control_)) {
      starts.push_back(from_nothing.lists());
    }
    if (few_tests()) {
      keep_shortest(starts);
    }
    ListsSearch search{.aim = by_cost() ? Aim::least_cost : Aim::least_largest,
                       .steps = options_->plan.steps,
                       .attempts = attempts_between(),
                       .phase = between_benches};
    if (few_tests()) {
      search.most_tests = tests_in(starts.front());
    }
    const unsigned before_rounds = field_.has_single_parts() ? 1 : 0;
    if (before_rounds > 0) {
      search_without_clock(job, starts, search);
    }
    starts.insert(starts.begin(), without_first(field_, best().lists));
    search.round = before_rounds;
    Rounds rounds(options_->plan);
    while (!is_best_possible() && !control_->stop_wanted()) {
      const Rank before = rank(best());
      if (few_tests()) {
        search.most_tests = tests_in(starts.front());
      }
      FoundLists found = search_lists(job, starts, search, *control_);
      plan_.steps += found.steps;
      add(between_benches, "tests and parts moved between benches", found.lists);
      if (!control_->stop_wanted()) {
        found.lists = replan_each(found.lists, *control_);
        add("local search, each bench replanned",
            "then each bench replanned for what only it tests", found.lists);
      }
      if (!rounds.go_on(rank(best()) != before, {})) {
        break;
      }
      search.round = before_rounds + rounds.now();
      starts.front() = without_first(field_, best().lists);
    }
  }

  [[nodiscard]] static std::size_t tests_in(const BenchLists& lists) {
    std::size_t tests = 0;
    for (const std::vector<Block>& list : lists) {
      tests += list.size();
    }
    return tests;
  }

  // The starts with no more tests than the best lists; a search adds none.
  void keep_shortest(std::vector<BenchLists>& starts) const {
    const std::size_t most = tests_in(without_first(field_, best().lists));
    std::erase_if(starts, [&](const BenchLists& lists) { return tests_in(lists) > most; });
    if (starts.empty()) {
      starts.push_back(without_first(field_, best().lists));
    }
  }

  // Without the clock, which looks at every test after a move, a search makes many more moves. It
  // counts for how long a part is on two benches; if this comes to nothing, no bench waits.
  void search_without_clock(ListsJob job, const std::vector<BenchLists>& starts,
                            const ListsSearch& search) {
    job.overlaps = true;
    ShareOfTime part = part_of_the_time(0.5);
    const FoundLists found = search_lists(job, starts, search, part.control());
    plan_.steps += found.steps;
    add("local search without waiting",
        "tests and parts moved between benches, scarce parts on one at a time", found.lists);
  }

  // If the time is used up anyway, few long attempts find more than many short ones.
  [[nodiscard]] unsigned attempts_between() const {
    constexpr unsigned few = 2;  // on each thread
    return options_->plan.until_stopped && control_->time_left()
               ? std::min(few * control_->threads(), options_->plan.attempts)
               : options_->plan.attempts;
  }

  // The needed pairs that only this bench tests.
  [[nodiscard]] Job only_on(const BenchLists& lists, std::size_t bench, bool in_full) const {
    RunControl undisturbed({});
    const RunScope scope(in_full ? undisturbed : *control_);
    Job own = field_.rest(bench);
    for (std::size_t other = 0; other < lists.size(); ++other) {
      if (other != bench && !lists[other].empty()) {
        own.at_once = field_.rest(other).at_once;
        mark_done(own, lists[other]);
      }
    }
    own.at_once = field_.rest(bench).at_once;
    own.start = field_.rest(bench).start;
    own.tests_done = 0;
    return own;
  }

  // One after the other, gives each bench the cheapest list for the pairs that only it tests.
  // `in_full`: also if no time is left.
  BenchLists replan_each(BenchLists lists, RunControl& control, bool in_full = false) {
    for (std::size_t bench = 0; bench < lists.size(); ++bench) {
      if (!in_full && control.stop_wanted()) {
        break;
      }
      const Job own = only_on(lists, bench, in_full);
      if (own.needed.size() == 0) {
        lists[bench].clear();
        continue;
      }
      constexpr std::uint64_t short_search = 200'000;
      PlanOptions options{.objective = objective_of_one(),
                          .steps = options_->plan.steps == 0
                                       ? short_search
                                       : std::min(short_search, options_->plan.steps),
                          .attempts = 2,
                          .rest = lists[bench],
                          .design_moves = 0,
                          .states = 20'000};
      const RunPlan anew = plan_of_valid_job(own, options, control);
      plan_.steps += anew.steps;
      lists[bench] = anew.candidates.front().setups;
    }
    return lists;
  }

  BenchField field_;
  const BenchOptions* options_;
  RunControl* control_;
  BenchPlan plan_;
  BenchCount count_;          // of the best candidate so far
  BenchLists counted_lists_;  // its lists
};

std::vector<Bench> benches_of(const BenchOptions& options) {
  if (options.each.empty() && (options.benches == 0 || options.benches > max_benches)) {
    throw BadInput(fmt::format("{} benches; give 1 to {}", options.benches, max_benches));
  }
  return options.each.empty() ? benches_alike(options.benches) : options.each;
}

void check_options(const Job& job, const BenchOptions& options) {
  if (options.objective == BenchObjective::tests && job.model == nullptr) {
    throw BadInput(
        "only plans of a model can have the objective of fewest tests; choose another objective");
  }
  if (!options.plan.rest.empty()) {
    throw BadInput("tests that were done on several benches need the bench of each; give it");
  }
  if (!job.weights.empty() && !options.plan.budget) {
    throw BadInput("weights of pairs need a budget in plans for several benches; give one");
  }
}

}  // namespace

const char* to_string(BenchObjective objective) {
  switch (objective) {
    case BenchObjective::cost:
      return "cost";
    case BenchObjective::tests:
      return "tests";
    case BenchObjective::makespan:
      break;
  }
  return "makespan";
}

BenchPlan make_bench_plan(const CheckedJob& job, const BenchOptions& options, RunControl& control) {
  return make_bench_plan(*job, options, control);  // a checked job does not include the benches
}

BenchPlan make_bench_plan(const Job& job, const BenchOptions& options, RunControl& control) {
  check_options(job, options);
  const std::vector<Bench> benches = benches_of(options);
  std::optional<BenchPlanner> planner;
  {
    RunControl no_limit({});
    const RunScope scope(no_limit);
    const std::vector<std::string> found = bench_defects(job, benches);
    if (!found.empty()) {
      throw BadInput(leading_defect(found));
    }
    planner.emplace(job, benches, options, control);
  }
  return planner->run();
}

}  // namespace changeover
