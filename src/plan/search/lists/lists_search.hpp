// Simulated annealing over lists of set-ups on one bench or several (lists.hpp), for jobs that
// plan/search/anneal/anneal.hpp does not support: several benches, pairs of different weights,
// triples.
//
//     energy = objective + penalty · (weight of what has not met)
// with the objective, for the costs c_1, …, c_N of the benches (or their ends) with sum C, and the
// budget Z,
//     least cost: C,      least largest cost: C + 2·Σ (c_i − C/N)²/(C/N),
//     most weight: C/4 + a · max(0, C − Z), 4 ≤ a ≤ 100.
// Most moves concern one step: a part that it puts in comes one set-up earlier or later, in
// exchange for a part that it takes out. Others put any part, or one of an open target, in the
// place of another, in one set-up or in a stretch; mount or take out a part in a stretch; remove,
// copy or insert a set-up; reverse a stretch, or move it to any place of any bench. The result is
// the same for any number of threads.
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
  std::int64_t whole = 0;   ///< approximate cost of meeting everything
  std::uint64_t steps = 0;  ///< of each attempt; 0: chosen for the job
  unsigned attempts = 4;
  std::size_t most_tests = 0;    ///< if not 0, no list gets more, and fewer tests are better
  unsigned round = 0;            ///< each round has other random numbers
  std::string phase = {};        ///< for progress reports
  std::uint64_t everything = 0;  ///< weight of all that has to meet; computed by search_lists()
};

/// The best lists found, and the number of moves. Attempt i begins with starts[i mod their number].
/// At least one start must be valid: everything met, or within the budget. The result is at least
/// as good as every valid start.
struct FoundLists {
  BenchLists lists;
  std::uint64_t steps = 0;
};
[[nodiscard]] FoundLists search_lists(const ListsJob& job, const std::vector<BenchLists>& starts,
                                      const ListsSearch& options, RunControl& control);

/// Inserts set-ups until everything has met, each where it costs least for its gain. Returns false
/// if the control stops it before.
bool complete(Lists& lists, RunControl& control);

/// Removes set-ups, and parts from whole runs of set-ups, while no more weight is missing, nothing
/// is if nothing was, and no bench costs more.
void prune(Lists& lists, RunControl& control);

}  // namespace changeover
