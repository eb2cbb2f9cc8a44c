// Lower bounds on the cost and the makespan of plans for several benches.
//
// Costs. Give every part its least cost on any bench, every test its least cost, and a set-up the
// largest room and the widest slots; parts that some bench need not mount need not be mounted. All
// lists, end to end, are a list of that job which costs no more, if no bench but the first has
// anything at its start. Parts at the start of other benches are charged once more, with one test:
// cost_bound(). Counted by the most expensive parts (bounds/costliest_parts.hpp), n lists cost at
// least b_n,
// where n is the number of benches that are used after the first set-ups; b_n grows with n. The
// cost of the first set-ups of each bench is added.
//
// Makespan M. By then a bench has worked at most u_w(M) hours, given its hours per day. Its work
// costs at least φ_w times its cost at the least costs, where φ_w is the least ratio of its costs
// to these.
//   (1) *Shared.* For some n, the n most productive benches do b_n: Σ (u_w(M) − first_w) / φ_w ≥
//   b_n.
//   (2) *Side by side.* n benches at work have n different set-ups mounted, and a part is in at
//   most
//       min(h, n) of them if benches can hold h of it at a time. If each set-up has at least l of
//       some parts, Σ min(h, n) ≥ n·l over these. The n benches of the largest such n would have to
//       do everything, each with the least φ if benches rest.
//   (3) *A scarce part.* A part that must meet d others is in at least ⌈d/(K−1)⌉ tests. In each of
//   s
//       stays it meets up to K−1 others that are there when it comes; the others are put in while
//       it is there. So it is held for a time that is the least over s. At most h benches hold it
//       at a time, so h·M is at least this time.
//   (4) *One pair.* Some bench tests the most expensive pair.
//   (5) *Pairs.* All benches together test at most the sum of the pairs that each can test within
//       u_w(M) (most_pairs_within).
//   (6) *Whole tests.* A bench that rests does not end a day within a step. A step takes at least a
//       test and the cheapest part, which limits the steps per day, and all benches together need a
//       number of tests.
//   (7) *Shared parts.* Two parts that must meet are together on one bench at some time. What the
//       fullest bench must put in and test then is an integer program (docs/theorems.md,
//       Theorem 26).
#pragma once

#include <string>

#include "changeover/plan/benches.hpp"
#include "plan/search/benches/bench_field.hpp"

namespace changeover {

struct BenchBounds {
  CostBound cost;  ///< for all benches together, including their first set-ups
  Amount makespan;
  std::string makespan_reason;  ///< one line
};

/// If the scope of this thread (run/control.hpp) requests a stop, uses only bounds that take little
/// time.
[[nodiscard]] BenchBounds bench_bounds(const BenchField& field);

}  // namespace changeover
