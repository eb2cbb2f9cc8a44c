// Random lists of blocks with the change property: where local search starts.
//
//     Design start = random_list({.v = 30, .k = 6, .kind = Kind::circular}, 50, random);
//     random_walk(from, to, 7, p, random);        // 6 random blocks between two
//
// Which distances to a goal can be made good in exactly r steps is found first (only the distance
// matters, see construct/tools/path.hpp); a walk then takes random steps among those that still can
// arrive. All of it listens (run/control.hpp): Stopped may be thrown anywhere, and MissingResource
// if a table would be too large.
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

/// The blocks strictly between `from` and `to` on a random way of exactly `steps` ≥ 1 steps;
/// nullopt if there is none. O(steps·(min(k,v−k) + m² + k log k)), and steps·min(k,v−k) bits.
[[nodiscard]] std::optional<std::vector<Block>> random_walk(const Block& from, const Block& to,
                                                            std::size_t steps, const Parameters& p,
                                                            Random& random);

/// A list of `blocks` ≥ 1 blocks whose steps, the last one of a circular list included, change
/// exactly m elements; nullopt if there is none. It covers what it covers. O(b·k log k), or as
/// random_walk() if it is circular.
[[nodiscard]] std::optional<Design> random_list(const Parameters& p, std::size_t blocks,
                                                Random& random);

}  // namespace changeover
