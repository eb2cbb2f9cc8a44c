// Search for base blocks: circular designs with an imposed automorphism, as c blocks instead of cn.
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
// The shapes that the parameters allow (search/base_block_search.hpp) are tried one after another,
// fewest blocks first, until one has base blocks. Any unchanged subsets may occur, not intervals
// only. Two methods:
//   sat     a formula for all base blocks at once, CaDiCaL; for a tight design every orbit of pairs
//           is newly covered exactly once and each element has a degree that the degree identity
//           allows. It can say that there are none of this shape. That is the solver's statement,
//           not a certificate.
//   anneal  segment swaps made in all images at once (search/local/segment_orbits.hpp); for larger
//           parameters with some slack. It never says none.
//   automatic  a short annealing, then sat if the formula is small enough, then the rest of the
//           annealing; for tight designs of few base blocks sat at once.
//
// Every result is developed by the registry and verified on all its blocks before it is returned.
// For a linear p the circular design is cut open. With one seed and limits in moves and conflicts,
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
#include "changeover/core/recipe.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

// The shapes that a circular design with an automorphism can have, and why some cannot be.
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
// Every shift is 1: for a unit u, π^u is π with other names for the residues, so nothing is lost.
//
// What a tight design (every pair newly covered exactly once, b > 1) forces, for any automorphism
// that moves every block c on. Let n = b/c: π^n fixes every block, but may swap *twins*, elements
// that are in the same blocks, as the cube of (0 2 4 1 3 5) does for {0,1,2,3}, {2,3,4,5},
// {4,5,0,1}. π maps classes of twins to classes of twins; let it do so in the order of their
// elements. It still moves every block c on, and π^n is the identity.
//   - No π^j, 0 < j < n, fixes two elements: their pair would be newly covered in some block and
//     again jc blocks later. So all cycles have length n but for f ≤ 1 fixed points.
//   - n is odd: for even n the pair {x, π^{n/2}(x)} is moved onto itself n/2·c blocks later.
//   - i introductions and r occurrences of an element satisfy i(k−1) + m(r−i) = v−1; for a fixed
//     element, which is introduced nj times and is in nr blocks, n(j(k−1) + m(r−j)) = v−1. Each run
//     of blocks with the element is followed by a block without it, unless it is fixed and in all
//     blocks.
//   - Introductions of the cycles and of the fixed element add up to mc.
// With c·n = b this leaves few shapes, often none: then the only automorphism of this kind is the
// identity.

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
  /// No shape with more blocks. Nothing: what base_blocks says, or the least number of base blocks
  /// that the lower bound allows for each n and f.
  std::optional<std::uint64_t> most_blocks = {};
};

/// Why no circular design with these parameters has this shape, in one line; nullopt if these short
/// arguments do not exclude it, which claims nothing. Strength 2.
/// @throws as check().
[[nodiscard]] std::optional<std::string> shape_obstruction(const Parameters& p,
                                                           const BaseBlockShape& shape, bool tight);

/// The shapes that are not excluded, fewest blocks first, among them the longest cycles first.
/// Listens to the scope of this thread (run/control.hpp). @throws as check(), and as lower_bound().
/// At most 10,000 shapes, none of more than 2⁶² blocks.
[[nodiscard]] std::vector<BaseBlockShape> base_block_shapes(const Parameters& p,
                                                            const ShapeOptions& options = {});

enum class BaseBlockMethod : std::uint8_t { automatic, sat, anneal };

/// "automatic", "sat", "anneal".
[[nodiscard]] std::string_view to_string(BaseBlockMethod method);

/// The method of that name; nullopt for any other word.
[[nodiscard]] std::optional<BaseBlockMethod> base_block_method_from_string(std::string_view name);

struct BaseBlockOptions {
  ShapeOptions shapes = {};  ///< which shapes; tight only if shapes.tight
  std::uint64_t shift = 1;   ///< what π adds in the result: a unit of each Z_n that is tried
  BaseBlockMethod method = BaseBlockMethod::automatic;
  std::uint64_t moves = 4'000'000;    ///< of annealing, for each shape
  std::uint64_t conflicts = 400'000;  ///< of the SAT solver, for each shape
  std::uint64_t sat_size = 40'000;    ///< automatic: largest c·C(v,2) for which sat is tried
  std::uint64_t rounds = 1;  ///< through all shapes; each takes twice the moves of the one before
};

/// What became of one shape.
struct ShapeAttempt {
  BaseBlockShape shape;
  Outcome outcome = Outcome::unknown;  ///< none: so says the SAT solver
  std::uint64_t moves = 0;
  std::uint64_t conflicts = 0;
  std::optional<std::uint64_t> missing = {};  ///< fewest uncovered orbits that annealing saw
};

/// Against the best design of the registry with the same parameters.
enum class Comparison : std::uint8_t {
  only,    ///< the registry has none
  better,  ///< fewer blocks, or as many and tight where its offer does not promise that
  equal,   ///< as many blocks
  worse,
};

/// "only", …
[[nodiscard]] std::string_view to_string(Comparison comparison);

struct BaseBlockResult {
  BaseBlockShape shape;                  ///< of what was found
  std::vector<Block> base_blocks;        ///< with shift 1; empty if nothing was found
  std::optional<Recipe> recipe;          ///< "developed", or a "cut" of it if p is linear
  std::optional<VerifiedDesign> design;  ///< all blocks, with recipe

  Comparison comparison = Comparison::only;
  std::optional<std::uint64_t> registry_b;  ///< blocks of the registry's best
  std::string registry_construction;        ///< its name

  std::vector<ShapeAttempt> attempts;  ///< in the order in which they were made
  std::uint64_t moves = 0;
  std::uint64_t conflicts = 0;
  WhyStopped why_stopped = WhyStopped::running;  ///< exhausted: every shape was said to have none

  [[nodiscard]] bool found() const { return design.has_value(); }
  /// Of what was found.
  [[nodiscard]] const Verdict& verdict() const { return design.value().verdict(); }
};

/// Searches, see above. Without most_blocks or base_blocks a search that is not for tight designs
/// tries ever more base blocks, up to what the registry needs (or twice the lower bound, if it has
/// nothing).
/// @throws as check(); ImpossibleParameters if v exceeds 2000 or the strength is not 2; BadInput if
/// shift is no unit; MissingResource if no shape fits into the memory that `control` allows;
/// InternalError if a result does not verify. Bound by: options.moves and options.conflicts for
/// each shape.
[[nodiscard]] BaseBlockResult search_base_blocks(const Parameters& p,
                                                 const BaseBlockOptions& options,
                                                 RunControl& control);

/// The recipe that stores base blocks: developed under π^shift, the residues renamed to match.
/// @throws BadInput if shift is no unit of Z_n.
[[nodiscard]] Recipe developed_recipe(const Parameters& p, const BaseBlockShape& shape,
                                      std::vector<Block> base_blocks, std::uint64_t shift = 1,
                                      std::string provenance = {});

/// One or two lines: what was found or why not, and how it compares.
[[nodiscard]] std::string describe(const BaseBlockResult& result);

}  // namespace changeover
