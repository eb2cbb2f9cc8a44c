// Lists of set-ups of a model: built row by row, reduced to few rows, and annealed.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/run/control.hpp"
#include "plan/job/choices.hpp"
#include "plan/search/choices/choice_lists.hpp"
#include "run/random.hpp"

namespace changeover {

/// The objective of a greedy list.
enum class GreedyAim { cost, tests };

/// Adds set-ups until nothing is missing: each time the best of a few. They start from the one
/// before, or from a set-up with a missing tuple, and make the best changes as long as these pay.
/// After the control requests a stop, adds any set-up with a missing tuple, so that the list is
/// complete soon. O(tests · parameters · values), with triples · parameters more.
void complete_greedily(const ChoiceJob& choices, ChoiceList& list, GreedyAim aim, Random& random,
                       RunControl& control);

/// Set-ups in which one parameter after the other goes from each of its values to each other, those
/// that the rules allow: nearly complete, with many tests and few changes. Nothing if a parameter
/// has many values.
[[nodiscard]] std::optional<std::vector<Block>> swept(const ChoiceJob& choices, Random& random);

/// Takes away set-ups that nothing needs, and changes that nothing needs.
void prune_choices(const ChoiceJob& choices, ChoiceList& list);

/// Removes set-ups one at a time and searches each time, with at most `moves` moves, for a complete
/// list with one set-up less: a tabu search [Lin2015] over single cells, which takes a missing
/// tuple and the row that can test it at the least loss. Ends at `least` set-ups, when the moves
/// are used up, or when the control requests a stop; the list is then complete, if it was before.
/// Returns the number of moves.
std::uint64_t remove_tests(const ChoiceJob& choices, ChoiceList& list, std::size_t least,
                           std::uint64_t moves, Random& random, RunControl& control);

/// The penalty of a missing tuple and the temperatures, in changes, for annealing with a fixed
/// number of set-ups. Lists with few set-ups are rigid: the fewer there are, the higher the penalty
/// must be.
struct FixedTests {
  double penalty = 8;
  double hot = 0.6;
  double cold = 0.1;
};

struct ChoiceAnnealing {
  std::uint64_t steps = 0;
  double hot = 1.0;  ///< factor for the first temperature
  std::optional<std::chrono::duration<double>> time =
      {};                                      ///< the schedule ends then, even if steps are left
  std::optional<FixedTests> fixed_tests = {};  ///< if set, the number of set-ups is fixed
  std::optional<std::int64_t> budget = {};     ///< lists that cost more are ignored
  std::string phase = {};
};

struct AnnealedChoices {
  std::optional<std::vector<Block>>
      setups;  ///< the cheapest complete list found; with a budget, the one that misses least
  std::int64_t cost = 0;
  std::size_t missing = 0;
  std::uint64_t steps = 0;
};

/// Simulated annealing with energy = cost + penalty · missing; the penalty rises when too much is
/// missing for the moment. Moves: a cell, or a run of cells of one parameter, takes another value,
/// often that of a neighbour; a missing tuple is put into a set-up; set-ups change places, are
/// added or removed. Deterministic.
AnnealedChoices anneal_choices(const ChoiceJob& choices, ChoiceList list,
                               const ChoiceAnnealing& options, Random& random, RunControl& control);

}  // namespace changeover
