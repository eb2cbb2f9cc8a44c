// Internal: an order of closing items that takes the size of memory into account.
//
// The next item to be closed is the one in memory that lacks the fewest partners, which are loaded
// one after another. The item that has not met a partner for longest is evicted. If no item in
// memory lacks a partner, the evicted item that lacks the fewest is next, and at last the next one
// of `roots`. The loads are discarded: given the order, Closing evicts better.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/bucket_queue.hpp"

namespace changeover {

/// `ties` decides between items that lack equally many partners. Empty once give_up() returns true.
/// `roots` contains all items.
[[nodiscard]] std::vector<Element> fewest_missing_order(const PairGraph& graph, std::uint64_t room,
                                                        const std::vector<Element>& roots,
                                                        BucketQueue::Ties ties,
                                                        const std::function<bool()>& give_up);

}  // namespace changeover
