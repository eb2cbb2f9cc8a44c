// The index of a block in its name: "3", or "i,j" for a developed design.
#pragma once

#include <string>

#include "changeover/io/tables.hpp"

namespace changeover {

/// `index` from 0 in the order of the blocks.
[[nodiscard]] inline std::string block_name(const BlockNames& names, std::uint64_t index) {
  if (names.base_blocks && *names.base_blocks > 0) {
    return std::to_string(index % *names.base_blocks) + "," +
           std::to_string(index / *names.base_blocks);
  }
  return std::to_string(names.first + index);
}

}  // namespace changeover
