#include "changeover/plan/benches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "plan/job/check_in_full.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/anneal/attempts.hpp"
#include "plan/search/bounds/rounded_up.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/valid_job.hpp"
#include "plan/search/weighted.hpp"

namespace changeover {
namespace {

// A list in at most so many pieces, in its order, so that the dearest costs as little as can be.
BenchLists cut(const Job& job, const std::vector<Block>& setups, std::uint64_t benches) {
  std::vector<std::uint64_t> going_on;  // by set-up: what it costs after the one before
  std::vector<std::uint64_t> anew;      // and at the beginning of a list
  std::uint64_t most = 0;
  for (const RunStep& step : run_sheet(job, setups).steps) {
    std::uint64_t all = job.test_cost.millionths;
    for (const Element x : step.setup) {
      all += job.change_costs[x].millionths;
    }
    going_on.push_back(step.cost.millionths);
    anew.push_back(all);
    most += going_on.back();
  }
  // Where pieces begin if none costs more than the limit.
  const auto pieces = [&](std::uint64_t limit) {
    std::vector<std::size_t> begins;
    std::uint64_t cost = 0;
    for (std::size_t i = 0; i < setups.size(); ++i) {
      if (begins.empty() || cost + going_on[i] > limit) {
        begins.push_back(i);
        cost = anew[i];
      } else {
        cost += going_on[i];
      }
    }
    return begins;
  };
  std::uint64_t low = setups.empty() ? 0 : *std::max_element(anew.begin(), anew.end());
  for (std::uint64_t high = std::max(low, most); low < high;) {
    const std::uint64_t middle = low + (high - low) / 2;
    pieces(middle).size() <= benches ? high = middle : low = middle + 1;
  }
  const std::vector<std::size_t> begins = pieces(low);
  BenchLists lists(static_cast<std::size_t>(benches));
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : setups.size();
    lists[i].assign(setups.begin() + static_cast<std::ptrdiff_t>(begins[i]),
                    setups.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return lists;
}

// What only this bench tests of what has to meet.
Job only_on(const Job& job, const BenchLists& lists, std::size_t bench) {
  Job own = job;
  for (std::size_t other = 0; other < lists.size(); ++other) {
    if (other != bench) {
      mark_done(own, lists[other]);
    }
  }
  own.start.clear();
  own.tests_done = 0;
  return own;
}

class BenchPlanner {
 public:
  BenchPlanner(const Job& job, const BenchOptions& options, RunControl& control)
      : job_(&job), options_(&options), control_(&control) {}

  BenchPlan run() {
    const RunScope scope(*control_);
    PlanOptions once = options_->plan;
    once.until_stopped = false;
    RunPlan one = plan_of_valid_job(*job_, once, *control_);
    plan_.shortage = one.shortage;
    plan_.steps = one.steps;
    plan_.bound = one.bound;
    bound_largest();
    BenchLists alone(static_cast<std::size_t>(options_->benches));
    alone.front() = one.candidates.front().setups;
    add("one bench", "the " + one.candidates.front().name + ", the other benches idle", alone);
    std::vector<BenchLists> starts;
    constexpr std::size_t few = 3;
    for (std::size_t i = 0; i < std::min(few, one.candidates.size()); ++i) {
      starts.push_back(cut(*job_, one.candidates[i].setups, options_->benches));
    }
    add("one list, cut", "the " + one.candidates.front().name + " in pieces of about equal cost",
        starts.front());
    try {
      search(starts);
    } catch (const Stopped&) {
      // The control knows why.
    } catch (const MissingResource& fault) {
      plan_.shortage = fault.what();
    } catch (const std::bad_alloc&) {
      plan_.shortage = "not enough memory to go on searching";
    }
    std::stable_sort(
        plan_.candidates.begin(), plan_.candidates.end(),
        [&](const BenchCandidate& a, const BenchCandidate& b) { return better(a, b); });
    static_cast<BenchCount&>(plan_) = count_benches(*job_, plan_.candidates.front().lists);
    return std::move(plan_);
  }

 private:
  [[nodiscard]] bool by_cost() const { return options_->objective == BenchObjective::cost; }

  [[nodiscard]] bool better(const BenchCandidate& a, const BenchCandidate& b) const {
    return by_cost()
               ? std::tuple(a.cost, a.largest, a.tests) < std::tuple(b.cost, b.largest, b.tests)
               : std::tuple(a.largest, a.cost, a.tests) < std::tuple(b.largest, b.cost, b.tests);
  }

  [[nodiscard]] const BenchCandidate& best() const {
    return *std::min_element(
        plan_.candidates.begin(), plan_.candidates.end(),
        [&](const BenchCandidate& a, const BenchCandidate& b) { return better(a, b); });
  }

  [[nodiscard]] bool is_best_possible() const {
    return by_cost() ? best().cost == plan_.bound.cost && options_->benches == 1
                     : best().largest == plan_.largest_bound;
  }

  void add(const std::string& name, const std::string& how, const BenchLists& lists) {
    RunControl undisturbed({});
    const RunScope scope(undisturbed);
    const BenchCount count = count_benches(*job_, lists);
    if (!count.does_the_job()) {
      throw InternalError(
          name + ": " + (count.faults.empty() ? "something is not tested" : count.faults.front()));
    }
    if (count.cost < plan_.bound.cost || count.largest < plan_.largest_bound) {
      throw InternalError(name + " costs less than the lower bound");
    }
    std::erase_if(plan_.candidates, [&](const BenchCandidate& c) { return c.name == name; });
    plan_.candidates.push_back(
        {name, how, lists, count.tests, count.changes, count.cost, count.largest});
  }

  void bound_largest() {
    const std::uint64_t n = options_->benches;
    Amount& bound = plan_.largest_bound;
    bound = rounded_up(*job_, Amount{ceil_div(plan_.bound.cost.millionths, n)});
    plan_.largest_reason = n == 1 ? "every plan costs so much"
                                  : fmt::format("the {} benches together cost at least {}", n,
                                                to_string(plan_.bound.cost));
    const Job priced = at_prices(*job_, Price::least);
    const auto is_mounted = [&](Element x) {
      return std::find(job_->mounted.begin(), job_->mounted.end(), x) != job_->mounted.end();
    };
    Amount mounting = job_->test_cost;
    for (const Element m : job_->mounted) {
      mounting += priced.change_costs[m];
    }
    std::uint64_t inner = 0;
    job_->needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
      Amount pair = mounting;
      pair += is_mounted(x) ? Amount{} : priced.change_costs[x];
      pair += is_mounted(y) ? Amount{} : priced.change_costs[y];
      inner += !is_mounted(x) && !is_mounted(y) ? 1U : 0U;
      if (pair > bound) {
        bound = pair;
        plan_.largest_reason =
            fmt::format("a test of {} and {} costs so much", job_->names[x], job_->names[y]);
      }
    });
    constexpr std::uint64_t most_parts = 150;
    if (job_->parts() > most_parts) {
      return;
    }
    try {
      std::uint64_t low = bound.millionths;
      for (std::uint64_t high = std::max(low, plan_.bound.cost.millionths); low < high;) {
        const std::uint64_t middle = low + (high - low) / 2;
        most_pairs_within(priced, Amount{middle}) >= ceil_div(inner, n) ? high = middle
                                                                        : low = middle + 1;
      }
      if (const Amount counted = rounded_up(*job_, Amount{low}); counted > bound) {
        bound = counted;
        plan_.largest_reason = fmt::format(
            "for less, no bench can test {} pairs, the {} part of {}", ceil_div(inner, n),
            n == 2   ? "second"
            : n == 3 ? "third"
                     : fmt::format("{}th", n),
            inner);
      }
    } catch (const Stopped&) {
      // What is known is true.
    }
  }

  void search(std::vector<BenchLists> starts) {
    const Weights weights = weights_of(*job_, job_->needed.size() + job_->triples.size() + 64);
    {
      Lists lists(*job_, weights, starts.front());
      prune(lists, *control_);
      add("one list, cut and shortened", "without what other benches test anyway", lists.lists());
      add("each bench anew", "cut, and each bench planned anew for what only it tests",
          each_anew(lists.lists()));
    }
    Lists from_nothing(*job_, weights, BenchLists(starts.front().size()));
    if (complete(from_nothing, *control_)) {
      starts.push_back(from_nothing.lists());
    }
    starts.push_back(best().lists);
    std::rotate(starts.begin(), starts.end() - 1, starts.end());
    ListsSearch search{.aim = by_cost() ? Aim::least_cost : Aim::least_largest,
                       .steps = options_->plan.steps,
                       .attempts = options_->plan.attempts,
                       .phase = "local search between benches"};
    while (!is_best_possible() && !control_->stop_wanted()) {
      FoundLists found = search_lists(*job_, weights, starts, search, *control_);
      plan_.steps += found.steps;
      add("local search between benches", "tests and parts moved between benches", found.lists);
      if (!control_->stop_wanted()) {
        found.lists = each_anew(found.lists);
        add("local search, each bench anew", "then each bench planned anew for what only it tests",
            found.lists);
      }
      ++search.round;
      if (!options_->plan.until_stopped) {
        break;
      }
      starts.front() = best().lists;
    }
  }

  // Each bench gets the cheapest list for what no other tests, one after the other.
  BenchLists each_anew(BenchLists lists) {
    for (std::size_t bench = 0; bench < lists.size() && !control_->stop_wanted(); ++bench) {
      const Job own = only_on(*job_, lists, bench);
      if (own.needed.size() == 0) {
        lists[bench].clear();
        continue;
      }
      constexpr std::uint64_t short_search = 200'000;
      PlanOptions options{.steps = options_->plan.steps == 0
                                       ? short_search
                                       : std::min(short_search, options_->plan.steps),
                          .attempts = 2,
                          .rest = lists[bench],
                          .design_moves = 0,
                          .states = 20'000};
      const RunPlan anew = plan_of_valid_job(own, options, *control_);
      plan_.steps += anew.steps;
      lists[bench] = anew.candidates.front().setups;
    }
    return lists;
  }

  const Job* job_;
  const BenchOptions* options_;
  RunControl* control_;
  BenchPlan plan_;
};

}  // namespace

BenchCount count_benches(const Job& job, const std::vector<std::vector<Block>>& lists) {
  BenchCount count;
  count.pairs_needed = job.needed.size();
  count.triples_needed = job.triples.size();
  Job left = job;
  left.start.clear();
  left.tests_done = 0;
  for (std::size_t bench = 0; bench < lists.size(); ++bench) {
    RunSheet sheet = run_sheet(left, lists[bench]);
    PairSet met(job.parts());
    for (const RunStep& step : sheet.steps) {
      for (const auto& [x, y] : step.new_pairs) {
        met.insert(x, y);
      }
      for (const Triple& t : step.new_triples) {
        left.triples.erase(std::find(left.triples.begin(), left.triples.end(), t));
      }
    }
    drop_needed(left, met);
    for (const std::string& fault : sheet.faults) {
      count.faults.push_back(fmt::format("bench {}: {}", bench + 1, fault));
    }
    count.tests += sheet.steps.size();
    count.changes += sheet.changes;
    count.cost += sheet.cost;
    count.largest = std::max(count.largest, sheet.cost);
    count.pairs_tested += sheet.pairs_tested;
    count.triples_tested += sheet.triples_tested;
    count.sheets.push_back(std::move(sheet));
  }
  return count;
}

namespace {

void check(const Job& job, const BenchOptions& options) {
  if (options.benches == 0 || options.benches > max_benches) {
    throw BadInput(fmt::format("{} benches; give 1 to {}", options.benches, max_benches));
  }
  if (!job.start.empty() || !job.first.empty() || job.tests_done > 0 || options.plan.budget ||
      !options.plan.rest.empty()) {
    throw BadInput(
        "plans for several benches begin with empty benches, without a budget and tests that are done "
        "or come first");
  }
  if (!job.weights.empty()) {
    throw BadInput("pairs are not weighed in plans for several benches");
  }
}

}  // namespace

BenchPlan make_bench_plan(const CheckedJob& job, const BenchOptions& options, RunControl& control) {
  check(*job, options);
  return BenchPlanner(*job, options, control).run();
}

BenchPlan make_bench_plan(const Job& job, const BenchOptions& options, RunControl& control) {
  check(job, options);
  check_in_full(job);
  return BenchPlanner(job, options, control).run();
}

}  // namespace changeover
