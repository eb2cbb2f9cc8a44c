#include "construct/tools/read_within_memory.hpp"

#include <algorithm>
#include <span>

#include "changeover/run/control.hpp"

namespace changeover {

Design read_within_memory(BlockSource& source) {
  constexpr std::uint64_t elements_between = 1U << 18;
  Design design(source.parameters());
  const std::uint64_t between =
      elements_between / std::max<std::uint64_t>(source.parameters().k, 1) + 1;
  for_each_block(source, [&](std::span<const Element> block) {
    if (design.block_count() % between == 0) {
      stop_if_asked();
      // A vector that grows is there twice for a moment.
      require_memory(3 * sizeof(Element) * block.size() * design.block_count(),
                     "the " + name(source.parameters()));
    }
    design.append(block);
  });
  return design;
}

}  // namespace changeover
