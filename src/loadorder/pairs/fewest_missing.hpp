// Internal: an order of closing items that knows how much fits into memory.
//
// What is in memory and lacks the fewest partners is closed next: they are loaded, one after
// another. What has not met anything for longest goes. If nothing in memory lacks a partner, what
// lacks the fewest of what went goes on, and at last the next one of `roots`. The loads themselves
// are of no use: with the order known, Closing evicts better.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/bucket_queue.hpp"

namespace changeover {

/// `ties` says which of those that lack equally many. Empty once give_up() says yes. `roots` are
/// all items.
[[nodiscard]] std::vector<Element> fewest_missing_order(const PairGraph& graph, std::uint64_t room,
                                                        const std::vector<Element>& roots,
                                                        BucketQueue::Ties ties,
                                                        const std::function<bool()>& give_up);

}  // namespace changeover
