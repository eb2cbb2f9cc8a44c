// What plans for several benches cost at least, and when they are done at the earliest.
//
// Costs. Let every part have its least cost of any bench, every test its own, and a set-up as much
// room and as wide slots as on any; what some bench need not have mounted need not be. All lists
// put end to end are a list of that job which costs no more, if no bench has anything at its start
// but the first; what is at the start of others is put in once more with one test: cost_bound().
// And counted within the dearest parts (bounds/dearest_parts.hpp), n lists cost at least b_n, n the
// number of benches that are used after the first set-ups; b_n grows with n. What the first set-ups
// of a bench cost comes on top.
//
// Makespan M. A bench works at most u_w(M) hours by then, by its hours a day, and what it does
// there costs at least φ_w times what it costs by the least costs, φ_w the least ratio of its costs
// to these.
//  (1) *Shared.* For some n, the n benches that can do most do b_n: Σ (u_w(M) − first_w) / φ_w ≥
//    b_n.
//  (2) *Side by side.* If each set-up has at least l of some parts of which benches can hold h at a
//      time, at most ⌊h/l⌋ benches work at a time: ⌊h/l⌋ of them would have to do everything.
//  (3) *A scarce part.* A part that must meet d others is in at least ⌈d/(K−1)⌉ tests. In s stays
//      it meets up to K−1 others that are there when it comes, for each of its stays; the others
//      are put in while it is there. So it is held for a time that is the least over s; at most h
//      benches hold it at a time, so h·M is at least as much.
//  (4) *One pair.* Some bench tests the dearest pair.
//  (5) *Pairs.* All benches together test no more pairs within u_w(M) than the sum of what each can
//    (most_pairs_within).
//  (6) *Whole tests.* A bench that rests ends no day within a step. A step takes at least a test
//      and the cheapest part, so a day has only so many, and all benches together need so many
//      tests.
#pragma once

#include <string>

#include "changeover/plan/benches.hpp"
#include "plan/search/benches/bench_field.hpp"

namespace changeover {

struct BenchBounds {
  CostBound cost;  ///< of all benches together, their first set-ups included
  Amount makespan;
  std::string makespan_reason;  ///< in one line
};

/// If the scope of this thread (run/control.hpp) wants to stop, what is known soon.
[[nodiscard]] BenchBounds bench_bounds(const BenchField& field);

}  // namespace changeover
