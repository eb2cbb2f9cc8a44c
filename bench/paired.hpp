// Timing two ways of doing a thing in turn, so that their ratio holds on a noisy machine.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace changeover::bench {

/// Runs `peer` and `ours` in turn as long as the state asks, and reports the median of peer/ours as
/// the counter `ratio` (1: as fast as the peer), with the medians of both in milliseconds.
template <typename Peer, typename Ours>
void run_paired(benchmark::State& state, Peer&& peer, Ours&& ours) {
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::duration<double, std::milli>;
  std::vector<double> peers;
  std::vector<double> mine;
  std::vector<double> ratios;
  for (auto _ : state) {
    const auto start = Clock::now();
    peer();
    const auto middle = Clock::now();
    ours();
    const auto end = Clock::now();
    peers.push_back(Milliseconds(middle - start).count());
    mine.push_back(Milliseconds(end - middle).count());
    ratios.push_back(peers.back() / mine.back());
  }
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  state.counters["peer_ms"] = median(peers);
  state.counters["ours_ms"] = median(mine);
  state.counters["ratio"] = median(ratios);
}

}  // namespace changeover::bench
