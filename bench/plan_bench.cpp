// What run sheets cost after some seconds of processor time, ours and those of a plain annealer
// (plan_peer.hpp), one thread each.
#include <benchmark/benchmark.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "changeover/plan/model.hpp"
#include "changeover/plan/run_plan.hpp"
#include "plan_jobs.hpp"
#include "plan_peer.hpp"

std::atomic<bool> changeover::bench::clock_of_processor = false;

// While the library plans, its clock is the processor time of this program, so that other work on
// the machine takes nothing from it. It stands for the one of the C library, from which
// std::chrono::steady_clock has its time.
extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
  const bool other = clock == CLOCK_MONOTONIC &&
                     changeover::bench::clock_of_processor.load(std::memory_order_relaxed);
  return static_cast<int>(
      syscall(SYS_clock_gettime, other ? CLOCK_PROCESS_CPUTIME_ID : clock, now));
}

namespace changeover::bench {
namespace {

double seconds_of_processor() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double in_units(Amount amount) { return static_cast<double>(amount.millionths) / 1e6; }

// Ours has so many seconds, CHANGEOVER_BENCH_SECONDS or 10; the peer then has what ours used.
void plan_against_plain_annealing(benchmark::State& state) {
  const Job job =
      priced_job(static_cast<std::uint64_t>(state.range(0)),
                 static_cast<std::uint64_t>(state.range(1)), std::to_string(state.range(2)), 1);
  const char* const given = std::getenv("CHANGEOVER_BENCH_SECONDS");
  const double seconds = given == nullptr ? 10.0 : std::atof(given);
  const auto seed = static_cast<std::uint64_t>(state.range(3));
  for (auto _ : state) {
    const double before = seconds_of_processor();
    clock_of_processor = true;
    RunControl control({.time = std::chrono::duration<double>(seconds), .seed = seed});
    const RunPlan ours = make_run_plan(job, {.until_stopped = true}, control);
    clock_of_processor = false;
    const double used = seconds_of_processor() - before;
    std::vector<double> prices;
    for (const Amount cost : job.change_costs) {
      prices.push_back(in_units(cost));
    }
    const PlainPlan plain = anneal_plainly(prices, static_cast<std::size_t>(job.room()),
                                           in_units(job.test_cost), used, seed);
    const RunSheet peer = run_sheet(job, {plain.setups.begin(), plain.setups.end()});
    if (!peer.does_the_job() || !ours.sheet.does_the_job()) {
      state.SkipWithError("a list does not do the job");
      return;
    }
    state.counters["bound"] = in_units(ours.bound.cost);
    state.counters["ours"] = in_units(ours.sheet.cost);
    state.counters["peer"] = in_units(peer.cost);
    state.counters["ratio"] = in_units(peer.cost) / in_units(ours.sheet.cost);
    state.counters["cpu_s"] = used;
  }
}

// Jobs with slots against what no plan can undercut.
void plan_within_slots(benchmark::State& state) {
  const Job job = slotted_job(static_cast<std::uint64_t>(state.range(0)));
  const char* const given = std::getenv("CHANGEOVER_BENCH_SECONDS");
  const double seconds = given == nullptr ? 10.0 : std::atof(given);
  for (auto _ : state) {
    clock_of_processor = true;
    RunControl control({.time = std::chrono::duration<double>(seconds), .threads = 1});
    const RunPlan plan = make_run_plan(job, {}, control);
    clock_of_processor = false;
    if (!plan.sheet.does_the_job()) {
      state.SkipWithError("the list does not do the job");
      return;
    }
    state.counters["parts"] = static_cast<double>(job.parts());
    state.counters["slots"] = static_cast<double>(job.slots.size());
    state.counters["bound"] = in_units(plan.bound.cost);
    state.counters["cost"] = in_units(plan.sheet.cost);
    state.counters["over_%"] =
        100.0 * (in_units(plan.sheet.cost) / in_units(plan.bound.cost) - 1.0);
  }
}

// Models without rules: numbers of values, each with how many parameters have so many; a test cost.
struct BareModel {
  const char* name;
  std::vector<std::array<int, 2>> parameters;
  const char* test_cost;
};

const std::vector<BareModel>& bare_models() {
  static const std::vector<BareModel> all{
      {"3^12", {{3, 12}}, "1"},
      {"3^12", {{3, 12}}, "5"},
      {"3^13", {{3, 13}}, "5"},
      {"3^40", {{3, 40}}, "5"},
      {"2^40", {{2, 40}}, "5"},
      {"4^20", {{4, 20}}, "2"},
      {"4^5 3^10 2^15", {{4, 5}, {3, 10}, {2, 15}}, "1"},
      {"4^1 3^39 2^35", {{4, 1}, {3, 39}, {2, 35}}, "5"},
      {"4^15 3^17 2^29", {{4, 15}, {3, 17}, {2, 29}}, "5"},
      {"5^6 4^6 3^6", {{5, 6}, {4, 6}, {3, 6}}, "3"},
      {"10^4 2^20", {{10, 4}, {2, 20}}, "2"},
      {"6^3 5^5 3^8 2^8", {{6, 3}, {5, 5}, {3, 8}, {2, 8}}, "10"},
  };
  return all;
}

Job job_of(const BareModel& model) {
  std::string text;
  int parameter = 0;
  for (const auto& [values, times] : model.parameters) {
    for (int i = 0; i < times; ++i, ++parameter) {
      text += "P" + std::to_string(parameter) + ":";
      for (int value = 0; value < values; ++value) {
        text += (value == 0 ? " v" : ", v") + std::to_string(value);
      }
      text += '\n';
    }
  }
  return job_of(read_model(*input_from_text(text, model.name)), parse_amount(model.test_cost),
                parse_amount("1"));
}

// Models, each change at 1, against what no plan can undercut: as with --time.
void plan_of_models(benchmark::State& state) {
  const BareModel& model = bare_models().at(static_cast<std::size_t>(state.range(0)));
  const Job job = job_of(model);
  const char* const given = std::getenv("CHANGEOVER_BENCH_SECONDS");
  const double seconds = given == nullptr ? 10.0 : std::atof(given);
  for (auto _ : state) {
    clock_of_processor = true;
    RunControl control({.time = std::chrono::duration<double>(seconds),
                        .threads = 1,
                        .seed = static_cast<std::uint64_t>(state.range(1))});
    const RunPlan plan = make_run_plan(job, {.until_stopped = true}, control);
    clock_of_processor = false;
    if (!plan.sheet.does_the_job()) {
      state.SkipWithError("the list does not do the job");
      return;
    }
    state.SetLabel(std::string(model.name) + ", a test " + model.test_cost);
    state.counters["tests"] = static_cast<double>(plan.sheet.steps.size());
    state.counters["bound"] = in_units(plan.bound.cost);
    state.counters["cost"] = in_units(plan.sheet.cost);
    state.counters["over_%"] =
        100.0 * (in_units(plan.sheet.cost) / in_units(plan.bound.cost) - 1.0);
  }
}

// Each model with seed 1.
void models(benchmark::internal::Benchmark* bench) {
  for (std::size_t i = 0; i < bare_models().size(); ++i) {
    bench->Args({static_cast<std::int64_t>(i), 1});
  }
}

// Parts, room, test cost, seed of both searches.
void jobs(benchmark::internal::Benchmark* bench) {
  for (const auto& [parts, room, test] : {std::array<std::int64_t, 3>{20, 4, 5},
                                          {30, 5, 2},
                                          {30, 5, 40},
                                          {40, 6, 10},
                                          {60, 8, 2},
                                          {60, 8, 40},
                                          {100, 10, 5},
                                          {120, 12, 5},
                                          {200, 12, 5}}) {
    for (std::int64_t seed = 1; seed <= 5; ++seed) {
      bench->Args({parts, room, test, seed});
    }
  }
}

BENCHMARK(plan_within_slots)
    ->ArgName("seed")
    ->DenseRange(1, 24)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

BENCHMARK(plan_of_models)
    ->ArgNames({"model", "seed"})
    ->Apply(models)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

BENCHMARK(plan_against_plain_annealing)
    ->ArgNames({"parts", "room", "test", "seed"})
    ->Apply(jobs)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace changeover::bench
