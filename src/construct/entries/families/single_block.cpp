// One block that holds all elements: the only design with v = k. It counts as circular too, for it has no
// step; [ChafeeStevens2025, Theorems 3 and 8] begin with such designs.
#include <fmt/format.h>

#include <numeric>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

class SingleBlock final : public Construction {
 public:
  std::string_view name() const override { return "single-block"; }
  std::string_view summary() const override { return "one block that holds all elements"; }
  std::string_view preconditions() const override { return "v = k, any m, linear or circular"; }
  std::string_view guarantee() const override { return "b = 1, tight"; }
  Citation citation() const override { return {}; }

  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    if (p.v != p.k || !asks_for_pairs(p, p.change)) {
      return std::nullopt;
    }
    return Offer{{std::string(name()), p, {}, {}, {}}, 1, true, true, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const std::optional<Offer> expected = offer(recipe.parameters, registry);
    require_recipe(recipe, *this, expected ? std::optional(expected->recipe) : std::nullopt);
    Block block(static_cast<std::size_t>(recipe.parameters.k));
    std::iota(block.begin(), block.end(), 0U);
    return std::make_unique<BlockListSource>(recipe.parameters,
                                             std::vector<Block>{std::move(block)});
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format("All {} elements in one block.", recipe.parameters.k);
  }
};

}  // namespace

const Construction& single_block_construction() {
  static const SingleBlock construction;
  return construction;
}

}  // namespace changeover
