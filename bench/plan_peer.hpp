// A plain annealer for run sheets, to compare with: what a practitioner writes in an afternoon.
//
// It knows parts with prices, room, and that all pairs must meet, nothing else, and shares no code
// with the library. The state is a list of full set-ups and a counter a pair. It starts from a
// greedy list (always the step with most new pairs for its cost) and cools geometrically. Moves:
// one part of one set-up is replaced by another (any part, one of a set-up beside it, or the
// partner in a pair that has not met); two set-ups change places; a stretch is reversed; a set-up
// is deleted if all its pairs meet elsewhere; one is doubled. A pair that has not met costs a fixed
// amount, which grows threefold in the second half; what has not met in the end gets set-ups of its
// own. The best list in which all met is kept.
#pragma once

#include <cstdint>
#include <vector>

namespace changeover::bench {

struct PlainPlan {
  std::vector<std::vector<std::uint32_t>> setups;
  std::uint64_t moves = 0;
};

/// All pairs of parts 0, 1, … with these prices meet in the list; one thread, for so many seconds
/// of its processor time.
PlainPlan anneal_plainly(const std::vector<double>& prices, std::size_t room, double test_cost,
                         double seconds, std::uint64_t seed);

}  // namespace changeover::bench
