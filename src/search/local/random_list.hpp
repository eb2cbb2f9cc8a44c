// Random lists of blocks with the change property, from which local search starts.
//
//     Design start = random_list({.v = 30, .k = 6, .kind = Kind::circular}, 50, random);
//     random_walk(from, to, 7, p, random);        // 6 random blocks between two
//
// First the distances are found from which exactly r steps can reach the goal (only the distance
// matters, see construct/tools/path.hpp). A walk then takes random steps among those that can still
// arrive. The scope of the thread (run/control.hpp) can stop it anywhere with Stopped; a table that
// is too large throws MissingResource.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "run/random.hpp"

namespace changeover {

/// A k-subset of the v elements, each as likely as any other. O(v).
[[nodiscard]] Block random_block(const Parameters& p, Random& random);

/// A block that differs from this one in exactly m elements, each as likely as any other; needs
/// v ≥ k + m. O(k log k), and O(v) for m > 16.
[[nodiscard]] Block random_step(const Block& from, const Parameters& p, Random& random);

/// The blocks strictly between `from` and `to` on a random walk of exactly `steps` ≥ 1 steps;
/// nullopt if there is none. O(steps·(min(k,v−k) + m² + k log k)), and steps·min(k,v−k) bits.
[[nodiscard]] std::optional<std::vector<Block>> random_walk(const Block& from, const Block& to,
                                                            std::size_t steps, const Parameters& p,
                                                            Random& random);

/// A list of `blocks` ≥ 1 blocks whose steps, including the last one of a circular list, change
/// exactly m elements; nullopt if there is none. Covering all subsets is not required. O(b·k log
/// k), or as random_walk() if it is circular.
[[nodiscard]] std::optional<Design> random_list(const Parameters& p, std::size_t blocks,
                                                Random& random);

}  // namespace changeover
