// The shapes that a circular design with an automorphism can have, and why some cannot be.
//
// π has s cycles of one length n and f fixed points (core/automorphism.hpp), and B_{i+c} = π(B_i): the design
// is developed from c base blocks and has b = cn blocks. With s = 1, f = 0 these are base blocks over Z_v.
//
//     for (const BaseBlockShape& shape : base_block_shapes(p, {.tight = true})) {
//       std::cout << to_string(shape) << '\n';
//     }
//     shape_obstruction({.v = 26, .k = 8, .kind = Kind::circular}, {5, 5, 1, 5}, true);
//     // "a fixed element would be introduced j times in r ≥ j ≥ 1 base blocks, 7j + 2(r−j) = 5"
//
// Every shift is 1: for a unit u, π^u is π with other names for the residues, so nothing is lost.
//
// What a tight design (every pair newly covered exactly once, b > 1) forces, for any automorphism that
// moves every block c on. Let n = b/c: π^n fixes every block, but may swap *twins*, elements that are in the same
// blocks, as the cube of (0 2 4 1 3 5) does for {0,1,2,3}, {2,3,4,5}, {4,5,0,1}. π maps classes of twins to classes of
// twins; let it do so in the order of their elements. It still moves every block c on, and π^n is the identity.
//   - No π^j, 0 < j < n, fixes two elements: their pair would be newly covered in some block and again
//     jc blocks later. So all cycles have length n but for f ≤ 1 fixed points.
//   - n is odd: for even n the pair {x, π^{n/2}(x)} is moved onto itself n/2·c blocks later.
//   - i introductions and r occurrences of an element satisfy i(k−1) + m(r−i) = v−1; for a fixed
//     element, which is introduced nj times and is in nr blocks, n(j(k−1) + m(r−j)) = v−1. Each run of
//     blocks with the element is followed by a block without it, unless it is fixed and in all blocks.
//   - Introductions of the cycles and of the fixed element add up to mc.
// With c·n = b this leaves few shapes, often none: then the only automorphism of this kind is the
// identity.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/automorphism.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

/// How base blocks are developed: under which π, with cycles of length n ≥ 2, and how many of them.
struct BaseBlockShape : Automorphism {
  std::uint64_t base_blocks = 0;  ///< c, at least 1

  [[nodiscard]] std::uint64_t b() const { return n * base_blocks; }

  auto operator<=>(const BaseBlockShape&) const = default;
};

/// "5 base blocks, 2 cycles of length 13".
[[nodiscard]] std::string to_string(const BaseBlockShape& shape);

/// Which shapes to consider.
struct ShapeOptions {
  std::optional<std::uint64_t> n = {};      ///< only this length
  std::optional<std::uint64_t> fixed = {};  ///< only so many fixed points; otherwise at most 2
  std::optional<std::uint64_t> base_blocks = {};  ///< only so many base blocks
  bool tight = false;                             ///< only shapes of tight designs
  /// No shape with more blocks. Nothing: what base_blocks says, or the least number of base blocks that
  /// the lower bound allows for each n and f.
  std::optional<std::uint64_t> most_blocks = {};
};

/// Why no circular design with these parameters has this shape, in one line; nullopt if these short
/// arguments do not exclude it, which claims nothing. Strength 2.
/// @throws as check().
[[nodiscard]] std::optional<std::string> shape_obstruction(const Parameters& p,
                                                           const BaseBlockShape& shape, bool tight);

/// The shapes that are not excluded, fewest blocks first, among them the longest cycles first.
/// Listens to the scope of this thread (run/scope.hpp). @throws as check(), and as lower_bound(). At most 10,000
/// shapes, none of more than 2⁶² blocks.
[[nodiscard]] std::vector<BaseBlockShape> base_block_shapes(const Parameters& p,
                                                            const ShapeOptions& options = {});

}  // namespace changeover
