// The tight circular DCCD(2k−3, k, k−2), k odd: a new element in every block of the tight circular
// DCCD(2k−4, k−1, k−2).
//
// Each old element is introduced exactly once there, so its pair with the new one is covered once.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::fixed_element_entry {
namespace {

constexpr std::string_view smaller = "doubling";

// The parameters of the design that gets the new element.
Parameters without_fixed(const Parameters& p) { return {p.v - 1, p.k - 1, 2, Kind::circular, 2}; }

bool serves(const Parameters& p) {
  return asks_for_pairs(p, 2) && p.kind == Kind::circular && p.k % 2 != 0 && p.v == 2 * p.k - 3;
}

constexpr Description description{
    .name = "fixed-element",
    .summary = "a new element in every block of a tight circular DCCD(2k-4,k-1,k-2)",
    .preconditions = "circular, m = 2, v = 2k-3, k odd, k >= 3",
    .guarantee = "a tight circular DCCD(2k-3,k,k-2)",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 8",
};

class FixedElement final : public Described<Entry, description> {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    const Construction* construction = registry.find(smaller);
    if (!serves(p) || construction == nullptr) {
      return std::nullopt;
    }
    std::optional<Offer> input = construction->offer(without_fixed(p), registry);
    if (!input) {
      return std::nullopt;
    }
    return Offer{recipe_of(p, {}, {std::move(input->recipe)}), p.k - 2, true, true, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const std::optional<Offer> offered = offer(recipe.parameters, registry);
    require_recipe(recipe, *this, offered ? std::optional(offered->recipe) : std::nullopt);
    return with_fixed(recipe.parameters, registry.build(recipe.inputs.front()));
  }

  std::string explain(const Recipe& recipe) const override {
    if (!serves(recipe.parameters)) {
      require_recipe(recipe, *this, std::nullopt);
    }
    return fmt::format("Add the new element {} to every block of the {}.", recipe.parameters.v - 1,
                       changeover::name(without_fixed(recipe.parameters)));
  }
};

}  // namespace

const Construction& construction() { return only<FixedElement>(); }

}  // namespace changeover::fixed_element_entry
