// Internal: two levels of memory for some pairs only.
//
// Two kinds of orders; docs/loadorder.md.
//   cache     an order for the accelerator alone; what leaves it stays in memory, from which goes
//             what is needed last
//   batches   an order for memory with b places less; b of its loads are made at once, and all that
//             they bring together is done on the accelerator before anything has to go
#pragma once

#include "changeover/loadorder/load_order.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// How many loads a batch may have, the most promising numbers first.
[[nodiscard]] std::vector<std::uint64_t> batches_to_try(std::uint64_t room,
                                                        std::uint64_t fast_room);

/// What both levels move if loads follow these, an order for `batch` places less; 0: an order for
/// the accelerator, with memory as a cache. `facts` has both rooms.
[[nodiscard]] std::vector<Move> levels_of(const PairGraph& graph, const LoadOrderFacts& facts,
                                          const std::vector<LoadMove>& loads, std::uint64_t batch);

/// The steps with the least loads / bound + transfers / bound; `facts` has the pairs, both rooms
/// and both bounds, and is given their description.
[[nodiscard]] LoadOrder::Maker listed_levels(LoadOrderFacts& facts,
                                             const LoadOrderOptions& options);

/// The same for these pairs alone, as moves. `searched`: the orders that both levels follow are
/// improved by a search, some seconds long.
[[nodiscard]] std::vector<Move> listed_levels_of(const std::vector<ItemPair>& pairs,
                                                 std::uint64_t room, std::uint64_t fast_room,
                                                 bool searched, const LoadOrderOptions& options);

}  // namespace changeover
