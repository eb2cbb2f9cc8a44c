// What others do: load orders from their published descriptions, to be measured against.
//
//     LoadOrder beta = beta_order(20, 5);
//     beta.facts().loads - 5 + 1;              // 52 blocks
//
//   beta      BETA [MohoneyEtAl2021]: keep C−1 items, pass all others through the last place,
//             replace the C−1 by others that are not done, repeat on the rest
//   hold      hold C−1 items and stream the rest, repeat: what one writes down first; where the
//             held items change, the one that passed last is held too
//   tiles     square tiles of ⌊C/2⌋ by ⌊C/2⌋ items, row by row, with a least-recently-used cache of
//             C
//   exhaustive  every block of ⌊C/2⌋ against every block, in both orders of the two, half of the
//             pairs each time, with a least-recently-used cache of C: exhaustive matching in COLMAP
//             [SchonbergerFrahm2016], whose blocks have 50 images
//
//   comet     COMET [WaleffeEtAl2023]: BETA of groups of items, which come and go together
//   cover     COVER [ZhengEtAl2024], which trains on several GPUs with 4 partitions each: P = 4^d
//             partitions are the points of the affine space over the field of 4 elements, its lines
//             are what a GPU holds, one parallel class of lines after another
//
// Written from the descriptions, for comparison: nothing in the library plans with them. All are
// load orders in the sense of loadorder/load_order.hpp, held in memory step by step.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// Each takes at most 65,535 items. @throws as load_lower_bound(), ImpossibleParameters above that.
[[nodiscard]] LoadOrder beta_order(std::uint64_t items, std::uint64_t room);
[[nodiscard]] LoadOrder hold_order(std::uint64_t items, std::uint64_t room);
[[nodiscard]] LoadOrder tiles_order(std::uint64_t items, std::uint64_t room);
[[nodiscard]] LoadOrder exhaustive_order(std::uint64_t items, std::uint64_t room);

/// Groups of `group` items each. @throws BadInput unless `group` divides items and room, and two
/// groups have room; ImpossibleParameters as above
[[nodiscard]] LoadOrder comet_order(std::uint64_t items, std::uint64_t room, std::uint64_t group);

/// Room for 4, one worker; all four items of a line are loaded. @throws BadInput unless items is 4,
/// 16, 64, …; ImpossibleParameters as above
[[nodiscard]] LoadOrder cover_order(std::uint64_t items);

/// All of them but COMET and COVER, in this order; facts().method is the name above.
[[nodiscard]] std::vector<LoadOrder> baseline_orders(std::uint64_t items, std::uint64_t room);

}  // namespace changeover
