// Internal: loads for a list of pairs by groups that stay in turn.
//
//     HeldList held = held_list(graph, room, give_up);   // groups of room − 1 items
//     held.moves(graph);                                 // what is loaded, and what went for it
//
// A group stays in all places but one. The items that still have a pair with it pass through that
// place, one after another; then no item of the group is needed again. Where most pairs are listed
// this needs far fewer loads than closing one item after another (closing.hpp), and no search.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/closing.hpp"

namespace changeover {

struct HeldList {
  std::uint64_t room = 0;
  std::vector<std::vector<Element>> groups;  ///< room − 1 items each, the last one up to room
  std::uint64_t loads = 0;

  /// O(pairs) time.
  [[nodiscard]] std::vector<LoadMove> moves(const PairGraph& graph) const;
};

/// The best of several groupings: by number, by degree, and one after another as items share most
/// partners with the group, where that takes at most a second or so. O(pairs) for each but the
/// last. Room ≥ 2. `give_up` ends the last grouping early.
[[nodiscard]] HeldList held_list(const PairGraph& graph, std::uint64_t room,
                                 const std::function<bool()>& give_up);

}  // namespace changeover
