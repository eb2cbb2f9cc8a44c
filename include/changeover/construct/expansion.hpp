// Expansion sets and the recursion that they feed.
//
// An *expansion set* of an m-change covering design is a set of unchanged subsets Uᵢ (at distinct
// positions) that partitions V. In a linear design any (k−m)-subset of the first block may serve as
// U₀ and any of the last as U_b. For m = 2: if ℓ = v/(k−2) is odd, inserting Uᵢⱼ ∪ e for the edges
// e of the j-th 1-factor of K_{ℓ+1} at the j-th position turns a DCCD(v,k,b) into a DCCD(v+ℓ+1, k,
// b+ℓ(ℓ+1)/2), tight, economical or circular if the given one is [ChafeeStevens2025, Theorem 2].
//
//     ExpansionSearch search = find_expansion_sets(design, {.how_many = 1});
//     Design larger = expand(design, search.sets.front(), one_factorization(8));
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/transitions.hpp"

namespace changeover {

/// Unchanged subsets in order of position; positions are distinct. In a linear design the positions
/// 0 (before the first block) and b (after the last) are the ends of free choice. A circular design
/// has the positions 1, …, b, the last one between its last and its first block.
using ExpansionSet = std::vector<UnchangedSubset>;

/// Why `set` is not an expansion set of `design`, in one line; nullopt if it is one.
[[nodiscard]] std::optional<std::string> expansion_set_defect(const Design& design,
                                                              const ExpansionSet& set);

/// How far a search may go; by default, to the end.
struct SearchLimits {
  /// At most so many nodes. A search that needs exactly so many is complete.
  std::optional<std::uint64_t> nodes = {};
  /// Asked before the first node and then every 256 nodes; true ends the search.
  std::function<bool()> stop = {};
};

struct ExpansionSearchOptions {
  std::uint64_t how_many = 1;  ///< stop after listing this many sets; 0 lists none
  bool count = false;          ///< count all of them, too
  bool partial = false;        ///< list inclusion-maximal partial expansion sets instead
  SearchLimits limits = {};    ///< of the listing and of the counting, each
};

struct ExpansionSearch {
  std::vector<ExpansionSet> sets;      ///< those listed
  std::optional<std::uint64_t> count;  ///< of all, when asked for, complete and below 2⁶⁴
  bool complete =
      false;  ///< every set was seen, listed or counted (so an empty list proves that none
              ///< exists, if any were to be listed)
  std::string
      reason;  ///< if there are none for a simple reason ("k - m = 3 does not divide v = 10",
               ///< "element 2 is in no unchanged subset"), or why the ends were left out
};

/// Expansion sets of a design by exact cover. The same subset at two positions makes two expansion
/// sets. In a linear design the ends offer C(k,m) choices each; if these are more than 2²² elements
/// to write down, the ends are left out and the search is not complete. Steps that do not change
/// exactly m elements have no unchanged subset.
[[nodiscard]] ExpansionSearch find_expansion_sets(const Design& design,
                                                  const ExpansionSearchOptions& options = {});

/// The largest partial expansion set: disjoint unchanged subsets that together hold the most
/// elements.
struct PartialExpansion {
  ExpansionSet set;
  bool optimal = false;  ///< no larger one exists
};

/// Such a set, by branch and bound; if a limit strikes, the best so far.
[[nodiscard]] PartialExpansion largest_partial_expansion_set(const Design& design,
                                                             const SearchLimits& limits = {});

/// The recursion [ChafeeStevens2025, Theorem 2]. New elements are v, …, v+ℓ; the vertex x of the
/// factorization is the element v + x. If the design has labels, so have the new elements; see
/// expanded_labels(). The blocks at a position come in the order of the edges of its factor.
/// @throws BadInput if the set is not an expansion set of the design, or the factorization is not
/// one of K_{ℓ+1}; ImpossibleParameters if m ≠ 2, t ≠ 2 or ℓ is even.
[[nodiscard]] Design expand(const Design& design, const ExpansionSet& set,
                            const OneFactorization& factorization);

/// The labels of a design followed by those of `count` new elements: consecutive numbers from v on,
/// or from the first number at which none of them is taken (v + 1 if the labels are 1, …, v). Empty
/// if `labels` is.
[[nodiscard]] std::vector<std::string> expanded_labels(std::vector<std::string> labels,
                                                       std::uint64_t count);

/// The same as a stream over a stream, with the factorization made factor by factor: memory for the
/// set only. The design is trusted; only the shape of the set is checked.
/// @throws BadInput unless the set's positions increase and its subsets partition V into ℓ parts of
/// k − 2 elements, and, from next(), if the source ends before the last position;
/// ImpossibleParameters if m ≠ 2, t ≠ 2, ℓ is even, or v + ℓ + 1 exceeds the limit of check().
/// O(v).
[[nodiscard]] std::unique_ptr<BlockSource> expand(
    std::unique_ptr<BlockSource> source, ExpansionSet set,
    FactorizationKind kind = FactorizationKind::circle);

}  // namespace changeover
