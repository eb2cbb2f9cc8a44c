// Verification against a loop that only sets the same bits: what is the price of reading blocks,
// finding what changed and checking it, over the memory traffic that cannot be avoided?
#include <benchmark/benchmark.h>

#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/verify/verdict.hpp"
#include "paired.hpp"

namespace changeover::bench {
namespace {

Design best_design(std::uint64_t v, std::uint64_t k) {
  const Registry& registry = Registry::standard();
  return registry.build_design(
      registry.best({.v = v, .k = k, .kind = Kind::circular}).value().recipe);
}

void verify_against_bits(benchmark::State& state) {
  const Design design = best_design(static_cast<std::uint64_t>(state.range(0)),
                                    static_cast<std::uint64_t>(state.range(1)));
  const auto k = static_cast<std::size_t>(design.k());
  const auto m = static_cast<std::size_t>(design.parameters().change);
  // Each block with its introduced elements last, so that the peer only has to set bits.
  std::vector<Element> arranged;
  DesignSource source(design);
  for (Transitions steps(source); steps.next();) {
    const Block kept = difference(steps.block(), steps.introduced());
    arranged.insert(arranged.end(), kept.begin(), kept.end());
    arranged.insert(arranged.end(), steps.introduced().begin(), steps.introduced().end());
  }
  run_paired(
      state,
      [&] {
        PairSet set(design.v());
        for (std::size_t at = 0; at < arranged.size(); at += k) {
          for (std::size_t i = k - m; i < k; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
              set.insert(arranged[at + i], arranged[at + j]);
            }
          }
        }
        benchmark::DoNotOptimize(set.size());
      },
      [&] { benchmark::DoNotOptimize(verify(design).b); });
  state.counters["blocks"] = static_cast<double>(design.block_count());
}

BENCHMARK(verify_against_bits)
    ->ArgNames({"v", "k"})
    ->Args({253, 13})    // the paper's largest: an expanded design
    ->Args({991, 51})    // v ≈ 10³, large blocks
    ->Args({1001, 4})    // v ≈ 10³, small blocks
    ->Args({9991, 501})  // v ≈ 10⁴
    ->Args({10001, 4})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace changeover::bench
