// Lists of blocks of few elements, as they are written in the sources: "012 034 1ab".
#pragma once

#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// The blocks of a list that is separated by single blanks; an element is one character, 0, …, 9
/// and then a, …, z for 10, …, 35.
[[nodiscard]] inline std::vector<Block> short_blocks(std::string_view text) {
  std::vector<Block> blocks(1);
  for (const char c : text) {
    if (c == ' ') {
      blocks.emplace_back();
    } else {
      blocks.back().push_back(static_cast<Element>(c <= '9' ? c - '0' : c - 'a' + 10));
    }
  }
  return blocks;
}

}  // namespace changeover
