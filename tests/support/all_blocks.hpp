// All k-subsets of v elements.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover::test {

inline std::vector<Block> all_blocks(std::uint32_t v, std::uint32_t k) {
  std::vector<Block> blocks;
  std::vector<bool> chosen(v, false);
  std::fill(chosen.begin(), chosen.begin() + k, true);
  do {
    Block block;
    for (Element x = 0; x < v; ++x) {
      if (chosen[x]) {
        block.push_back(x);
      }
    }
    blocks.push_back(block);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return blocks;
}

}  // namespace changeover::test
