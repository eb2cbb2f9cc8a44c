#include "plan/search/choices/transport.hpp"

#include <algorithm>
#include <limits>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

__extension__ using Profit = __int128;

}  // namespace

std::uint64_t most_profit(const std::vector<std::vector<std::uint64_t>>& profit,
                          const std::vector<std::uint64_t>& room) {
  const std::size_t n = room.size();
  constexpr Profit far = std::numeric_limits<std::int64_t>::max();
  std::vector<std::uint64_t> supply = room;
  std::vector<std::uint64_t> demand = room;
  std::vector<std::vector<std::uint64_t>> carried(n, std::vector<std::uint64_t>(n, 0));
  Profit total = 0;
  // Each round increases the flow along the path from a source to a drain with the largest profit,
  // also over reversed edges. The profit per round decreases, and the rounds end when it is 0.
  RunControl* const control = RunScope::current();
  while (control == nullptr || !control->stop_wanted()) {
    // The largest profit of a path to a source, and to a drain.
    std::vector<Profit> at_source(n, -far);
    std::vector<Profit> at_drain(n, -far);
    std::vector<std::size_t> to_source(n, n);  // the drain before it
    std::vector<std::size_t> to_drain(n, n);   // the source before it
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < n; ++i) {
      if (supply[i] > 0) {
        at_source[i] = 0;
        changed.push_back(i);
      }
    }
    while (!changed.empty()) {
      std::vector<bool> better(n, false);
      for (const std::size_t i : changed) {
        for (std::size_t j = 0; j < n; ++j) {
          const Profit there = at_source[i] + static_cast<Profit>(profit[i][j]);
          if (profit[i][j] > 0 && there > at_drain[j]) {
            at_drain[j] = there;
            to_drain[j] = i;
            better[j] = true;
          }
        }
      }
      std::vector<bool> moved(n, false);
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; better[j] && i < n; ++i) {
          if (carried[i][j] > 0 && at_drain[j] - static_cast<Profit>(profit[i][j]) > at_source[i]) {
            at_source[i] = at_drain[j] - static_cast<Profit>(profit[i][j]);
            to_source[i] = j;
            moved[i] = true;
          }
        }
      }
      changed.clear();
      for (std::size_t i = 0; i < n; ++i) {
        if (moved[i]) {
          changed.push_back(i);
        }
      }
    }
    std::size_t best = n;
    for (std::size_t j = 0; j < n; ++j) {
      if (demand[j] > 0 && at_drain[j] > 0 && (best == n || at_drain[j] > at_drain[best])) {
        best = j;
      }
    }
    if (best == n) {
      break;
    }
    std::uint64_t amount = demand[best];
    std::size_t source = to_drain[best];
    while (to_source[source] != n) {
      const std::size_t drain = to_source[source];
      amount = std::min(amount, carried[source][drain]);
      source = to_drain[drain];
    }
    amount = std::min(amount, supply[source]);
    supply[source] -= amount;
    demand[best] -= amount;
    total = std::min(far, total + at_drain[best] * static_cast<Profit>(amount));
    for (std::size_t drain = best;;) {
      const std::size_t from = to_drain[drain];
      carried[from][drain] += amount;
      if (to_source[from] == n) {
        break;
      }
      drain = to_source[from];
      carried[from][drain] -= amount;
    }
  }
  return static_cast<std::uint64_t>(total);
}

}  // namespace changeover
