// The base blocks that triple_leave.hpp knows, with places aN + s in Z_w, N = k−2: most of them are
// right for all N, or for those of one class modulo 3 [docs/theorems.md, Theorem 34].
#pragma once

#include <cstdint>
#include <vector>

namespace changeover {

/// aN + s.
struct FormalPlace {
  std::int64_t multiple = 0;  ///< a
  std::int64_t more = 0;      ///< s
};

struct FormalLeave {
  enum class For : std::uint8_t { all, class_modulo_3, one };

  std::uint64_t left = 0;   ///< t
  std::uint64_t twice = 0;  ///< j
  bool doubled = false;
  For which = For::all;
  std::uint64_t number = 0;            ///< N modulo 3, or N
  std::vector<FormalPlace> points;     ///< three of each base block, the last one with N−1
  std::vector<FormalPlace> triangles;  ///< d and e for each triangle {0, d, d+e} that is left

  [[nodiscard]] std::uint64_t rounds() const { return points.size() / 3; }
  [[nodiscard]] std::uint64_t elements(std::uint64_t N) const {
    return 6 * rounds() * N + 2 * left - 2 * twice + (doubled ? 0 : 1);
  }
  [[nodiscard]] bool serves(std::uint64_t N) const {
    return which == For::all || (which == For::one ? N : N % 3) == number;
  }
};

/// Entries stay: recipes name only k, v and the kind, so one that is better where there is one
/// already needs an argument of the recipe.
[[nodiscard]] const std::vector<FormalLeave>& formal_leaves();

}  // namespace changeover
