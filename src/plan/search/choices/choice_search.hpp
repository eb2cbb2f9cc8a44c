// Lists of set-ups of a model: built row by row, with few rows, and annealed.
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

/// What a greedy list is to have little of.
enum class GreedyAim { cost, tests };

/// Adds set-ups until nothing is missing: each time the best of a few that begin with the one
/// before or with a set-up that has something missing, and change what brings most, as long as that
/// pays. Once the control says stop, any set-up that has something missing, so that a complete list
/// comes soon. O(tests · parameters · values), with triples · parameters more.
void complete_greedily(const ChoiceJob& choices, ChoiceList& list, GreedyAim aim, Random& random,
                       RunControl& control);

/// Takes away set-ups that nothing needs, and changes that nothing needs.
void prune_choices(const ChoiceJob& choices, ChoiceList& list);

/// Takes away set-ups one at a time and looks, with so many moves each time, for a list without
/// anything missing that has one less: a tabu search [Lin2015] over single cells, each time for a
/// missing tuple and the row that comes to test it at the least loss. Ends at `least` set-ups, when
/// the moves are used up, or when the control says stop; the list is then complete, if it was
/// before. Returns the number of moves.
std::uint64_t remove_tests(const ChoiceJob& choices, ChoiceList& list, std::size_t least,
                           std::uint64_t moves, Random& random, RunControl& control);

/// Of an annealing in which no set-up comes or goes, in changes: what a missing tuple costs, and
/// the temperatures. Lists with few set-ups are rigid: the fewer, the dearer must be what is
/// missing.
struct FixedTests {
  double penalty = 8;
  double hot = 0.6;
  double cold = 0.1;
};

struct ChoiceAnnealing {
  std::uint64_t steps = 0;
  double hot = 1.0;  ///< first temperature, of the usual one
  std::optional<std::chrono::duration<double>> time =
      {};                                      ///< the schedule ends then, even if steps are left
  std::optional<FixedTests> fixed_tests = {};  ///< no set-up comes or goes
  std::optional<std::int64_t> budget = {};     ///< no list that costs more is looked at
  std::string phase = {};
};

struct AnnealedChoices {
  std::optional<std::vector<Block>>
      setups;  ///< the cheapest complete list that was met; under a budget, that which misses least
  std::int64_t cost = 0;
  std::size_t missing = 0;
  std::uint64_t steps = 0;
};

/// Simulated annealing with energy = cost + penalty · missing; the penalty rises when too much is
/// missing for the moment. Moves: a cell, or a run of cells of one parameter, takes another value,
/// often that of a neighbour; a missing tuple is put into a set-up; set-ups change places, come or
/// go. Deterministic.
AnnealedChoices anneal_choices(const ChoiceJob& choices, ChoiceList list,
                               const ChoiceAnnealing& options, Random& random, RunControl& control);

}  // namespace changeover
