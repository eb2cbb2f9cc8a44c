// Resolvable group-divisible designs of triples: partitions of q groups of g elements into triples.
//
// A *class* is a partition of all elements into triples that have no two elements of a group, and
// every two elements of different groups are in a triple of some class. If q ≥ 3, g(q−1) is even,
// qg is divisible by 3 and (g, q) is not (2, 3), (2, 6) or (6, 3), there are g(q−1)/2 classes that
// have each pair once; [Rees1993] is the last of several papers. Known here are
//
//   - lines of slope d through three groups (slopes.hpp);
//   - three groups of 10, by two orthogonal Latin squares [Parker1959], and three of 6, where 7
//     classes, found by annealing, have each pair once or more;
//   - *written* ones, of at most 60 elements: a few classes, found by annealing, that a cyclic
//     group turns into all of them;
//   - those of (g/n, q) with n elements for each, in lines through the three of each triple.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// How many classes are known for q groups of g elements; 0 if none are. O(√g) and a look into the
/// table of written ones.
[[nodiscard]] std::uint64_t triple_class_count(std::uint64_t q, std::uint64_t g);

/// Class `index` < triple_class_count(q, g). Element j < g of group i < q is i·g + j. No triples
/// if no classes are known. O(qg).
[[nodiscard]] std::vector<Block> triple_class(std::uint64_t q, std::uint64_t g,
                                              std::uint64_t index);

}  // namespace changeover
