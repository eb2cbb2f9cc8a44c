// Internal: the pairs of a step in random order.
#pragma once

#include <utility>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "run/random.hpp"

namespace changeover {

inline void shuffle_pairs(std::vector<ItemPair>& pairs, Random& random) {
  for (std::size_t i = pairs.size(); i > 1; --i) {
    std::swap(pairs[i - 1], pairs[random.below(static_cast<std::uint32_t>(i))]);
  }
}

}  // namespace changeover
