// The v → v+1 expansion: U ∪ {v}, inserted at the positions of an expansion set of an SCCD(v,k).
// It is the partial expansion by one element at subsets that do not overlap [PreeceEtAl1995], for
// circular designs too [McSorley1999].
#include <fmt/format.h>

#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::single_change_expansion_entry {
namespace {

std::optional<Parameters> input_parameters(const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.v <= p.k || (p.v - 1) % (p.k - 1) != 0) {
    return std::nullopt;
  }
  return p.on(p.v - 1);
}

constexpr Description description{
    .name = "single-change-expansion",
    .summary = "a new element beside every unchanged subset of an expansion set",
    .preconditions = "m = 1, k-1 divides v-1, and an SCCD(v-1,k) with an expansion set",
    .guarantee = "(v-1)/(k-1) blocks more; tight and circular if the smaller design is",
    .cited = "PreeceEtAl1995",
};

class SingleChangeExpansion final : public Described<Entry, description> {
 public:
  bool asks_registry() const override { return true; }

  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    const std::optional<Parameters> smaller = input_parameters(p);
    if (!smaller) {
      return std::nullopt;
    }
    std::optional<Offer> input = best_that_asks_none(*smaller, Need::expansion_set, registry);
    std::uint64_t b = 0;
    if (!input || __builtin_add_overflow(input->b, smaller->v / (p.k - 1), &b)) {
      return std::nullopt;
    }
    return Offer{recipe_of(p, {}, {std::move(input->recipe)}), b, input->tight,
                 b == counting_bound(p), false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_fit(recipe);
    const Recipe& input = recipe.inputs.front();
    ExpansionSet set = known_expansion_set(input, registry);
    return expand_by(registry.build(input), {.subsets = std::move(set)}, 1);
  }

  std::string explain(const Recipe& recipe) const override {
    require_fit(recipe);
    const Parameters& input = recipe.inputs.front().parameters;
    return fmt::format(
        "At each of the {} positions of an expansion set of the {}, insert its unchanged subset "
        "with the new element {}.",
        input.v / (input.k - 1), changeover::name(input), input.v);
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    require_fit(recipe);
    return labels_with_new(recipe, registry);
  }

 private:
  void require_fit(const Recipe& recipe) const {
    require_input(recipe, input_parameters(recipe.parameters), {});
  }
};

}  // namespace

const Construction& construction() { return only<SingleChangeExpansion>(); }

}  // namespace changeover::single_change_expansion_entry
