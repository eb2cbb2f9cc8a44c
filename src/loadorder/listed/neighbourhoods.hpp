// Internal: listed pairs for several workers, as parts of equally many pairs with few items each.
//
//     neighbourhoods(graph, 4)        // the pairs of each of 4 workers
//
// A stretch of an order has the width of the order at its start: where workers have few pairs each,
// that is most of what they load. A part grows in all directions instead: the item that lacks the
// fewest partners is closed next, and all pairs among the part's items belong to it, until there
// are enough (the neighbourhood heuristic of Zhang, Wei, Liu, Tang and Li, KDD 2017). The last
// parts are what the others have left over. So all pairs that an item has in a part with many items
// go to other parts, if that is better for the largest of them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// The pairs of each worker, each pair once; (x,x) for an item in no pair. Of `cost`, if given,
/// parts are even instead of in numbers. Empty if it would take too long. Some 40 bytes a pair
[[nodiscard]] std::vector<std::vector<ItemPair>> neighbourhoods(
    const PairGraph& graph, std::uint64_t workers,
    const std::function<double(Element, Element)>& cost = {});

}  // namespace changeover
