// Load orders against BETA, hold-and-stream, square tiles and exhaustive matching: loads, the
// executor on a file whose pages are kept out of the cache, and reading alone: what the sequence of
// the items is worth. For listed pairs, orders of closing items as they are in the literature
// against what search makes of the best.
//
// CHANGEOVER_BENCH_SEARCH=20 gives local search so many seconds for each order that is not minimum.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "all_pairs/load_orders.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/pairs/starts.hpp"
#include "run/random.hpp"

namespace changeover::bench {
namespace {

LoadOrder best_order(std::uint64_t items, std::uint64_t room) {
  LoadOrderOptions options;
  std::optional<RunControl> control;
  if (const char* seconds = std::getenv("CHANGEOVER_BENCH_SEARCH")) {
    RunControl::Settings settings;
    settings.time = std::chrono::duration<double>(std::strtod(seconds, nullptr));
    control.emplace(settings);
    options.improve = improve_by_search(*control);
  }
  return plan_load_order(items, room, options);
}

/// Loads of every method and of the bound, and how much better than the best of them all ours is.
void loads(benchmark::State& state) {
  const auto items = static_cast<std::uint64_t>(state.range(0));
  const auto room = static_cast<std::uint64_t>(state.range(1));
  std::optional<LoadOrder> ours;
  for (auto _ : state) {
    ours.emplace(best_order(items, room));
  }
  const auto mine = static_cast<double>(ours->facts().loads);
  state.counters["ours"] = mine;
  state.counters["bound"] = static_cast<double>(ours->facts().bound.loads);
  state.counters["gap_percent"] = 100 * ours->facts().gap();
  if (items % room == 0 && room % 2 == 0 && room > 2) {
    state.counters["comet"] = static_cast<double>(comet_order(items, room, 2).facts().loads);
    state.counters["comet_two_groups"] =
        static_cast<double>(comet_order(items, room, room / 2).facts().loads);
  }
  double best = 0;
  for (const LoadOrder& other : baseline_orders(items, room)) {
    const auto count = static_cast<double>(other.facts().loads);
    state.counters[other.facts().method] = count;
    best = best == 0 ? count : std::min(best, count);
  }
  state.counters["ratio"] = best / mine;  // of the best peer to ours
  state.SetLabel(ours->facts().method);
}

/// A file of random bytes, made once for all benchmarks and removed at the end.
class DataFile {
 public:
  static const DataFile& of(std::uint64_t items, std::uint64_t bytes) {
    static std::map<std::pair<std::uint64_t, std::uint64_t>, std::unique_ptr<DataFile>> files;
    auto& file = files[{items, bytes}];
    if (!file) {
      file.reset(new DataFile(items, bytes));
    }
    return *file;
  }
  ~DataFile() { std::filesystem::remove(path_); }
  DataFile(const DataFile&) = delete;
  DataFile& operator=(const DataFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  DataFile(std::uint64_t items, std::uint64_t bytes)
      : path_((std::filesystem::temp_directory_path() /
               ("changeover-bench-" + std::to_string(::getpid()) + "-" + std::to_string(items) +
                "-" + std::to_string(bytes)))
                  .string()) {
    const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<std::uint64_t> item(static_cast<std::size_t>(bytes / sizeof(std::uint64_t)));
    Random random(items);
    for (std::uint64_t i = 0; i < items; ++i) {
      for (std::uint64_t& word : item) {
        word = random.next();
      }
      if (::write(file, item.data(), static_cast<std::size_t>(bytes)) < 0) {
        std::abort();
      }
    }
    ::fsync(file);
    ::close(file);
  }

  std::string path_;
};

/// The whole job with little to compute, so that loading is what takes the time: all methods in
/// turn, medians.
void executor(benchmark::State& state) {
  constexpr std::uint64_t bytes = std::uint64_t{4} << 20;
  const auto items = static_cast<std::uint64_t>(state.range(0));
  const auto room = static_cast<std::uint64_t>(state.range(1));
  FileItems file(DataFile::of(items, bytes).path(), bytes, {.bypass_cache = true});
  std::vector<LoadOrder> orders = baseline_orders(items, room);
  orders.insert(orders.begin(), plan_load_order(items, room));
  std::vector<std::vector<double>> seconds(orders.size());
  std::vector<AllPairsReport> reports(orders.size());
  std::atomic<std::uint64_t> sum = 0;
  std::size_t turn = 0;  // each method comes first as often as any other
  for (auto _ : state) {
    ++turn;
    for (std::size_t k = 0; k < orders.size(); ++k) {
      const std::size_t i = (k + turn) % orders.size();
      reports[i] = all_pairs(file, orders[i], [&](const PairWork& work) {
        sum += std::to_integer<std::uint64_t>(work.first.bytes[0] ^ work.second.bytes[0]);
      });
      seconds[i].push_back(reports[i].elapsed.count());
    }
  }
  benchmark::DoNotOptimize(sum.load());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const std::string name = i == 0 ? "ours" : orders[i].facts().method;
    const auto middle = seconds[i].begin() + static_cast<std::ptrdiff_t>(seconds[i].size() / 2);
    std::nth_element(seconds[i].begin(), middle, seconds[i].end());
    state.counters[name + "_s"] = *middle;
    state.counters[name + "_GB"] = static_cast<double>(reports[i].bytes_read) / 1e9;
  }
  state.SetLabel(file.access());
}

/// The items of an order as they are loaded.
std::vector<Element> sequence_of(const LoadOrder& order) {
  std::vector<Element> items;
  const auto steps = order.stream();
  for (Step step; steps->next(step);) {
    items.insert(items.end(), step.load.begin(), step.load.end());
  }
  return items;
}

/// As many items of the same size as our order loads, read one by one without anything else, in
/// different sequences: front to back again and again, as BETA begins, as ours, ours with the items
/// renamed at random, and at random. All in turn, medians, in MB/s.
void reading(benchmark::State& state) {
  const auto items = static_cast<std::uint64_t>(state.range(0));
  const auto room = static_cast<std::uint64_t>(state.range(1));
  const auto bytes = static_cast<std::uint64_t>(state.range(2)) << 10;
  FileItems file(DataFile::of(items, bytes).path(), bytes, {.bypass_cache = true});
  LoadOrderOptions options;
  options.constructions = options.closure_rules = state.range(3) == 0;
  const LoadOrder order = plan_load_order(items, room, options);
  const std::vector<Element> ours = sequence_of(order);
  Random random(items);
  std::vector<Element> names(static_cast<std::size_t>(items));
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = static_cast<Element>(i);
    std::swap(names[i], names[random.below(static_cast<std::uint32_t>(i + 1))]);
  }
  std::map<std::string, std::vector<Element>> sequences{{"ours", ours}};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    sequences["front_to_back"].push_back(static_cast<Element>(i % items));
    sequences["renamed"].push_back(names[ours[i]]);
    sequences["random"].push_back(random.below(static_cast<std::uint32_t>(items)));
  }
  std::vector<Element>& beta = sequences["beta"] = sequence_of(beta_order(items, room));
  beta.resize(std::min(beta.size(), ours.size()));
  // One buffer of the alignment that direct reads need.
  std::vector<std::byte> memory(file.buffer_bytes() + buffer_alignment);
  const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
  const std::size_t skip = (buffer_alignment - address % buffer_alignment) % buffer_alignment;
  const auto buffer = std::span(memory).subspan(skip, file.buffer_bytes());
  std::map<std::string, std::vector<double>> rates;
  for (auto _ : state) {
    for (const auto& [name, sequence] : sequences) {
      const auto begin = std::chrono::steady_clock::now();
      for (const Element item : sequence) {
        benchmark::DoNotOptimize(file.read(item, buffer).data());
      }
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
      rates[name].push_back(static_cast<double>(sequence.size() * bytes) / 1e6 / elapsed.count());
    }
  }
  for (auto& [name, rate] : rates) {
    const auto middle = rate.begin() + static_cast<std::ptrdiff_t>(rate.size() / 2);
    std::nth_element(rate.begin(), middle, rate.end());
    state.counters[name] = *middle;
  }
  state.SetLabel(order.facts().method + ", " + file.access());
}

/// The pairs of random points of a square that are closer than a radius that leaves about so many.
std::shared_ptr<const PairGraph> close_points(std::uint32_t items, double pairs) {
  Random random(items);
  const auto unit = [&] { return static_cast<double>(random.next32()) / 4294967296.0; };
  constexpr double pi = 3.14159265358979;
  const double radius = std::sqrt(2 * pairs / (pi * items * items));
  const auto cells = static_cast<std::size_t>(1 / radius);
  std::vector<std::pair<double, double>> points(items);
  std::vector<std::vector<Element>> grid(cells * cells);
  const auto cell = [&](double at) {
    return std::min(cells - 1, static_cast<std::size_t>(at * static_cast<double>(cells)));
  };
  std::vector<ItemPair> close;
  for (Element i = 0; i < items; ++i) {
    points[i] = {unit(), unit()};
    const auto [x, y] = points[i];
    for (std::size_t cx = std::max<std::size_t>(cell(x), 1) - 1; cx < std::min(cells, cell(x) + 2);
         ++cx) {
      for (std::size_t cy = std::max<std::size_t>(cell(y), 1) - 1;
           cy < std::min(cells, cell(y) + 2); ++cy) {
        for (const Element j : grid[cx * cells + cy]) {
          if (std::hypot(points[j].first - x, points[j].second - y) < radius) {
            close.emplace_back(j, i);
          }
        }
      }
    }
    grid[cell(x) * cells + cell(y)].push_back(i);
  }
  return std::make_shared<const PairGraph>(items, close);
}

/// Loads for listed pairs: every start as it is, and ours, which is the time of this.
void listed(benchmark::State& state) {
  const auto graph =
      close_points(static_cast<std::uint32_t>(state.range(0)), static_cast<double>(state.range(1)));
  const auto room = static_cast<std::uint64_t>(state.range(2));
  const WantedPairs wanted = WantedPairs::listed(graph);
  std::uint64_t loads = 0;
  for (auto _ : state) {
    const LoadOrder order = plan_load_order(wanted, room);
    loads = order.facts().loads;
    state.counters["bound"] = static_cast<double>(order.facts().bound.loads);
  }
  state.counters["ours"] = static_cast<double>(loads);
  state.counters["pairs"] = static_cast<double>(graph->pairs());
  each_start(*graph, room, [&](const std::string& name, const std::vector<Element>& order) {
    state.counters[name] = static_cast<double>(Closing(*graph, room, order).run());
    return true;
  });
}

/// Training with room for 4 partitions on one machine, or at each of some workers: all loads of an
/// epoch, those of each other epoch, and what COVER and BETA load in every epoch.
void training(benchmark::State& state) {
  const auto items = static_cast<std::uint64_t>(state.range(0));
  const auto workers = static_cast<std::uint64_t>(state.range(1));
  constexpr std::uint64_t room = 4;
  std::optional<LoadOrder> ours;
  for (auto _ : state) {
    ours.emplace(repeat_order(
        workers == 1 ? plan_load_order(items, room) : plan_disjoint_order(items, room, workers),
        2));
  }
  state.counters["first"] = static_cast<double>(ours->facts().epoch_loads[0]);
  state.counters["other"] = static_cast<double>(ours->facts().epoch_loads[1]);
  const LoadOrder cover = cover_order(items);
  if (!check_schedule(*cover.stream(), cover.rules()).valid()) {
    std::abort();
  }
  state.counters["cover"] = static_cast<double>(cover.facts().loads);
  state.counters["beta"] = static_cast<double>(beta_order(items, room).facts().loads);
  state.SetLabel(ours->facts().method);
}

void partitions(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"items", "workers"})->Iterations(1)->Unit(benchmark::kMillisecond);
  bench->Args({16, 1})->Args({16, 4})->Args({64, 1})->Args({64, 4})->Args({64, 8});
}

void grid(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"items", "room"})->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const auto& [items, room] :
       std::vector<std::pair<std::int64_t, std::int64_t>>{{8, 4},
                                                          {12, 4},
                                                          {15, 4},
                                                          {16, 4},
                                                          {16, 8},
                                                          {20, 5},
                                                          {26, 6},
                                                          {32, 4},
                                                          {32, 8},
                                                          {32, 16},
                                                          {64, 8},
                                                          {64, 16},
                                                          {64, 32},
                                                          {1000, 100},
                                                          {2000, 100}}) {
    bench->Args({items, room});
  }
}

void cells(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"items", "room"})->Iterations(5)->Unit(benchmark::kMillisecond);
  bench->Args({32, 8})->Args({64, 8})->Args({64, 16});
}

// The last argument asks for the streamed order.
void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"items", "room", "KiB", "streamed"})
      ->Iterations(9)
      ->Unit(benchmark::kMillisecond);
  bench->Args({64, 8, 4096, 0})->Args({91, 10, 4096, 1})->Args({91, 10, 256, 1});
  bench->Args({1000, 20, 64, 1});
}

void lists(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"items", "pairs", "room"})->Iterations(1)->Unit(benchmark::kMillisecond);
  bench->Args({120, 563, 10})->Args({10'000, 100'000, 30})->Args({100'000, 1'000'000, 30});
}

BENCHMARK(loads)->Apply(grid);
BENCHMARK(listed)->Apply(lists);
BENCHMARK(training)->Apply(partitions);
BENCHMARK(executor)->Apply(cells);
BENCHMARK(reading)->Apply(sizes);

}  // namespace
}  // namespace changeover::bench
