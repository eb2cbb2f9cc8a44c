// When the tests of a job are done on several benches after some seconds of processor time, against
// what no plan can undercut.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "changeover/plan/benches.hpp"
#include "plan_jobs.hpp"

namespace changeover::bench {
namespace {

double in_hours(Amount amount) { return static_cast<double>(amount.millionths) / 1e6; }

double seconds_given() {
  const char* const given = std::getenv("CHANGEOVER_BENCH_SECONDS");
  return given == nullptr ? 10.0 : std::atof(given);
}

void count_plan(benchmark::State& state, const Job& job, const std::vector<Bench>& benches) {
  for (auto _ : state) {
    clock_of_processor = true;
    RunControl control({.time = std::chrono::duration<double>(seconds_given()), .threads = 1});
    const BenchPlan plan =
        make_bench_plan(job, {.plan = {.until_stopped = true}, .each = benches}, control);
    clock_of_processor = false;
    if (!plan.does_the_job()) {
      state.SkipWithError("the lists do not do the job");
      return;
    }
    state.counters["makespan"] = in_hours(plan.makespan);
    state.counters["bound"] = in_hours(plan.makespan_bound);
    state.counters["over_%"] =
        100.0 * (in_hours(plan.makespan) / in_hours(plan.makespan_bound) - 1.0);
    state.counters["together"] = in_hours(plan.cost);
  }
}

// All benches have every part.
void plan_on_benches(benchmark::State& state) {
  const Job job =
      priced_job(static_cast<std::uint64_t>(state.range(0)),
                 static_cast<std::uint64_t>(state.range(1)), std::to_string(state.range(2)), 1);
  count_plan(state, job, std::vector<Bench>(static_cast<std::size_t>(state.range(3))));
}

// There is one of each of the most expensive parts; the argument says of how many.
void plan_on_benches_with_stock(benchmark::State& state) {
  Job job =
      priced_job(static_cast<std::uint64_t>(state.range(0)),
                 static_cast<std::uint64_t>(state.range(1)), std::to_string(state.range(2)), 1);
  std::vector<Amount> prices = job.change_costs;
  std::sort(prices.begin(), prices.end());
  const Amount costly = prices[prices.size() - static_cast<std::size_t>(state.range(4))];
  for (const Amount price : job.change_costs) {
    job.quantities.push_back(price < costly ? enough_for_all : 1);
  }
  count_plan(state, job, std::vector<Bench>(static_cast<std::size_t>(state.range(3))));
}

void plan_on_held_out_benches(benchmark::State& state) {
  const HeldOutJob made = held_out_job(static_cast<std::uint64_t>(state.range(0)));
  count_plan(state, made.job, std::vector<Bench>(made.benches));
  state.counters["parts"] = static_cast<double>(made.job.parts());
  state.counters["room"] = static_cast<double>(made.job.room());
  state.counters["test"] = in_hours(made.job.test_cost);
  state.counters["slots"] = static_cast<double>(made.job.slots.size());
  state.counters["never"] = static_cast<double>(made.job.never.size());
  state.counters["benches"] = made.benches;
  state.counters["scarce"] = static_cast<double>(made.scarce);
}

constexpr std::array<std::array<std::int64_t, 3>, 6> sizes{
    {{20, 4, 5}, {30, 5, 2}, {30, 5, 40}, {40, 6, 10}, {60, 8, 2}, {60, 8, 40}}};

void jobs_on_benches(benchmark::internal::Benchmark* bench) {
  for (const auto& [parts, room, test] : sizes) {
    for (const std::int64_t benches : {2, 3}) {
      bench->Args({parts, room, test, benches});
    }
  }
}

void jobs_with_stock(benchmark::internal::Benchmark* bench) {
  for (const auto& [parts, room, test] : sizes) {
    for (const std::int64_t scarce : {5, 15}) {
      bench->Args({parts, room, test, 3, scarce});
    }
  }
}

BENCHMARK(plan_on_benches)
    ->ArgNames({"parts", "room", "test", "benches"})
    ->Apply(jobs_on_benches)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

BENCHMARK(plan_on_benches_with_stock)
    ->ArgNames({"parts", "room", "test", "benches", "scarce"})
    ->Apply(jobs_with_stock)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

BENCHMARK(plan_on_held_out_benches)
    ->ArgName("job")
    ->DenseRange(1, 12)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace changeover::bench
