// Lists of set-ups that a search may start from.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/anneal/sequence.hpp"

namespace changeover {

/// A list of set-ups that does the job, and how it came about.
struct Start {
  std::string name;
  std::string how;
  std::vector<Block> setups;
};

/// Single-, double- and m-change designs over the parts that have needed pairs, relabelled to be
/// cheap; none if there are forbidden pairs or slots. Each is the best that is known, and for m ≤ 4
/// what local search with so many moves makes of it.
[[nodiscard]] std::vector<Start> design_starts(const Job& job, std::uint64_t moves,
                                               RunControl& control);

/// Takes the step that tests most pairs for its cost, again and again; where prices differ, once
/// more with steps that are filled with what is cheap, and the cheaper list counts. Serves every
/// job without defects. Once the control says stop, it takes any steps, so that a complete list
/// comes soon.
[[nodiscard]] Start greedy_start(const Job& job, RunControl& control);

/// The set-ups in a cheap order: that of search/local_search.hpp if all changes cost the same and
/// nothing is mounted at the start, else always the nearest next; then reversing stretches and
/// moving short ones while it helps and the control does not say stop. O(tests²) a round.
[[nodiscard]] std::vector<Block> order_cheaply(const Job& job, const Weights& weights,
                                               std::vector<Block> setups, RunControl& control);

}  // namespace changeover
