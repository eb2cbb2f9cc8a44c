// What constructions over several orbits of Z_n have in common: blocks that are written by number,
// the base blocks first, and base_blocks() of them.
#pragma once

#include <optional>

#include "changeover/construct/registry.hpp"
#include "construct/tools/cyclic.hpp"

namespace changeover {

/// The base blocks of `blocks`, unless they are too many to write out.
template <typename Blocks>
[[nodiscard]] std::optional<OrbitBaseBlocks> written_base_blocks(const Parameters& p,
                                                                 const Blocks& blocks,
                                                                 const Automorphism& automorphism) {
  if (blocks.base_blocks() > max_written_out_elements / p.k) {
    return std::nullopt;
  }
  OrbitBaseBlocks result{{p, {}}, automorphism};
  for (std::uint64_t i = 0; i < blocks.base_blocks(); ++i) {
    blocks.write(i, result.base.blocks.emplace_back(static_cast<std::size_t>(p.k)));
  }
  return result;
}

}  // namespace changeover
