// Groups of new elements beside a design: concatenation for m ≥ 2 [docs/theorems.md, Theorem 15].
//
// Let n = k−m. Disjoint unchanged subsets S_1, S_2, … of a design W, its *parts*, leave a set Y of
// h elements, and U, n elements of Y, is unchanged at some step of W or in its last block: the
// *hinge*. New elements come in q groups of g. Partitions of all new elements into m-subsets that
// have no two elements of a group are *classes*. Beside each part the blocks of a class are
// inserted, and at the hinge q *pieces*, one a group: lists of blocks on Y and the group.
//
//     class_count({.groups = 4, .size = 9}, 2);      // 27: every pair of two groups is in one
//     group_class({.groups = 4, .size = 9}, 2, 5);   // 18 pairs of the numbers 0, …, 35
//     hinges(design);                                // where pieces fit, and parts beside
//
// A piece is a circular design on g+h elements, opened where Y fits; blocks inside Y are dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

struct Groups {
  std::uint64_t groups = 0;
  std::uint64_t size = 0;
};

/// How many classes bring every two elements of different groups together: (q−1)g/(m−1), each pair
/// once, but 7 for three groups of 6. 0 if none are known: m = 2 needs an even number of elements;
/// m = 3 has those of triple_classes.hpp; m ≥ 4 needs q = m and a g in which each prime comes with
/// a power of m or more, or not at all.
[[nodiscard]] std::uint64_t class_count(const Groups& groups, std::uint64_t m);

/// Class `index` < class_count(): each element i·g+t, 0 ≤ t < g, of group i < q is in one of its
/// blocks. m = 2: 1-factors of the complete multipartite graph, made of 1-factors of a complete
/// graph on the groups or on their halves. m = 3: triple_class(). m ≥ 4: lines of slope `index`
/// (slopes.hpp). O(qg).
[[nodiscard]] std::vector<Block> group_class(const Groups& groups, std::uint64_t m,
                                             std::uint64_t index);

/// A place for pieces, and parts beside it.
struct Hinge {
  std::uint64_t at = 0;   ///< a position as in UnchangedSubset; of a linear design, b is its end
  bool reversed = false;  ///< all this is of the linear design read backwards
  Block elements;         ///< U, increasing
  std::vector<Element> positions{};  ///< of parts, increasing
};

/// At most two, at the end of a linear design and at a step, with as many parts as a greedy search
/// finds. The same design has the same ones.
[[nodiscard]] std::vector<Hinge> hinges(const Design& design);

/// A list of consecutive blocks of a design with a hole: a set of `hole.size()` elements that are
/// together elsewhere. The first block has n of them, `first`; so has the last, if the design is
/// circular.
struct OpenedPiece {
  std::size_t start = 0;
  std::size_t count = 0;
  Block hole, first, last;
};

/// How many consecutive blocks are inside a hole of h elements at the most: 0 if h < k.
[[nodiscard]] std::uint64_t most_dropped(std::uint64_t h, const Parameters& p);

/// The design without `dropped` consecutive blocks, the first ones if it is linear; nullopt if no
/// hole of h elements fits there.
[[nodiscard]] std::optional<OpenedPiece> opened(const Design& design, std::uint64_t h,
                                                std::uint64_t dropped);

/// What comes to a design W.
struct Grouping {
  Groups groups;
  Hinge hinge;
  std::uint64_t dropped = 0;  ///< so many pieces, the first ones, lack what is inside the hole
};

/// How many blocks the pieces have. `closed` and `open`: how many there are in the circular design
/// of g+h elements, and in the linear one if that is the last piece. nullopt without the designs.
[[nodiscard]] std::optional<std::uint64_t> piece_blocks(const Parameters& p, const Grouping& how,
                                                        std::uint64_t h,
                                                        std::optional<std::uint64_t> closed,
                                                        std::optional<std::uint64_t> open,
                                                        bool ends_open);

/// The blocks, on the elements of `base` and group i of g elements from base.v + ig on. `closed`
/// may be null if each piece is one block, `open` if the last piece is like the others. What does
/// not fit @throws BadInput, in one line. O(bk) time and memory.
[[nodiscard]] std::vector<Block> with_groups(const Parameters& p, const Grouping& how,
                                             const Design& base, const Design* closed,
                                             const Design* open);

/// The recipe of that. `closed`, `open`: as with_groups().
[[nodiscard]] Recipe concatenate_groups_recipe(const Parameters& p, const Grouping& how,
                                               Recipe base, std::optional<Recipe> closed,
                                               std::optional<Recipe> open);

}  // namespace changeover
