// 1-factorizations of complete graphs: two families, a validator and two invariants.
//
// A 1-factor of K_n is a set of n/2 edges that meets every vertex once; a 1-factorization
// partitions the edges of K_n into n − 1 of them, and exists for every even n. Expansion inserts
// the edges of one 1-factor at each position of an expansion set [ChafeeStevens2025, Thm 2].
//
//     OneFactorization k8 = one_factorization(8);          // seven factors of four edges
//     OneFactor again = circle_factor(8, 3);               // k8.factors[3], without the other six
//     factorization_defect(k8);                            // nothing: checked edge by edge
//     is_perfect(k8);                                      // true: 7 is prime
//     auto other = cycle_types(one_factorization(8, FactorizationKind::doubled));
//     other.contains({4, 4});                              // true: the two kinds differ
//
// The circle kind is GK_n, the rotation of a circle of n − 1 vertices about a fixed one; the
// doubled kind joins two copies of K_{n/2}. K_2, K_4 and K_6 have only one 1-factorization up to
// isomorphism. From K_8 on the two kinds are never isomorphic. Write n = 2h. The union of two
// factors of GK_n has a cycle of length (n−1)/g + 1 and (g−1)/2 cycles of length 2(n−1)/g, g < n−1
// a divisor of n − 1.
//   - h even: shifts 0 and h/2 of the doubled kind make n/4 ≥ 2 cycles of length 4; GK_n has no
//     such union, for there the lengths are all alike only if there is one cycle.
//   - h odd and composite: shifts 1 and 1 + g, with g > 1 a proper divisor of h, make g cycles of
//     length n/g; GK_n has no such union, for the same reason.
//   - h odd and prime, n − 1 composite: the doubled kind is perfect, GK_n is not.
//   - h and n − 1 both prime (14, 38, 62, 74, …): both are perfect, so cycle types do not tell them
//     apart. But the doubled kind is vertex-transitive, x_i → x_{i+1}, y_i → y_{i+1} and x_i ↔ y_i,
//     and every automorphism of GK_n fixes the vertex in the middle. For suppose that one moves it.
//     Then one that fixes a factor F does, and takes the edge of F in the middle to another edge of
//     F, since the rotations move every factor to every other. The reflection in F fixes the ends
//     of the edge in the middle and swaps those of all other edges of F; so does its conjugate, for
//     the other edge. Their product swaps the ends of two edges and fixes n − 4 ≥ 3 vertices. But
//     an automorphism that fixes three vertices of a perfect 1-factorization fixes two factors and
//     a vertex of their Hamiltonian cycle, so it fixes everything.
//
// Not done here: other families, random 1-factorizations, canonical forms.
// References: the circle [Kotzig1964], also for when it is perfect; two copies of odd order
// [Anderson1973]; a survey of both [MendelsohnRosa1985]; existence [AkiyamaKano2011].
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace changeover {

/// An edge of a complete graph, written with the smaller vertex first.
struct Edge {
  std::uint32_t a, b;

  auto operator<=>(const Edge&) const = default;
};

/// The edges of a 1-factor, in ascending order wherever this library makes it.
using OneFactor = std::vector<Edge>;

/// A list of factors of the complete graph on 0, …, order − 1. Nothing is checked until
/// factorization_defect().
struct OneFactorization {
  std::uint32_t order = 0;
  std::vector<OneFactor> factors;

  bool operator==(const OneFactorization&) const = default;
};

/// A set of edges that meets every vertex but one exactly once.
struct NearOneFactor {
  std::uint32_t isolated = 0;
  std::vector<Edge> edges;

  bool operator==(const NearOneFactor&) const = default;
};

/// Which of the two families; see the summary above for when they differ.
enum class FactorizationKind : std::uint8_t { circle, doubled };

/// "circle" or "doubled".
[[nodiscard]] std::string_view to_string(FactorizationKind kind);

/// The kind of that name; nullopt for any other word.
[[nodiscard]] std::optional<FactorizationKind> factorization_kind_from_string(
    std::string_view name);

/// The 1-factorization of K_order of that kind.
/// @param order number of vertices, even, at least 2.
/// @throws ImpossibleParameters if order is odd or 0. O(order²) time and space.
///
/// circle: factor i is circle_factor(order, i); perfect exactly if order − 1 is 1 or prime.
/// doubled: factor i is doubled_factor(order, i); perfect exactly if order/2 is 1 or prime.
[[nodiscard]] OneFactorization one_factorization(
    std::uint32_t order, FactorizationKind kind = FactorizationKind::circle);

/// Factor i of GK_order: the edge {i, ∞}, where ∞ = order − 1 is the vertex in the middle, and the
/// edges {i−j, i+j} mod order − 1 for 1 ≤ j < order/2.
/// @throws ImpossibleParameters if order is odd or 0, BadInput unless index < order − 1.
/// O(order), however many factors there are [Kotzig1964].
[[nodiscard]] OneFactor circle_factor(std::uint32_t order, std::uint32_t index);

/// Factor i of the doubled kind. Let h = order/2, x_j = j and y_j = h + j, subscripts mod h.
///   - h odd (GA_order): for i < h the edge {x_i, y_i} and the edges {x_{i−j}, x_{i+j}} and
///     {y_{i−j}, y_{i+j}}, 1 ≤ j < h/2; for i ≥ h the shift {x_j, y_{j+d}}, d = i − h + 1.
///   - h even: for i < h − 1 circle_factor(h, i) in both copies; for i ≥ h − 1 the shift
///     {x_j, y_{j+d}}, d = i − h + 1.
/// @throws ImpossibleParameters if order is odd or 0, BadInput unless index < order − 1.
/// O(order) [Anderson1973].
[[nodiscard]] OneFactor doubled_factor(std::uint32_t order, std::uint32_t index);

/// The near-1-factorization of K_order that circle_factor(order + 1, i) leaves when ∞ is removed:
/// near-1-factor i misses vertex i and has the edges {i−j, i+j} mod order.
/// @param order number of vertices, odd.
/// @throws ImpossibleParameters if order is even. O(order²).
[[nodiscard]] std::vector<NearOneFactor> near_one_factorization(std::uint32_t order);

/// Nothing if these factors are a 1-factorization of K_order; otherwise one line that names the
/// first defect: a wrong order or number of factors; a vertex out of range, a loop, an edge written
/// the wrong way round, a vertex met twice or missed, by factor; an edge in two factors, and one in
/// none. Factors are counted from 0. Shares no code with the constructions. Linear in the input,
/// and the memory too is bounded by the input, whatever the order claims.
[[nodiscard]] std::optional<std::string> factorization_defect(
    const OneFactorization& factorization);

/// How often each cycle type occurs among the unions of two factors; a cycle type is the ascending
/// list of the cycles' lengths. Isomorphic 1-factorizations have equal cycle types, not conversely.
/// @throws BadInput if factorization_defect() finds one. O(order³).
[[nodiscard]] std::map<std::vector<std::uint32_t>, std::uint64_t> cycle_types(
    const OneFactorization& factorization);

/// Whether the union of every two factors is a Hamiltonian cycle (true for K_2).
/// @throws BadInput if factorization_defect() finds one. O(order³), less when it is not perfect.
[[nodiscard]] bool is_perfect(const OneFactorization& factorization);

}  // namespace changeover
