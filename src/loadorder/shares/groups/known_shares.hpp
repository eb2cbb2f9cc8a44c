// Internal: the best known shares in which workers hold some groups and stream others.
//
//     // Fewer than 342 loads for the busiest worker, if there are such shares.
//     auto shares = best_group_shares(1024, 256, 16, 342);
//     shares->workers.size();                                // 16
//
// Sources:
//   planes     the q+1 points of each line of a projective plane, W = q²+q+1; the q points of each
//              line of an affine one; with room for all but one, that one is streamed
//   table      found by search (docs/tools/find_shares.sh): base shares (A, S) over Z_n, of which
//              the workers are the translates
//              by multiples of m. S empty: a difference cover, every share a quorum
//   halves     each worker holds one group and streams half of the others
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "loadorder/shares/groups/group_shares.hpp"

namespace changeover {

/// Shares from a line of the table: "n m | A / S | A / S …".
[[nodiscard]] GroupShares developed_shares(std::string_view line);

/// All lines of the table (share_table.inc).
[[nodiscard]] std::span<const char* const> share_table();

/// What shares have: workers, groups, and how many of these each worker holds and has in all.
struct ShareShape {
  std::uint64_t workers = 0;
  std::uint64_t groups = 0;
  std::uint64_t held = 0;
  std::uint64_t all = 0;
};

/// Visits the known shares of at most so many workers and items that are hopeful.
void each_group_shares(std::uint64_t workers, std::uint64_t items,
                       const std::function<bool(const ShareShape& shape)>& is_hopeful,
                       const std::function<void(GroupShares shares)>& visit);

/// The shares with the fewest loads of the busiest worker, then of all workers, if the former are
/// fewer than `than`; items ≥ 2, room ≥ 2. Workers without a share get pairs of others, if that
/// makes pairs more even and no worker busier than the busiest. Nothing is verified.
[[nodiscard]] std::optional<GroupShares> best_group_shares(std::uint64_t items, std::uint64_t room,
                                                           std::uint64_t workers,
                                                           std::uint64_t than);

}  // namespace changeover
