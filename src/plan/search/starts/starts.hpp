// Lists of set-ups from which a search may start.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/run_plan.hpp"

#include "plan/search/anneal/sequence.hpp"

namespace changeover {

/// A list of set-ups that does the job, and how it was made.
struct Start {
  std::string name;
  std::string how;
  std::vector<Block> setups;
};

/// Single-, double- and m-change designs over the parts that have needed pairs, relabelled to be
/// cheap; empty if there are forbidden pairs or slots. Each is the best known one or, for m ≤ 4, a
/// better one found by local search with `moves` moves. All known ones come before any search.
[[nodiscard]] std::vector<Start> design_starts(const Job& job, std::uint64_t moves,
                                               RunControl& control);

/// Repeatedly takes the step that tests most pairs for its cost. If prices differ, a second list
/// fills its steps with cheap parts, and the cheaper list is returned. Works for every job without
/// defects. After the control requests a stop, takes any steps, so that the list is complete soon.
[[nodiscard]] Start greedy_start(const Job& job, RunControl& control);

/// The set-ups in a cheap order: that of search/local_search.hpp if all changes cost the same and
/// nothing is mounted at the start, else always the nearest next; then reversing stretches and
/// moving short ones while it helps and the control does not say stop. O(tests²) a round.
[[nodiscard]] std::vector<Block> order_cheaply(const Job& job, const Weights& weights,
                                               std::vector<Block> setups, RunControl& control);

}  // namespace changeover
