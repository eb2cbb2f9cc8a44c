// The cheapest list of set-ups of a small job, or a proof that none is cheaper: all of them are
// looked at.
//
// A* over states (set-up on the bench, pairs met), the cheapest first, with a lower bound on what
// the rest costs. States that differ by exchanging parts that nothing tells apart are one. Without
// forbidden pairs and slots only full set-ups are looked at: a set-up with room takes parts of its
// neighbours without any introduction more.
//
// What the rest costs at least: if r pairs are left, t steps with i introductions meet at most the
// r of (1) in plan/run_plan.hpp; every part outside that has a pair left comes once, and each
// further introduction costs at least what the cheapest part with a pair left does; and where it
// meets at most K − 1 parts when it comes, and the j that come when it stays, introductions have to
// make up for the rest, as in (6) there.
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
  std::optional<std::vector<Block>> setups;  ///< one that costs less than `below`, and the least
  Amount bound;                              ///< no list costs less
  std::uint64_t states = 0;                  ///< that were looked at
};

/// Whether a job is so small that exact_plan() may end: at most 12 parts with pairs to test and 64
/// pairs.
[[nodiscard]] bool is_small(const Job& job);

/// Looks for a list that is cheaper than `below`, which some list costs, until it is known whether
/// there is one, or until so many states are known or the control says stop; `bound` is true in any
/// case. For a job that is_small() and has no defects.
[[nodiscard]] ExactPlan exact_plan(const Job& job, Amount below, std::uint64_t most_states,
                                   RunControl& control);

/// Raises the bound of a plan to that of a look at all lists, and returns the list that was found.
[[nodiscard]] std::optional<Start> take_exact(RunPlan& plan, ExactPlan exact);

}  // namespace changeover
