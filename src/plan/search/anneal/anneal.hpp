// Simulated annealing over lists of set-ups with any number of changes per step, under the true
// cost.
//
//     energy = cost + penalty · (uncovered needed pairs)
// and with a budget
//     energy = cost/4 + 4 · max(0, cost − budget) + penalty · (uncovered needed pairs).
// With a budget the penalty is fixed; otherwise it is measured (cooling.hpp). Most moves concern
// one step: a part that it puts in comes one set-up earlier or later, in exchange for a part that
// it takes out, which stays as long. Others put any part, or one of an uncovered pair, in the place
// of another, in one set-up or in a stretch; exchange parts of a slot between two set-ups; mount
// or take out a part; remove a set-up, or insert one similar to its neighbour; reverse or move a
// stretch. Deterministic: integers, and floating point with + − × ÷ and comparisons only.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/run/control.hpp"
#include "plan/search/anneal/sequence.hpp"
#include "run/random.hpp"

namespace changeover {

struct Annealing {
  std::uint64_t steps = 0;
  double hot =
      0.8;  ///< first and last temperature, in about three times the cost of a covered pair
  double cold = 0.03;
  /// The energy of an uncovered pair, with a budget; this and the temperatures are then in the unit
  /// of the weights.
  double penalty = 0;
  /// The schedule ends after this time, even if steps are left.
  std::optional<std::chrono::duration<double>> time = {};
  std::optional<std::int64_t> budget = {};
  std::size_t most_tests = 0;  ///< limit for inserting set-ups
  std::string phase = {};      ///< for progress reports
};

/// The best list of an annealing run: the cheapest that covers all pairs; or, within the budget,
/// the one with most pairs, and the cheapest of these.
struct AnnealedPlan {
  std::optional<std::vector<Block>> setups;
  std::int64_t cost = 0;  ///< in weights
  std::size_t uncovered = 0;
  std::uint64_t steps = 0;  ///< moves made
};

/// Anneals from the given state, which is changed.
AnnealedPlan anneal(Sequence& sequence, const Annealing& options, Random& random,
                    RunControl& control);

/// Covers uncovered pairs by set-ups where they cost least. Returns false, with pairs uncovered, if
/// the control stops it. O(tests · at_once²) per pair.
bool repair(Sequence& sequence, RunControl& control);

}  // namespace changeover
