// Simulated annealing over lists of set-ups with any number of changes a step, under the true cost.
//
//     energy = cost + penalty · (uncovered needed pairs)
// and under a budget
//     energy = cost/4 + 4 · max(0, cost − budget) + penalty · (uncovered needed pairs).
// Under a budget the penalty is fixed, else it is measured (cooling.hpp). Most moves look at one
// step: what it puts in comes one set-up earlier or later in exchange for what it takes out, which
// stays as long. Others put any part, or one of an uncovered pair, in the place of another, in one
// set-up or in a stretch; mount or take out a part; take out a set-up, or insert one like that
// beside it; reverse a stretch, or move one. Deterministic: integers, and floating point with
// + − × ÷ and comparisons only.
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
  double hot = 0.8;  ///< first and last temperature, in about three times what a covered pair costs
  double cold = 0.03;
  /// Of an uncovered pair, under a budget; this and the temperatures are then in the unit of the
  /// weights.
  double penalty = 0;
  /// The schedule ends when this time is up, even if steps are left.
  std::optional<std::chrono::duration<double>> time = {};
  std::optional<std::int64_t> budget = {};
  std::size_t most_tests = 0;  ///< set-ups are not inserted beyond that
  std::string phase = {};      ///< for progress
};

/// The best that an annealing met: all pairs covered, at the least cost; or within the budget, the
/// most pairs, and at the least cost among these.
struct AnnealedPlan {
  std::optional<std::vector<Block>> setups;
  std::int64_t cost = 0;  ///< in weights
  std::size_t uncovered = 0;
  std::uint64_t steps = 0;  ///< moves that were made
};

/// Anneals from the state that is given, which ends wherever it ends.
AnnealedPlan anneal(Sequence& sequence, const Annealing& options, Random& random,
                    RunControl& control);

/// Covers what is uncovered by set-ups where they cost least, then takes away what is not needed.
/// False, with pairs uncovered, if the control says stop before that is done. O(tests · at_once²) a
/// pair.
bool repair(Sequence& sequence, RunControl& control);

/// Takes away set-ups, and parts from whole runs of set-ups, while this leaves no pair uncovered
/// that was covered and costs no more, or until the control says stop.
void prune(Sequence& sequence, RunControl& control);

}  // namespace changeover
