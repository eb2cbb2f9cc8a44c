// What the introductions of parts cost at least, counted within the dearest parts: for one list of
// set-ups or several.
//
// Proof. Let n lists of T set-ups in all test every needed pair of parts of F (those that do not
// stay mounted), K the room for them, each list beginning on an empty bench; x is introduced i_x
// times, I = Σ i_x. (A bench where something is mounted at the start begins empty with that set-up,
// which is one test more and costs what it costs: both are taken off again.) Let X be any set of
// parts of F, I_X their introductions, P_X the needed pairs within X.
//  (a) One by one: in the order of introductions, within a step in any order, each of X meets at
//      most the K − 1 others of X that are there, the first ones of a list fewer:
//      P_X ≤ (K−1)·I_X − K(K−1)/2 if I_X > K. For n lists and X = F, each list but those that
//      introduce only two parts loses K(K−1)/2.
//  (b) By steps: a step that introduces j of X tests at most p(j) = C(j,2) + j(K−j) pairs of X, the
//      first one of a list at most C(j,2). p is concave.
//  (c) Degrees: x meets at most K−1 parts of F when it is introduced, and while it stays those j
//      that come: Σ_{x∈X} (d_x − (K−1)·i_x) ≤ Y, the sum of j(K−j) over all steps but the first of
//      each list.
//  (d) Stays: if every two parts of X must meet, Σ_{x∈X} (s+1−i_x) ≤ c_s for every s
//      [docs/theorems.md, Theorem 5].
//  (e) i_x ≥ 1, and in a cheapest plan with fewest introductions i_x ≤ d_x, unless slots need
//      parts; each step introduces something.
// Each of them bounds I_X from below, given T and I. Let X_t be the t dearest parts, S_t their
// introductions. The cost Σ c_x·i_x is Σ_t (c_t − c_{t+1})·S_t, prices falling, and so least where
// every S_t is as small as (a) to (e) allow at once: the bound is the least over T and I.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// What lists of set-ups have to do.
struct DearestParts {
  std::uint64_t room = 0;                ///< K, and no less than what is at the start of a bench
  std::vector<Element> parts = {};       ///< of F, each with a needed pair
  std::vector<Amount> prices = {};       ///< by number in `parts`
  std::vector<std::uint64_t> most = {};  ///< by number in `parts`: (e), how often it comes at most
  std::vector<std::uint64_t> at_start =
      {};  ///< by number in `parts`: on how many benches it is at the start
  std::vector<bool> together = {};  ///< by number in `parts`: of a set of which every two must meet
  const PairSet* needed = nullptr;
  Amount test = {};
  std::uint64_t starts = 0;               ///< benches with some of the parts at the start
  std::uint64_t least_tests = 0;          ///< of all lists
  std::uint64_t least_introductions = 0;  ///< of all parts and lists, with those at the start
  std::uint64_t first =
      1;  ///< introductions of a list's first step at least, if none has a start; 1 to K
};

/// The parts of a job for one bench; `mounting` is what the parts that stay mounted cost once.
/// Nothing if nothing must meet within F.
[[nodiscard]] std::optional<DearestParts> dearest_parts_of(const Job& job, Amount& mounting);

/// Takes the bound for one list, if it is better, with its reason. @throws Stopped
void raise_by_dearest(const Job& job, CostBound& bound);

/// The most parts for which the bound is looked for: it takes O(tests · introductions · parts) at
/// worst.
inline constexpr std::size_t most_dearest_parts = 200;

struct DearestCost {
  Amount cost;  ///< of tests and of introductions of F
  std::uint64_t tests = 0;
  std::uint64_t introductions = 0;
};

/// For so many lists, none of which is empty. Stopped if the scope of this thread (run/control.hpp)
/// wants to stop.
/// @throws ImpossibleParameters if a cost overflows.
[[nodiscard]] DearestCost cost_of_dearest(const DearestParts& question, std::uint64_t lists);

}  // namespace changeover
