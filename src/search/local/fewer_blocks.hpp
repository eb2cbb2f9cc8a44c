// Starts of local search with fewer blocks than a design has.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "run/random.hpp"
#include "search/local/anneal.hpp"
#include "search/local/local_search_arms.hpp"

namespace changeover {

/// The list with one block removed whose two neighbours differ in exactly m elements; nullopt if no
/// such
/// block is found soon.
[[nodiscard]] std::optional<Design> without_a_block(const Design& best, Random& random);

// Linear designs from circular ones. A circular design is begun at each of its blocks in turn, and
// blocks at the end are left out. What that uncovers is covered again at low temperatures, which
// change little: in designs from constructions a few places are good ones to begin at.

struct OpenedOutcome {
  std::optional<Design> design;  ///< linear, not verified
  std::uint64_t moves = 0;
  std::uint64_t least = 0;  ///< least number of things uncovered
  bool stopped = false;     ///< by the control or the watch
};

/// The best circular design that is known for these parameters, if they are of linear ones; nullopt
/// if there is none or no memory for it. @throws Stopped.
[[nodiscard]] std::optional<Design> known_circle(const Parameters& p);

/// Anneals `circle`, begun at each of its blocks in random order, with at most attempt.aim of them:
/// an equal share of attempt.moves for each, until a list covers all. `watch` makes the watch of a
/// run from the number of moves before it. @throws MissingResource as anneal_blocks().
[[nodiscard]] OpenedOutcome anneal_opened(
    const Design& circle, const Parameters& p, const Attempt& attempt, Random& random,
    RunControl& control, const std::function<AnnealWatch(std::uint64_t moves_before)>& watch);

}  // namespace changeover
