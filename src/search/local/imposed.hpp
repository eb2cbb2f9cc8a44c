// Circular designs with a prescribed automorphism, by annealing base blocks.
//
//     const Parameters p{.v = 28, .k = 6, .kind = Kind::circular};
//     const Automorphism pi{.n = 7, .cycles = 4};
//     Random random(1);
//     auto found = search_imposed(p, pi, 6, {.moves = 1'000'000}, random, control);
//     found.design;                                            // the tight circular DCCD(28,6,42)
//
// A list with B_{i+c} = π(Bᵢ) is given by its first c blocks, so everything that grows with b is
// divided by the order n of π. Designs without such symmetry are not found; for v ≥ 40 the gain is
// far larger. Tight designs found this way: (15,4,21) n = 3, (16,4,24) n = 3, (25,4,60) n = 5,
// (26,4,65) n = 13, (28,6,42) n = 7, (21,3,70) n = 7.
//
// The search is not exhaustive, by design: if it finds nothing, that proves nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "run/random.hpp"
#include "search/local/anneal.hpp"

namespace changeover {

/// Every automorphism of order n ≥ 2 with cycles of length n and at most two fixed elements on v
/// elements: n divides v, v − 1 or v − 2. Largest order first. O(v).
[[nodiscard]] std::vector<Automorphism> imposed_automorphisms(std::uint64_t v);

/// The least number of base blocks that can newly cover enough pairs: ⌈orbits / p(k,m)⌉. @throws as
/// Automorphism::pair_orbits(). O(1).
[[nodiscard]] std::uint64_t fewest_base_blocks(const Parameters& p, const Automorphism& pi);

/// c random base blocks whose steps, including the one to π(first), change m elements; nullopt if
/// none were found. With few base blocks for large k these consist of long intervals of cycles.
/// Needs v = pi.v() ≥ k + m.
[[nodiscard]] std::optional<std::vector<Block>> random_base_blocks(const Parameters& p,
                                                                   const Automorphism& pi,
                                                                   std::size_t base_blocks,
                                                                   Random& random);

struct ImposedOutcome {
  std::optional<Design> design;  ///< cn blocks, circular; not verified
  AnnealOutcome anneal;          ///< in orbits
  bool started = false;          ///< whether base blocks to start from were found
};

/// One annealing run from random base blocks. The kind of p is taken as circular; its strength must
/// be 2. @throws BadInput unless pi.v() = v, base_blocks ≥ 1, strength 2 and v ≤ 4096. O(moves ·
/// segment · k).
[[nodiscard]] ImposedOutcome search_imposed(const Parameters& p, const Automorphism& pi,
                                            std::size_t base_blocks, const AnnealSchedule& schedule,
                                            Random& random, RunControl& control,
                                            const AnnealWatch& watch = {});

}  // namespace changeover
