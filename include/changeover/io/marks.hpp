// How blocks are laid out in columns, for tables on paper and on a terminal.
//
// In a table of blocks an element keeps its row while it stays, and an introduced element takes the row
// of one that left, so that a reader sees what changes. The marks are those of Transitions.
//
//     for (const AlignedBlock& column : aligned_rows(design)) {
//       column[0].element;  column[0].introduced;  column[0].leaving;
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

struct MarkedElement {
  Element element = 0;
  bool introduced = false;
  bool leaving = false;

  bool operator==(const MarkedElement&) const = default;
};

/// One block, top row first.
using AlignedBlock = std::vector<MarkedElement>;

/// All blocks of a design in rows. The first block keeps its order; those that enter take the rows of
/// those that left, both from the top and in the order in which they are written. O(bk log k).
[[nodiscard]] std::vector<AlignedBlock> aligned_rows(const Design& design);

/// How the blocks of a table are named.
struct BlockNames {
  std::uint64_t first = 1;  ///< number of the first block
  std::optional<std::uint64_t> base_blocks =
      {};  ///< c: name block i as (i mod c, i div c), both from 0

  bool operator==(const BlockNames&) const = default;
};

/// The columns that display `text` on a terminal: UTF-8 decoded, marks above letters 0, East Asian wide
/// characters 2; a byte that is not UTF-8 counts 1.
[[nodiscard]] std::size_t display_width(std::string_view text);

}  // namespace changeover
