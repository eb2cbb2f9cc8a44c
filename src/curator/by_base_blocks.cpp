#include "curator/by_base_blocks.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/search/base_block_search.hpp"
#include "search/local/imposed.hpp"

namespace changeover {

std::optional<Design> by_base_blocks(const Design& design) {
  const Parameters& p = design.parameters();
  if (p.kind != Kind::circular) {
    return std::nullopt;
  }
  const auto sorted = [&](std::size_t i) {
    Block block(design.block(i).begin(), design.block(i).end());
    std::ranges::sort(block);
    return block;
  };
  const std::size_t b = design.block_count();
  for (const Automorphism& pi : imposed_automorphisms(p.v)) {
    if (b % pi.n != 0) {
      continue;
    }
    const std::size_t base = b / pi.n;
    std::vector<Block> blocks;
    bool is_image = true;
    for (std::size_t i = 0; is_image && i < b; ++i) {
      if (i < base) {
        blocks.push_back(sorted(i));
      }
      Block image = pi.image(sorted(i), 1);
      std::ranges::sort(image);
      is_image = image == sorted((i + base) % b);
    }
    if (is_image) {
      return Registry::standard().build_design(
          developed_recipe(p, BaseBlockShape{pi, base}, std::move(blocks)));
    }
  }
  return std::nullopt;
}

}  // namespace changeover
