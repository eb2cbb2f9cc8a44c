// Do some cubes leave nothing out?
//
//     cubes_cover_everything({{1}, {-1, 2}, {-1, -2}});      // true
//     cubes_cover_everything({{1}, {-1, 2}});                // false: −1 −2 is missing
//
// A cube is a list of literals that are all to hold. If a formula has no solution in any of some cubes, and
// every assignment lies in one of these, then it has no solution at all: that is what allows a
// search to be split, each part with a proof of its own.
#pragma once

#include <cstdint>
#include <vector>

namespace changeover {

/// Literals that hold together: ±1, ±2, …
using Cube = std::vector<std::int32_t>;

/// Whether each assignment of the variables satisfies all the literals of at least one cube. Splits on
/// a variable of the shortest cube: linear in the total length of the cubes of a binary tree for each of
/// its levels, exponential at worst.
/// @throws BadInput if a literal is 0 or a cube contradicts itself.
[[nodiscard]] bool cubes_cover_everything(const std::vector<Cube>& cubes);

}  // namespace changeover
