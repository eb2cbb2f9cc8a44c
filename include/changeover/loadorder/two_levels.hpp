// Load orders for two levels: items lie on a disk, C of them fit into memory, and c ≤ C of these on
// an accelerator, where every pair must be together at some time.
//
//     LoadOrder order = plan_two_levels(200, 40, 8);
//     order.facts().loads;                     // from the disk
//     order.facts().transfers;                 // from memory to the accelerator
//     check_schedule(*order.stream(), order.rules()).valid();                    // true
//
// *A step.* Items leave the accelerator; items leave memory; items are loaded from the disk; items
// are transferred to the accelerator; then the pairs are computed that are there together for the
// first time, which StepWork lists (loadorder/step_work.hpp). What is on the accelerator stays in
// memory.
//
// *Bounds.* What is in memory brings every pair together, too: loads are at least
// load_lower_bound(P, C), and transfers at least load_lower_bound(P, c).
//
// *How.* The items are in G groups of g. An order of groups, with room for ⌊C/g⌋ of them, says what
// is loaded. When it has loaded a group, the pairs of its items with those of the groups that it
// now meets for the first time are done at once: c − 1 of its items stay on the accelerator while
// all others pass (plan_load_order() for two sets, or for new items). What the accelerator still
// has is not transferred again. Groups of one item make loads few and transfers many, one a pair;
// groups of C/2 items the other way round. From g ≈ c − 1 on a transfer brings some c − 1 pairs,
// and as long as g is much less than C a load brings some C − 1. Of the sizes that are tried the
// one with the least loads / bound + transfers / bound is taken. Where c is not much less than C no
// size does well; then the order for the accelerator alone, plan_load_order(P, c), may be better,
// with memory as a cache from which goes what is needed last.
#pragma once

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// The best order that is known, verified by ScheduleCheck: every pair meets on the accelerator; of
/// up to 7,746 items the pairs that StepWork lists, too. @throws BadInput unless 2 ≤ fast_room ≤
/// room and items ≥ 1; ImpossibleParameters above 65,535 items.
[[nodiscard]] LoadOrder plan_two_levels(std::uint64_t items, std::uint64_t room,
                                        std::uint64_t fast_room);

}  // namespace changeover
