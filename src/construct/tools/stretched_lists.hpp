// Lists of base blocks over Z × {0, …, g−1} that can be stretched: what the construction
// stretched-orbits develops [docs/theorems.md, Theorem 30].
#pragma once

#include <cstdint>
#include <vector>

#include "construct/tools/orbit_points.hpp"

namespace changeover {

/// Blocks B₀, …, B_{q−1} of k = gh+1 points. The first one, and the one before it, B_{q−1} with 1
/// less in each residue, have A = {0, …, h−1} × {0, …, g−1} in common.
struct StretchedList {
  std::uint64_t g = 1;  ///< orbits
  std::uint64_t h = 1;  ///< residues of each of them in A
  std::uint64_t n = 1;  ///< the list is one for Z_n, and so for n+2h, n+4h, …
  std::vector<OrbitBlock> blocks;

  [[nodiscard]] std::uint64_t k() const { return g * h + 1; }
};

/// All that are known; no two with the same g and h. The order and the lists stay as they are, for
/// recipes name only what they make.
[[nodiscard]] const std::vector<StretchedList>& stretched_lists();

}  // namespace changeover
