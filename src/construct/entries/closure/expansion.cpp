// The recursion: U ∪ e for the edges e of one 1-factor of K_{ℓ+1}, inserted at each of the ℓ =
// v/(k−2) positions of an expansion set of a DCCD(v,k), ℓ odd, makes a DCCD(v+ℓ+1, k).
//
// A new element leaves one block after it came, so it is in no unchanged subset and the result
// never has an expansion set. That is also why this construction need not ask itself for its input.
#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

// The parameters of the smaller design: ℓ(k−2) + ℓ + 1 = ℓ(k−1) + 1 = v.
std::optional<Parameters> input_parameters(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.k < 3 || (p.v - 1) % (p.k - 1) != 0) {
    return std::nullopt;
  }
  const std::uint64_t subsets = (p.v - 1) / (p.k - 1);
  if (subsets % 2 == 0 || subsets * (p.k - 2) < p.k) {
    return std::nullopt;
  }
  Parameters smaller = p;
  smaller.v = subsets * (p.k - 2);
  return smaller;
}

constexpr Description description{
    .name = "expansion",
    .summary = "1-factors of a complete graph inserted at the positions of an expansion set",
    .preconditions = "m = 2, v = l(k-1)+1 with l odd, and a DCCD(l(k-2),k) with an expansion set",
    .guarantee = "l(l+1)/2 blocks more; tight, economical and circular if the smaller design is",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 2",
};

class Expansion final : public Entry {
 public:
  Expansion() : Entry(description) {}

  bool asks_registry() const override { return true; }

  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    const std::optional<Parameters> smaller = input_parameters(p);
    if (!smaller) {
      return std::nullopt;
    }
    std::optional<Offer> input = best_input(*smaller, Need::expansion_set, *this, registry);
    if (!input) {
      return std::nullopt;
    }
    const std::uint64_t w = p.v - smaller->v;  // ℓ + 1
    std::uint64_t b = 0;
    if (__builtin_add_overflow(input->b, (w - 1) * (w / 2), &b)) {
      return std::nullopt;
    }
    Recipe recipe{std::string(name()),
                  p,
                  {{"w", static_cast<std::int64_t>(w)}},
                  {std::move(input->recipe)},
                  {}};
    return Offer{std::move(recipe), b, input->tight, input->economical, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_fit(recipe);
    const Recipe& input = recipe.inputs.front();
    std::optional<ExpansionSet> set =
        registry.construction_of(input).expansion_set(input, registry);
    if (!set) {
      throw BadInput(fmt::format("no expansion set is known of {} as made by {}",
                                 changeover::name(input.parameters), input.construction));
    }
    return expand(registry.build(input), *std::move(set));
  }

  std::string explain(const Recipe& recipe) const override {
    require_fit(recipe);
    const Parameters& input = recipe.inputs.front().parameters;
    const std::uint64_t w = recipe.parameters.v - input.v;
    return fmt::format(
        "At each of the {} positions of an expansion set of the {}, insert its unchanged subset "
        "with the "
        "edges of one 1-factor of K_{} on the new elements {},…,{}.",
        w - 1, changeover::name(input), w, input.v, recipe.parameters.v - 1);
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    require_fit(recipe);
    const Recipe& input = recipe.inputs.front();
    return expanded_labels(registry.construction_of(input).labels(input, registry),
                           recipe.parameters.v - input.parameters.v);
  }

 private:
  // The input may be any recipe of the right parameters; everything else is determined.
  void require_fit(const Recipe& recipe) const {
    const std::optional<Parameters> smaller = input_parameters(recipe.parameters);
    if (!smaller) {
      require_recipe(recipe, *this, std::nullopt);
      return;
    }
    if (recipe.inputs.size() != 1 || recipe.inputs.front().parameters != *smaller) {
      throw BadInput(fmt::format("expansion to {} takes one input, a {}",
                                 changeover::name(recipe.parameters), changeover::name(*smaller)));
    }
    const auto w = static_cast<std::int64_t>(recipe.parameters.v - smaller->v);
    require_recipe(recipe, *this,
                   Recipe{std::string(name()), recipe.parameters, {{"w", w}}, recipe.inputs, {}});
  }
};

}  // namespace

const Construction& expansion_construction() {
  static const Expansion construction;
  return construction;
}

}  // namespace changeover
