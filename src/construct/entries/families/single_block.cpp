// One block that holds all elements: the only design with v = k. It counts as circular too, for it
// has no step; [ChafeeStevens2025, Theorems 3 and 8] begin with such designs.
#include <fmt/format.h>

#include <numeric>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/words.hpp"

namespace changeover::single_block_entry {
namespace {

constexpr Description description{
    .name = "single-block",
    .summary = "one block that holds all elements",
    .preconditions = "v = k, any m and strength, linear or circular",
    .guarantee = "b = 1, tight",
};

class SingleBlock final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    Parameters pairs = p;
    pairs.strength = 2;  // whatever is asked for meets in that block
    if (p.v != p.k || p.strength > max_strength || p.strength > p.k ||
        !asks_for_pairs(pairs, p.change)) {
      return std::nullopt;
    }
    return Promise{1, true, true};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    Block block(static_cast<std::size_t>(p.k));
    std::iota(block.begin(), block.end(), 0U);
    return std::make_unique<BlockListSource>(p, std::vector<Block>{std::move(block)});
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format("All {} in one block.", count_of(p.k, "element"));
  }
};

}  // namespace

const Construction& construction() { return only<SingleBlock>(); }

}  // namespace changeover::single_block_entry
