// Simulated annealing over lists of set-ups on one bench or several (lists.hpp), for what
// plan/search/anneal/anneal.hpp does not search: several benches, pairs of different weights,
// triples.
//
//     energy = what the aim counts + penalty · (weight of what has not met)
// where the aim counts, of the costs c_1, …, c_N of the benches with sum C, or when they end, and
// the budget Z,
//     least cost: C,      least largest cost: C + 2·Σ (c_i − C/N)²/(C/N),
//     most weight: C/4 + a · max(0, C − Z), 4 ≤ a ≤ 100.
// Most moves look at one step: what it puts in comes one set-up earlier or later in exchange for
// what it takes out. Others put any part, or one of something that has not met, in the place of
// another, in one set-up or in a stretch; mount or take out a part in a stretch; take out a set-up,
// copy one or insert one beside another; reverse a stretch, move a stretch to any place of any
// bench. The result is the same for any number of threads.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/run/control.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

enum class Aim { least_cost, least_largest, most_weight };

struct ListsSearch {
  Aim aim = Aim::least_cost;
  std::int64_t budget = 0;  ///< for the most weight, in the unit of the weights
  std::int64_t whole = 0;   ///< and what it costs to meet everything, about
  std::uint64_t steps = 0;  ///< of each attempt; 0: as many as suit
  unsigned attempts = 4;
  unsigned round = 0;            ///< another round has other random numbers
  std::string phase = {};        ///< for progress
  std::uint64_t everything = 0;  ///< the weight of all that has to meet; search_lists() finds out
};

/// The best that was met, and the moves that it took. Attempt i begins with starts[i mod their
/// number]. At least one start has to be valid: everything met, or within the budget; the result is
/// no worse than any that is.
struct FoundLists {
  BenchLists lists;
  std::uint64_t steps = 0;
};
[[nodiscard]] FoundLists search_lists(const ListsJob& job, const std::vector<BenchLists>& starts,
                                      const ListsSearch& options, RunControl& control);

/// Inserts set-ups until everything has met, each where it costs least for what it brings. False if
/// the control says stop before.
bool complete(Lists& lists, RunControl& control);

/// Takes away set-ups, and parts from whole runs of set-ups, while nothing more is missing and no
/// bench costs more.
void prune(Lists& lists, RunControl& control);

}  // namespace changeover
