// Lists of base blocks over 2k−3 orbits between which pairs of opposite points can pass: what the
// construction tournament-orbits develops [docs/theorems.md, Theorem 32].
#pragma once

#include <cstdint>
#include <vector>

#include "construct/tools/orbit_points.hpp"

namespace changeover {

/// Before block number `before` the pairs centre + x, centre − x of `orbit` pass, for x = `from`,
/// from+1, …, while what this block has in common with the one before it is kept.
struct Passage {
  std::uint64_t orbit = 0;
  std::uint64_t before = 0;
  std::int64_t centre = 0;
  std::int64_t from = 1;
};

/// Blocks of k points of the orbits 0, …, 2k−4; the last block less `shift` in each residue comes
/// before the first.
struct TournamentList {
  std::uint64_t k = 0;
  std::uint64_t least = 1;  ///< least odd n that it serves
  std::int64_t shift = 1;   ///< ± a power of 2
  std::vector<OrbitBlock> blocks;
  std::vector<Passage> passages;  ///< one for each orbit

  [[nodiscard]] std::uint64_t orbits() const { return 2 * k - 3; }
};

/// All that are known; no two with the same k. The order and the lists stay as they are, for
/// recipes name only what they make.
[[nodiscard]] const std::vector<TournamentList>& tournament_lists();

}  // namespace changeover
