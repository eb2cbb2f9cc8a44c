// A lower bound on the cost of introductions, counted by the most expensive parts: for one list of
// set-ups
// or several.
//
// Proof. Let n lists with T set-ups in total test every needed pair of parts of F (those that do
// not stay mounted). Let K be the room for F, let each list begin on an empty bench, let x be
// introduced i_x times, and I = Σ i_x. (A bench with a start begins empty with that set-up: one
// more test, and the cost of mounting it; both are subtracted again.) Let X be any set of parts of
// F, I_X their introductions, P_X the needed pairs within X.
//   (a) One by one: in the order of introductions (any order within a step), each part of X meets
//   at
//       most the K − 1 others of X that are there, and fewer at the beginning of a list:
//       P_X ≤ (K−1)·I_X − K(K−1)/2 if I_X > K. For n lists and X = F, each list but those that
//       introduce only two parts loses K(K−1)/2.
//   (b) By steps: a step that introduces j parts of X tests at most p(j) = C(j,2) + j(K−j) pairs of
//       X, and the first step of a list at most C(j,2). p is concave.
//   (c) Degrees: x meets at most K−1 parts of F when it is introduced, and while it stays, the j
//       parts that are introduced: Σ_{x∈X} (d_x − (K−1)·i_x) ≤ Y, the sum of j(K−j) over all steps
//       but the first of each list.
//   (d) Stays: if every two parts of X must meet, Σ_{x∈X} (s+1−i_x) ≤ c_s for every s
//       [docs/theorems.md, Theorem 5].
//   (e) i_x ≥ 1 and, in a cheapest plan with the fewest introductions, i_x ≤ d_x, unless slots need
//       parts; each step introduces something.
//
// Each of these bounds I_X from below, given T and I. Let X_t be the t most expensive parts and S_t
// their
// introductions. With decreasing prices, the cost Σ c_x·i_x is Σ_t (c_t − c_{t+1})·S_t. It is least
// where every S_t is as small as (a) to (e) allow: the bound is the minimum over T and I.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The task of lists of set-ups.
struct CostliestParts {
  std::uint64_t room = 0;           ///< K, at least the number of parts at the start of a bench
  std::vector<Element> parts = {};  ///< of F, each with a needed pair
  std::vector<Amount> prices = {};  ///< by index in `parts`
  std::vector<std::uint64_t> most = {};  ///< by index in `parts`: (e), the most introductions
  std::vector<std::uint64_t> at_start =
      {};                           ///< by index in `parts`: number of benches with it at the start
  std::vector<bool> together = {};  ///< by index in `parts`: in a set of which every two must meet
  const PairSet* needed = nullptr;
  Amount test = {};
  std::uint64_t starts = 0;               ///< number of benches with some of the parts at the start
  std::uint64_t least_tests = 0;          ///< for all lists
  std::uint64_t least_introductions = 0;  ///< for all parts and lists, including those at the start
  std::uint64_t first =
      1;  ///< least introductions in the first step of a list, if none has a start; 1 to K
};

/// The data for one bench; `mounting` receives the cost of mounting the permanent parts once.
/// Nullopt if nothing must meet within F.
[[nodiscard]] std::optional<CostliestParts> costliest_parts_of(const Job& job, Amount& mounting);

/// Takes the bound for one list with its reason, if it is better. @throws Stopped
void raise_by_costliest(const Job& job, CostBound& bound);

/// Limit for the number of parts: the bound takes O(tests · introductions · parts) in the worst
/// case.
inline constexpr std::size_t most_costliest_parts = 200;

struct CostliestCost {
  Amount cost;  ///< of tests and of introductions of F
  std::uint64_t tests = 0;
  std::uint64_t introductions = 0;
};

/// For this many lists, none of them empty. Stopped if the scope of this thread (run/control.hpp)
/// requests it. @throws ImpossibleParameters if a cost overflows.
[[nodiscard]] CostliestCost cost_of_costliest(const CostliestParts& question, std::uint64_t lists);

}  // namespace changeover
