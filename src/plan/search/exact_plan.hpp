// Searches a small job exhaustively: finds its cheapest list, or proves that none is cheaper.
//
// A* over states (the mounted set-up, the pairs met), cheapest first, with a lower bound on the
// remaining cost. States that differ by exchanging interchangeable parts are merged. Without
// forbidden pairs and slots only full set-ups are considered: a set-up with room can take parts of
// its neighbours without a further introduction.
//
// The lower bound: if r pairs are left, t steps with i introductions meet at most the number in (1)
// of docs/theorems.md, Theorem 23. Every part outside with a pair left is introduced once; each
// further introduction costs at least as much as the cheapest part with a pair left. A part meets
// at most K − 1 parts when it is introduced, and the j introduced ones when it stays, so
// introductions have to make up for the rest, as in (6) there.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/plan/job.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

struct ExactPlan {
  std::optional<std::vector<Block>> setups;  ///< the cheapest list, if it costs less than `below`
  Amount bound;                              ///< lower bound on the cost of every list
  std::uint64_t states = 0;                  ///< number of states examined
};

/// Whether a job is small enough for exact_plan(): at most 12 parts with pairs to test and 64
/// pairs.
[[nodiscard]] bool is_small(const Job& job);

/// Searches for a list cheaper than `below`, the cost of a known list, until it is known whether
/// there is one, or `most_states` states are stored, or the control requests a stop; `bound` is
/// valid in any case. For a job that is_small() and has no defects.
[[nodiscard]] ExactPlan exact_plan(const Job& job, Amount below, std::uint64_t most_states,
                                   RunControl& control);

/// Takes the bound of an exhaustive search into a plan, and returns the list that was found.
[[nodiscard]] std::optional<Start> take_exact(RunPlan& plan, ExactPlan exact);

}  // namespace changeover
