// A lower bound on the cost of a job, with its reason.
//
//     CostBound bound = cost_bound(make_job(9, 3, parse_amount("10"), parse_amount("1")));
//     to_string(bound.cost);                    // "145": 12 tests and 25 changes
//
// Proof. Let F be the parts that do not stay mounted, f the number of those that do, K = at_once − f the
// room for F, capped by the number of colours that colour the graph of pairs of F that may meet (a
// set-up is a clique of it), P the number of needed pairs within F, d_x the number of needed pairs at x,
// S the parts of F that are mounted at the start. Consider a cheapest list of T set-ups, and of these
// one with the fewest introductions; let it introduce parts of F I times, part x i_x times.
//  (1) *Pairs.* A step that introduces j parts newly covers at most p(j) = C(j,2) + j(K − j) pairs,
//      and the first one at most C(j,2) + j·s + min(C(s,2), needed pairs within S), s = min(|S|, K − j).
//      p is concave, so I introductions in T steps cover the most if the steps after the first are as
//      equal as can be. This gives I ≥ I(T), the fewest introductions by which T steps can cover P.
//  (2) *Tests.* Part x meets at most K − 1 parts a test, so it is in at least ⌈d_x / (K − 1)⌉ tests (in
//      one if it has only pairs with mounted parts), and a test holds K: T ≥ ⌈Σ_x ⌈d_x/(K−1)⌉ / K⌉. If all
//      pairs are needed this is the bound of Schönheim [Schonheim1964].
//  (3) *Introductions.* Each part with a needed pair that is not in S is introduced at least once.
//  (4) If all pairs of n > K parts of F are needed and no other, and |S| ≤ K: I + |S| ≥ K − 1 + b for the least number
//      b of blocks of a linear SCCD(n,K) (bounds/lower_bound.hpp). For put S before the list and restrict
//      it to the n parts. While some set-up B_i has fewer than K of them, add to it a part of B_{i−1} or
//      of B_{i+1} that it lacks: this introduces nothing that was not introduced before. If it lacks none,
//      it contains both neighbours, which can be filled from it likewise; were this to end before all are
//      full, all would be the same set of fewer than n parts. Now take out repetitions and refine each
//      step of j changes into j steps of one: a linear SCCD of 1 + (I + |S| − K) blocks.
//  (5) *Costs.* Every introduction of x makes x meet some needed part at last: else take it away, up to
//      where it leaves, and the list is cheaper or has fewer introductions. So i_x ≤ d_x, and I
//      introductions cost at least one of each part of (3), and the others at the lowest costs that these
//      limits allow.
//  (6) *Degrees.* Where x is introduced it meets at most K − 1 parts of F, where it stays at most the j
//      parts that come: Σ_x max(0, d_x − (K−1)·i_x) ≤ Y, d_x within F, where Y is the sum of j(K − j) over
//      all steps, at the first one j·s + 2·min(C(s,2), needed pairs within S). For given T and I this is
//      the most if the steps after the first are as equal as can be. So introductions beyond the first
//      of each part must make up for Σ_x d_x − Y; an introduction of x makes up for K − 1 at most, for
//      d_x in all. The cheapest way, if parts of an introduction could be had, bounds their cost.
//  (7) *Stays.* Among parts of F of which every two must meet, at most K come once only, and so on for two, three,
//      … times [docs/theorems.md, Theorem 5]; with the price of each part this is a linear program with a
//      solution in closed form (src/plan/search/bounds/stays_cost.hpp). The parts at the start count as a set-up; if
//      they are more than K, they count instead of K.
//  (8) *Steps.* In a cheapest list with fewest introductions and then fewest tests, every set-up after the first
//      introduces a part with a needed pair; else take it away. So I ≥ T − 1 + e, where e is what the first
//      one introduces at least: what the slots need and is not at the start, and if nothing is, the parts of F of a pair.
// *Slots.* K is also at most the sum, over the slots, of the most parts of F with a needed pair that a set-up has of
// it, and of those in no slot; parts without a needed pair that some slot needs take room, and are mounted once at
// least. In (2), x meets at most so many parts of a slot a test, and a test holds at most so many; so each slot
// by itself bounds the tests. In (5), i_x ≤ d_x falls away for parts of slots that need some. All else is true of any
// list, and so of those that obey the slots.
// *First set-ups.* If some set-ups must come first, the bound is what they cost and that of what is left after them.
// *What is replaced.* If costs depend on it, each introduction of x costs at least the least of x's own cost and of those in place
// of any part that does not stay mounted, which is never taken out. The bound is that at these prices.
// The bound, rounded up to a multiple of what divides all costs, is the least of T·test + (the largest of (5), (6) and (7)) over T ≥ (2) and I ≥ I(T), (3), (4), (8). With
// forbidden pairs, pairs that need not meet, a start or tests already done, (4) falls away unless its
// condition holds as it stands; the others stay true. (6) is left out of large jobs, where it takes long.
#pragma once

#include <cstdint>
#include <string>

#include "changeover/plan/job.hpp"

namespace changeover {

struct CostBound {
  Amount cost;
  std::uint64_t tests = 0;          ///< no list has fewer
  std::uint64_t introductions = 0;  ///< no list has fewer
  std::string reason;               ///< one line with the numbers filled in
};

/// No list of set-ups that does the job costs less. If the scope of this thread (run/scope.hpp) wants to stop,
/// the bound is that of (2), (3) and (5), which is known soon.
/// @throws BadInput as check(); ImpossibleParameters if a cost overflows. O(P·K).
[[nodiscard]] CostBound cost_bound(const Job& job);

}  // namespace changeover
