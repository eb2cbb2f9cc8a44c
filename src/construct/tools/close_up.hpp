// One element fewer, and fewer blocks: the stays of a single-change design, closed up.
//
//     closed_up(design, 7)->block_count();      // design.block_count() − (stays of 7), or fewer
//
// Take the stays of a linear single-change design in the order in which they begin, without those
// of some elements. The first k different elements make a block; after that each stay's element
// enters for one whose own stay has ended, of those the one that comes back last; if it is still
// there, no block is made at all. Such an element there always is: an element whose stay has not
// ended was in a block with the one that enters, so these are at most k−1. And nothing is lost:
// elements that were together in a block still are, since the later of the two stays begins while
// the earlier one lasts. Other elements stay longer than they did, so the stays of those elements
// are saved, and sometimes more.
#pragma once

#include <optional>

#include "changeover/core/design.hpp"

namespace changeover {

/// The design without the elements x, …, x+count−1, those above taking their numbers; nullopt
/// unless it is linear with change 1, has those elements, and v − count > k. O(bk), and 32 bytes
/// for each block.
[[nodiscard]] std::optional<Design> closed_up(const Design& design, Element x,
                                              std::uint64_t count = 1);

struct BestToCloseUp {
  Element element = 0;
  std::uint64_t blocks = 0;  ///< that are left
};

/// The element without which the design has fewest blocks, closed up, of up to `most_tries` of
/// those with the most stays, the first and the last ones by number.
[[nodiscard]] std::optional<BestToCloseUp> best_to_close_up(const Design& design,
                                                            std::size_t most_tries);

}  // namespace changeover
