// Internal: the number of items that some worker must load, with any room, because any two items
// meet at one of few workers.
//
//     least_at_one_worker(1024, 13).loads      // 316: 13 workers attain it, the lines of a plane
//
// Let E_x be the workers that load x: any two of these sets have a common worker. So many of them
// are large, or many pairs have more than one common worker [docs/theorems.md, Theorem 17].
#pragma once

#include <cstdint>

#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// @throws BadInput unless 1 ≤ workers ≤ most_workers
void check_workers(std::uint64_t workers);

/// Some worker loads so many different items. items ≥ 1, workers ≥ 1. O(√W · log P)
[[nodiscard]] LoadBound least_at_one_worker(std::uint64_t items, std::uint64_t workers);

}  // namespace changeover
