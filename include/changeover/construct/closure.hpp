// Closure rules: a design out of a design, as a recipe out of a recipe.
//
// A rule keeps what makes a change covering design, whatever its input, its change number m and its
// kind, so rules may be composed freely. Recipes are written down here and nothing is built:
//
//     Parameters p{.v = 5, .k = 3, .change = 1, .kind = Kind::circular};
//     Recipe core{"mcsorley-circular", p, {}, {}, {}};
//     Recipe larger = fix_recipe(blow_up_recipe(core, 3), 2);  // circular, 3-change, on (17,11)
//     Registry::standard().build(larger);                      // 5 blocks, as many as the core has
//
// A rule says nothing of quality: a minimum design may become one that is not. Choosing inputs is
// left to those who compose; the constructions "fix" and "blow-up" make no offers of their own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

/// The blocks of a design as a separate recipe, "literal", and where they come from: the leaf
/// that rules work on if a design has no better one.
[[nodiscard]] Recipe literal_recipe(const Design& design, std::string provenance = {});

/// *Fix*: f new elements v, …, v+f−1 in every block. An m-change covering design on (v,k) becomes
/// one on (v+f, k+f), of the same kind and with as many blocks: steps change what they changed, and
/// a new element meets every other. Pairs of new elements are never newly covered in a circular
/// design, so it is not tight if f ≥ 2. The input itself if f = 0.
/// @throws ImpossibleParameters if v + f exceeds 64 bits.
[[nodiscard]] Recipe fix_recipe(const Recipe& input, std::uint64_t f);

/// *Blow up*: s copies sx, …, sx+s−1 of every element x. An m-change covering design on (v,k)
/// becomes an sm-change covering design on (sv, sk), of the same kind and with as many blocks:
/// copies come and go with their element, and copies of x and y meet where x and y do. The input
/// itself if s = 1.
/// @throws ImpossibleParameters if sv exceeds 64 bits; BadInput if s = 0.
[[nodiscard]] Recipe blow_up_recipe(const Recipe& input, std::uint64_t s);

/// *Cut*: a circular design read as a linear one that begins after block `at`. As many blocks.
/// @throws BadInput if the input is not circular.
[[nodiscard]] Recipe cut_recipe(Recipe input, std::uint64_t at = 0);

/// *Truncate*: delete the largest element that can go: in each run of blocks that hold it some
/// other element must be free to take its place. As many blocks; nullopt if no element can go.
/// `design` is what the input builds. O(v·bk).
[[nodiscard]] std::optional<Recipe> truncate_recipe(const Recipe& input, const Design& design);

/// *Unfix*: take away an element that is in every block, the converse of fix; nullopt if there is
/// none, or if blocks would become smaller than what changes. `design` is what the input builds.
/// O(bk).
[[nodiscard]] std::optional<Recipe> unfix_recipe(const Recipe& input, const Design& design);

/// *Drop*: leave out blocks that are not needed, one after another, while any can go.
[[nodiscard]] Recipe drop_recipe(const Recipe& input);

/// How many blocks drop_recipe() would leave of this design. O(bk²); 4·C(v,2) bytes.
[[nodiscard]] std::uint64_t needed_block_count(const Design& design);

/// Where to cut a circular design, and what drop_recipe() then leaves of it.
struct BestCut {
  std::uint64_t at = 0;
  std::uint64_t needed = 0;
};

/// The first of the cuts at 0, 1, …, most_cuts − 1 after which fewest blocks are needed, or the
/// first that needs no more than `enough`. O(bk²) for all of them, and O(k²) for each block that is
/// dropped.
[[nodiscard]] BestCut best_cut(const Design& design, std::size_t most_cuts, std::uint64_t enough);

// ---- The same on designs in memory, for strength 2.

/// *Drop*. Designs of other strengths stay as they are. O(bk²).
[[nodiscard]] Design without_needless_blocks(const Design& design);

/// *Truncate*, so many times; nullopt if no element can go.
[[nodiscard]] std::optional<Design> truncated(const Design& design, std::uint64_t elements);

/// The linear design with fewest blocks that is cut from consecutive blocks of this one (circular,
/// or linear itself) without blocks that are not needed. O(bk² + v²). Designs of other strengths
/// are only cut open. The design must be valid.
[[nodiscard]] Design shortest_cut(const Design& design);

/// The consecutive `blocks` of this design that leave fewest pairs uncovered, as a linear list: at
/// least one block, at most all. For other strengths the first ones. O(bk² + v²).
[[nodiscard]] Design best_part(const Design& design, std::size_t blocks);

/// A recipe that a rule made, and how many blocks it has.
struct Made {
  Recipe recipe;
  std::uint64_t b = 0;
};

/// *Close up*: delete the element of a linear single-change design after which fewest blocks are
/// left when each stay begins as soon as another one has ended; of a few with the most stays. One
/// block fewer for each stay of it, or better. `design` is what the input builds. nullopt if it is
/// no such design or v ≤ k + 1. O(bk).
[[nodiscard]] std::optional<Made> close_up_recipe(const Recipe& input, const Design& design);

/// *Coarsen*: g consecutive blocks of a single-change design on (v,k) in one, a g-change design on
/// (v, k+g−1) of the same kind. `design` is what the input builds. nullopt if that cannot be done.
/// O(gbk).
[[nodiscard]] std::optional<Made> coarsen_recipe(const Recipe& input, const Design& design,
                                                 std::uint64_t g);

/// *Join ends*: a circular design, a linear one and after it the s − 1 blocks between its last
/// block and its first, where s is the least number of steps from one to the other. `design` is
/// what the input builds. nullopt if it is circular, its first and last block are the same, it has
/// fewer than 3 blocks or there is no way. O(k²).
[[nodiscard]] std::optional<Made> join_ends_recipe(const Recipe& input, const Design& design);

/// The positions of a cover of a design by unchanged subsets, as a recipe lists them.
struct CoverPositions {
  std::vector<Element> positions;  ///< increasing; see UnchangedCover
  std::uint64_t available = 0;     ///< how many positions the design has
};

/// A cover that leaves nothing out, of few unchanged subsets: the search for fewer is short.
/// nullopt if some element is in none, k = m, or v > 2000. `design` must be valid. O(bk) and at
/// most about 200 nodes.
[[nodiscard]] std::optional<CoverPositions> cover_positions(const Design& design);

/// Whether w new elements can be added by partial expansion to a design with these parameters.
[[nodiscard]] bool new_elements_fit(const Parameters& p, std::uint64_t w);

/// *Partial expansion*: w new elements by such a cover; see construct/expansion.hpp. They must fit.
[[nodiscard]] Recipe partial_expansion_recipe(const Recipe& input, const CoverPositions& cover,
                                              std::uint64_t w);

/// The number of blocks of the partial expansion of an input with parameters p and b blocks;
/// nullopt if w takes more positions than there are. @throws ImpossibleParameters if w does not
/// fit.
[[nodiscard]] std::optional<std::uint64_t> partial_expansion_count(const Parameters& p,
                                                                   std::uint64_t b,
                                                                   const CoverPositions& cover,
                                                                   std::uint64_t w);

/// *Concatenate*: a linear single-change design with another one after it, `times` times. The
/// unchanged subsets of the second at these positions (increasing, 1 is between the first two
/// blocks) must be disjoint and leave out k−1 elements, which are in its first or its last block:
/// they become elements of the block before. Each time w−k+1 elements are added. What does not fit
/// is refused when the recipe is built. @throws ImpossibleParameters if the elements exceed 64
/// bits.
[[nodiscard]] Recipe concatenate_recipe(Recipe first, Recipe second, std::vector<Element> positions,
                                        std::uint64_t times = 1);

/// *Interpolate*: each step of an M-change design in M/m steps of m. The input itself if m = M.
/// @throws BadInput if m does not divide M.
[[nodiscard]] Recipe interpolate_recipe(const Recipe& input, std::uint64_t m);

/// The number of blocks of the interpolated design, for an input with parameters p and b blocks.
/// @throws
/// ImpossibleParameters if they exceed 64 bits.
[[nodiscard]] std::uint64_t interpolated_count(const Parameters& p, std::uint64_t m,
                                               std::uint64_t b);

}  // namespace changeover
