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

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"

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
  /// At most this many nodes. A search that needs exactly this number is complete.
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

/// The expansion (expand()) as a stream over the stream of a design; the factorization is made
/// factor by factor. Memory for the set only. The design is trusted; only the shape of the set is
/// checked. @throws BadInput unless the set's positions increase and its subsets partition V into ℓ
/// parts of k − 2 elements, and, from next(), if the source ends before the last position;
/// ImpossibleParameters if m ≠ 2, t ≠ 2, ℓ is even, or v + ℓ + 1 exceeds the limit of check().
/// O(v).
[[nodiscard]] std::unique_ptr<BlockSource> expand(
    std::unique_ptr<BlockSource> source, ExpansionSet set,
    FactorizationKind kind = FactorizationKind::circle);

// Partial expansion: the recursion with unchanged subsets that cover V but need not partition it.
//
// Let U₁, …, U_ℓ be unchanged subsets of a DCCD(v,k,b) at distinct change positions that together
// cover V; they may overlap. Let X be w new elements, w even. Give each position a 1-factor of K_w
// so that all w − 1 factors of a 1-factorization are used, extra positions repeating one (ℓ ≥ w−1),
// and insert U_j ∪ e for the edges e of its factor. The result is a DCCD(v+w, k, b + ℓw/2) of the
// same kind, with
//   total excess = old excess + (ℓ(k−2) − v)·w + (ℓ−w+1)·w/2.
// With a partition and w = ℓ + 1 this is [ChafeeStevens2025, Theorem 2]; with ℓ even, w = ℓ costs
// an excess of only ℓ/2. From the tight circular DCCD(15,5,15), five intervals and w = 4:
//
//     std::optional<UnchangedCover> cover = find_cover(design, {.new_elements = 4});
//     Design larger = expand_by(design, *cover, 4);        // a circular DCCD(19,5,25), economical
//
// What is offered for other m, w and ℓ. Each inserted block is U_j with m further elements, but for
// those of the sweep.
//   w ≤ m         one block a position, U_j ∪ X with m − w old elements that are in neither block
//                 beside it: b + ℓ blocks. For m = 1, w = 1 see [PreeceEtAl1995].
//   m = 2, w odd  (w+1)/2 blocks a position: the edges of a near-1-factor of K_w, and its unmatched
//                 element beside an old one. With ℓ ≥ w each of the w near-1-factors is used.
//   m = 2, few ℓ  if ℓ is too small for all factors and k ≥ 4, the blocks at one position wander
//                 off through X, so that its pairs are covered too: the *sweep*.
//   m = 1, w > 1  U_j ∪ {x} for every x in X at every position, and a sweep.
//   m ≥ 3, w > m  not offered.
//
// *Elements left out.* The old elements that come beside unmatched new ones can do the work of
// unchanged subsets: an element of V that is in no U_j is served all the same if it stands beside
// each new element once. So with w odd, ℓ ≥ w subsets may leave out ⌊ℓ/w⌋ elements (for w < m,
// (m−w)ℓ of them). For m = 1 one element may be left out, the one that leaves at the sweep, for it
// can wander along: that saves a position for one block more.
//
// Deliberately not done: a least sweep (it is hold-and-stream), and inserting where a subset of k−m
// elements of an inner block is not unchanged.

/// Unchanged subsets that cover V, but for elements that are served otherwise. Positions are those
/// of ExpansionSet: 0 and b are the ends of a linear design, b of a circular one is its last step.
struct UnchangedCover {
  /// In order of position, positions distinct.
  std::vector<UnchangedSubset> subsets;
  /// The old elements that come beside unmatched new ones, for each subset: at most m − w of them
  /// if w < m, at most one if m = 2 and w is odd. Increasing. Elements that are not given here are
  /// chosen during the expansion; if this is empty, all of them are.
  std::vector<Block> beside = {};
  /// The index in `subsets` of the subset at whose position there is a sweep. Without a sweep it
  /// has no meaning.
  std::size_t sweep = 0;
  /// True if fewer subsets are proved not to suffice, apart from positions added because w is
  /// large.
  bool minimum = false;

  bool operator==(const UnchangedCover&) const = default;
};

struct CoverOptions {
  std::uint64_t new_elements = 2;  ///< w: how many may be left out, and how many positions it takes
  /// Limits of each search; nodes are those of the exact cover, and of the branch and bound.
  SearchLimits limits{.nodes = 200'000, .stop = {}};
  /// Designs with more than so many elements times unchanged subsets get a greedy cover only.
  std::uint64_t exact_up_to = std::uint64_t{1} << 18;
};

/// The fewest unchanged subsets that serve w new elements: an exact cover where there is one, else
/// a least set cover by branch and bound (from a greedy one; each subset covers at most k − m of
/// what is uncovered), else, when a limit strikes, the best so far. In a linear design the ends
/// offer any (k−m)-subset of the first and of the last block, one each. Further positions are added
/// if w takes them, or if they cost less than a sweep. nullopt: there is none, because elements are
/// in no unchanged subset and cannot be left out, or there are too few positions.
/// @throws ImpossibleParameters if w does not fit; see blocks_added().
[[nodiscard]] std::optional<UnchangedCover> find_cover(const Design& design,
                                                       const CoverOptions& options = {});

/// Why this cover does not serve to add w new elements, in one line; nullopt if it does.
/// @throws ImpossibleParameters as blocks_added().
[[nodiscard]] std::optional<std::string> cover_defect(const Design& design,
                                                      const UnchangedCover& cover, std::uint64_t w);

/// How many of the elements of V a cover of ℓ = `subsets` subsets may leave out; see the summary.
/// For m = 1 it is 1 if w > 1. @throws as blocks_added().
[[nodiscard]] std::uint64_t may_be_left_out(const Parameters& p, std::uint64_t subsets,
                                            std::uint64_t w);

/// The number of positions that w takes at least: 1, unless m = 2, w > 2 and there can be no sweep
/// (k = 3, or w is odd and v < k + 3); then w − 1 if w is even and w if w is odd.
/// @throws as blocks_added().
[[nodiscard]] std::uint64_t least_positions(const Parameters& p, std::uint64_t w);

/// The number of blocks that expand_by() adds: ℓ for w ≤ m, and ℓ⌈w/2⌉ for m = 2, ℓ ≥ w − 1 (w odd:
/// ℓ ≥ w). With a sweep one of the ℓ positions takes, for m = 1 and N = w, 2N − 1 blocks if N ≤ k,
/// min(4N − 2k, 2N + k − 1) if k < N < 2k, about N²/2(k−1) + 2N beyond; for m = 2 the same with
/// N = ⌈w/2⌉ and ⌊k/2⌋ for k. For m = 1 with an element left out N = w + 1, less one block.
/// @param p of the smaller design.
/// @param subsets ℓ; fewer than least_positions() count as that number.
/// @throws ImpossibleParameters if w = 0, t ≠ 2, m = k, m ≥ 3 and w > m, v + w exceeds the limit of
/// check(), or w < m and v < k + 2m − w, for then there is nothing to put beside.
[[nodiscard]] std::uint64_t blocks_added(const Parameters& p, std::uint64_t subsets,
                                         std::uint64_t w, bool left_out = false);

/// The design with w new elements v, …, v+w−1. If it has labels, so have they; see
/// expanded_labels(). Further positions are used if there are fewer than least_positions().
/// @throws BadInput if cover_defect() finds one, or there are not enough positions;
/// ImpossibleParameters as blocks_added().
[[nodiscard]] Design expand_by(const Design& design, const UnchangedCover& cover, std::uint64_t w,
                               FactorizationKind kind = FactorizationKind::circle);

/// The expansion by w elements (expand_by()) as a stream over the stream of a design, factors made
/// one at a time. Memory for the cover and for the blocks at one position. The design is trusted;
/// the shape of the cover is checked at once, and that its subsets are in the blocks beside them
/// when they are reached, by next(). @throws BadInput if the cover's shape does not fit or it has
/// fewer than least_positions(); ImpossibleParameters as blocks_added().
[[nodiscard]] std::unique_ptr<BlockSource> expand_by(
    std::unique_ptr<BlockSource> source, UnchangedCover cover, std::uint64_t w,
    FactorizationKind kind = FactorizationKind::circle);

/// How many new elements to add, and what comes of it.
struct NewElements {
  std::uint64_t w = 0;
  std::uint64_t b = 0;            ///< of the larger design
  std::uint64_t lower_bound = 0;  ///< of its parameters; bounds/lower_bound.hpp
  UnchangedCover cover;
};

/// The w of from, …, to with the least b / lower_bound, the smallest such w; nullopt if none of
/// them can be added. One cover search for all even w and one for each odd w ≤ ℓ.
/// @throws BadInput unless 1 ≤ from ≤ to.
[[nodiscard]] std::optional<NewElements> best_new_elements(const Design& design, std::uint64_t from,
                                                           std::uint64_t to,
                                                           const CoverOptions& options = {});

/// The size of interval_cover(), without making it.
struct IntervalCoverSize {
  std::uint64_t subsets = 0;
  bool left_out = false;  ///< some elements are in no subset

  bool operator==(const IntervalCoverSize&) const = default;
};

/// The cover of Z_v by intervals for the cyclic families: c base blocks over Z_v that contain
/// A = {0, …, n−1}, n = k − m, the last one n too, so that the unchanged subset at position p is
/// A + ⌊p/c⌋. ⌈v/n⌉ intervals suffice, and fewer where elements may be left out.
/// @param p circular, of the smaller design.
/// @return nullopt if w does not fit, or cv positions are too few. O(1).
[[nodiscard]] std::optional<IntervalCoverSize> interval_cover_size(const Parameters& p,
                                                                   std::uint64_t c,
                                                                   std::uint64_t w);

/// The cover that interval_cover_size() counts. O(v).
/// @param points the elements of the base blocks besides A; asked only if elements are left out.
/// @throws BadInput if the points do not suit, or interval_cover_size() has no answer.
[[nodiscard]] UnchangedCover interval_cover(const Parameters& p, std::uint64_t c, std::uint64_t w,
                                            const IntervalDevelopedSource::Points& points);

/// The size of interval_cover_for_one_more(), without making it; nullopt if there is none. O(1).
[[nodiscard]] std::optional<std::uint64_t> interval_cover_for_one_more_size(const Parameters& p,
                                                                            std::uint64_t c,
                                                                            std::uint64_t w);

/// For m = 2, w even: a cover of the design that expand_by() makes with interval_cover(p, c, w),
/// for one more element x. The w new elements are in no unchanged subset, but as x comes with
/// another element in each of its blocks, they can be left out. ⌈(v+w)/(k−1)⌉ blocks are then
/// enough for x, if they are not fewer than w; w + 1 new elements at once would take ⌈v/(k−2)⌉
/// blocks more than w.
/// @throws BadInput if interval_cover_for_one_more_size() has no answer. O(v).
[[nodiscard]] UnchangedCover interval_cover_for_one_more(
    const Parameters& p, std::uint64_t c, std::uint64_t w,
    const IntervalDevelopedSource::Points& points);

// A larger design out of one of yours: by an expansion set, or by unchanged subsets that overlap.
//
//     Enlarged larger = enlarge(design);  // by as many elements as serve it best
//     Enlarged by_four = enlarge(design, {.new_elements = 4});  // by four
//     larger.design.block_count();  larger.at.size();  // the positions where blocks were inserted
//
// If the number of new elements is left open and m = 2, the recursion of [ChafeeStevens2025,
// Theorem 2] is taken (construct/expansion.hpp), provided that there is an expansion set with an
// odd number of members. Otherwise, and for a number that is asked for, subsets that cover V and
// may overlap serve (construct/expansion.hpp).
//
// Contract: a larger design out of a valid one. Neither is verified here.

struct EnlargeOptions {
  /// How many elements are inserted at subsets that may overlap; 0: the best number up to 2k + 2.
  /// nullopt: they are inserted at an expansion set if there is one, and else as for 0.
  std::optional<std::uint64_t> new_elements = {};
  /// Only the expansion set with this number is used. They are numbered from 1, in the order in
  /// which they are found. nullopt: the first one, if there is any.
  std::optional<std::uint64_t> set = {};
  FactorizationKind factorization = FactorizationKind::circle;  ///< of the new elements
  SearchLimits limits = {};  ///< of each search; without nodes, 200,000 for subsets that overlap
};

struct Enlarged {
  Design design;
  ExpansionSet at;                 ///< the unchanged subsets that new elements were put beside
  std::uint64_t new_elements = 0;  ///< v of the design less v of yours
  bool by_expansion_set =
      false;  ///< the subsets partition the elements, and all 1-factors came once
};

/// The larger design; its new elements come last. Bound by the search for subsets, which is
/// exponential in the worst case.
/// @throws BadInput if `set` is 0 or comes with `new_elements`; MissingResource if there are fewer
/// expansion sets than `set`, or it has an even number of members, or m is not 2, or the new
/// elements cannot be inserted, with the reason; ImpossibleParameters as blocks_added().
[[nodiscard]] Enlarged enlarge(const Design& design, const EnlargeOptions& options = {});

}  // namespace changeover
