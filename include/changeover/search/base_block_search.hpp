// Searches for base blocks: circular designs with an imposed automorphism, given by c blocks
// instead of cn.
//
//     RunControl control({.time = std::chrono::seconds(60)});
//     const BaseBlockResult result = search_base_blocks({.v = 26, .k = 4, .kind = Kind::circular},
//                                                       {.shapes = {.tight = true}}, control);
//     if (result.found()) {
//       result.shape;                       // 5 base blocks, 2 cycles of length 13
//       result.verdict().tight();            // verified on all 65 blocks
//       result.recipe->blocks;              // a recipe "developed" stores the 5 base blocks
//       result.comparison;                  // Comparison::equal: the registry knows it by now
//     }
//
// The possible shapes (see below) are tried one after another, fewest blocks first, until base
// blocks are found. Unchanged subsets are not restricted to intervals. Methods:
//   sat     a formula for all base blocks at once, solved by CaDiCaL; for a tight design every
//           orbit of pairs is newly covered exactly once, and each element has a degree that the
//           degree identity allows. It can answer that this shape has no base blocks; that is a
//           statement of the solver, not a certificate.
//   anneal  segment swaps made in all images at once (internal:
//           src/search/local/segment_orbits.hpp); for larger parameters with some slack. It never
//           answers that there are none.
//   automatic  a short annealing, then sat if the formula is small enough, then the rest of the
//           annealing; for tight designs of few base blocks, sat first.
//
// Every result is developed by the registry and verified on all its blocks before it is returned.
// For linear parameters the circular design is cut open. With a seed and limits of moves and
// conflicts, without a time limit, the result is always the same. Uses one thread.
// but not in time, the result is always the same. One thread.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

// The shapes that a circular design with an automorphism can have, and reasons that exclude some.
//
// π has s cycles of one length n and f fixed points (core/developed.hpp), and B_{i+c} = π(B_i): the
// design is developed from c base blocks and has b = cn blocks. With s = 1, f = 0 these are base
// blocks over Z_v.
//
//     for (const BaseBlockShape& shape : base_block_shapes(p, {.tight = true})) {
//       std::cout << to_string(shape) << '\n';
//     }
//     shape_obstruction({.v = 26, .k = 8, .kind = Kind::circular}, {5, 5, 1, 5}, true);
//     // "a fixed element would be introduced j times in r ≥ j ≥ 1 base blocks, 7j + 2(r−j) = 5"
//
// Every shift is 1: for a unit u, π^u is π with the residues renamed, so this is no restriction.
//
// The following holds in a tight design (every pair newly covered exactly once, b > 1) for any
// automorphism π that moves every block by c. Let n = b/c: π^n fixes every block, but may swap
// *twins*, elements that are in the same blocks, as the cube of (0 2 4 1 3 5) does for {0,1,2,3},
// {2,3,4,5}, {4,5,0,1}. π maps classes of twins to classes of twins; choose it such that it keeps
// the order of the elements in each class. It still moves every block by c, and π^n is the
// identity.
//   - No π^j, 0 < j < n, fixes two elements: their pair would be newly covered in some block and
//     again jc blocks later. So all cycles have length n but for f ≤ 1 fixed points.
//   - n is odd: for even n the pair {x, π^{n/2}(x)} is moved onto itself n/2·c blocks later.
//   - i introductions and r occurrences of an element satisfy i(k−1) + m(r−i) = v−1; for a fixed
//     element, which is introduced nj times and is in nr blocks, n(j(k−1) + m(r−j)) = v−1. Each run
//     of blocks with the element is followed by a block without it, unless it is fixed and in all
//     blocks.
//   - Introductions of the cycles and of the fixed element add up to mc.
// With c·n = b few shapes remain, often none: then the identity is the only automorphism of this
// kind.

/// How base blocks are developed: the automorphism π, with cycles of length n ≥ 2, and the number
/// of base blocks.
struct BaseBlockShape : Automorphism {
  std::uint64_t base_blocks = 0;  ///< c, at least 1

  [[nodiscard]] std::uint64_t b() const { return n * base_blocks; }

  auto operator<=>(const BaseBlockShape&) const = default;
};

/// The shape in words: "5 base blocks, 2 cycles of length 13".
[[nodiscard]] std::string to_string(const BaseBlockShape& shape);

/// Which shapes to consider.
struct ShapeOptions {
  std::optional<std::uint64_t> n = {};  ///< only this cycle length
  std::optional<std::uint64_t> fixed =
      {};  ///< only this number of fixed points; otherwise at most 2
  std::optional<std::uint64_t> base_blocks = {};  ///< only this number of base blocks
  bool tight = false;                             ///< only shapes of tight designs
  /// Limit for the number of blocks. nullopt: given by base_blocks, or by the least number of base
  /// blocks that the lower bound allows for each n and f.
  std::optional<std::uint64_t> most_blocks = {};
};

/// One line on why no circular design with these parameters has this shape; nullopt if short
/// arguments do not exclude it, which claims nothing. Strength 2.
/// @throws as check().
[[nodiscard]] std::optional<std::string> shape_obstruction(const Parameters& p,
                                                           const BaseBlockShape& shape, bool tight);

/// The shapes that are not excluded, fewest blocks first, and among those the longest cycles first.
/// Stops when the scope of this thread (run/control.hpp) requests it. @throws as check(), and as
/// lower_bound(). At most 10,000 shapes, none of more than 2⁶² blocks.
[[nodiscard]] std::vector<BaseBlockShape> base_block_shapes(const Parameters& p,
                                                            const ShapeOptions& options = {});

enum class BaseBlockMethod : std::uint8_t { automatic, sat, anneal };

struct BaseBlockOptions {
  ShapeOptions shapes = {};  ///< which shapes; only tight designs if shapes.tight
  std::uint64_t shift = 1;   ///< what π adds in the result: a unit of each tried Z_n
  BaseBlockMethod method = BaseBlockMethod::automatic;
  std::uint64_t moves = 4'000'000;    ///< of annealing, for each shape
  std::uint64_t conflicts = 400'000;  ///< of the SAT solver, for each shape
  std::uint64_t sat_size = 40'000;    ///< automatic: largest c·C(v,2) for which sat is tried
  std::uint64_t rounds =
      1;  ///< passes through all shapes; each has twice the moves of the one before
};

/// The result for one shape.
struct ShapeAttempt {
  BaseBlockShape shape;
  Outcome outcome = Outcome::unknown;  ///< `none` is a statement of the SAT solver
  std::uint64_t moves = 0;
  std::uint64_t conflicts = 0;
  std::optional<std::uint64_t> missing = {};  ///< fewest uncovered orbits reached by annealing
};

/// Comparison with the best design of the registry with the same parameters.
enum class Comparison : std::uint8_t {
  only,    ///< the registry has no design
  better,  ///< fewer blocks; or as many, and tight where the registry does not promise that
  equal,   ///< the same number of blocks
  worse,
};

/// The name of a comparison: "only", …
[[nodiscard]] std::string_view to_string(Comparison comparison);

struct BaseBlockResult {
  BaseBlockShape shape;                  ///< of the result
  std::vector<Block> base_blocks;        ///< with shift 1; empty if none were found
  std::optional<Recipe> recipe;          ///< "developed", or a "cut" of it if p is linear
  std::optional<VerifiedDesign> design;  ///< all blocks, with the recipe

  Comparison comparison = Comparison::only;
  std::optional<std::uint64_t> registry_b;  ///< blocks of the registry's best design
  std::string registry_construction;        ///< its name

  std::vector<ShapeAttempt> attempts;  ///< in the order of the search
  std::uint64_t moves = 0;
  std::uint64_t conflicts = 0;
  WhyStopped why_stopped =
      WhyStopped::running;  ///< `exhausted`: every shape has none, according to the solver

  [[nodiscard]] bool found() const { return design.has_value(); }
  /// The verdict on the design found.
  [[nodiscard]] const Verdict& verdict() const { return design.value().verdict(); }
};

/// Searches as described above. Without most_blocks and base_blocks, a search that is not for tight
/// designs tries more and more base blocks, up to the number of blocks in the registry (or twice
/// the lower bound, if it has no design). @throws as check(); ImpossibleParameters if v exceeds
/// 2000 or the strength is not 2; BadInput if shift is not a unit; MissingResource if no shape fits
/// into the memory that `control` allows; InternalError if a result fails verification. Time:
/// options.moves and options.conflicts for each shape.
[[nodiscard]] BaseBlockResult search_base_blocks(const Parameters& p,
                                                 const BaseBlockOptions& options,
                                                 RunControl& control);

/// The recipe that stores base blocks: developed under π^shift, with the residues renamed
/// accordingly. @throws BadInput if shift is not a unit of Z_n.
[[nodiscard]] Recipe developed_recipe(const Parameters& p, const BaseBlockShape& shape,
                                      std::vector<Block> base_blocks, std::uint64_t shift = 1,
                                      std::string provenance = {});

/// One or two lines: what was found, or why nothing was, and the comparison.
[[nodiscard]] std::string describe(const BaseBlockResult& result);

}  // namespace changeover
