// The recursion: U ∪ e for the edges e of one 1-factor of K_{ℓ+1}, inserted at each of the ℓ =
// v/(k−2) positions of an expansion set of a DCCD(v,k), ℓ odd, makes a DCCD(v+ℓ+1, k).
//
// A new element leaves one block after it came, so it is in no unchanged subset and the result
// never has an expansion set. That is also why this construction need not ask itself for its input.
#include "changeover/construct/expansion.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::expansion_entry {
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
  return p.on(subsets * (p.k - 2));
}

using Arguments = std::map<std::string, std::int64_t>;

Arguments arguments(const Parameters& p, const Parameters& smaller) {
  return {{"w", static_cast<std::int64_t>(p.v - smaller.v)}};
}

constexpr Description description{
    .name = "expansion",
    .summary = "1-factors of a complete graph inserted at the positions of an expansion set",
    .preconditions = "m = 2, v = l(k-1)+1 with l odd, and a DCCD(l(k-2),k) with an expansion set",
    .guarantee = "l(l+1)/2 blocks more; tight, economical and circular if the smaller design is",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 2",
};

class Expansion final : public Described<Entry, description> {
 public:
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
    return Offer{recipe_of(p, arguments(p, *smaller), {std::move(input->recipe)}), b, input->tight,
                 input->economical, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_fit(recipe);
    const Recipe& input = recipe.inputs.front();
    ExpansionSet set = known_expansion_set(input, registry);
    return expand(registry.build(input), std::move(set));
  }

  std::string explain(const Recipe& recipe) const override {
    require_fit(recipe);
    const Parameters& input = recipe.inputs.front().parameters;
    const std::uint64_t w = recipe.parameters.v - input.v;
    return fmt::format(
        "At each of the {} positions of an expansion set of the {}, insert its unchanged subset "
        "with the edges of one 1-factor of K_{} on the new elements {},…,{}.",
        w - 1, changeover::name(input), w, input.v, recipe.parameters.v - 1);
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    require_fit(recipe);
    return labels_with_new(recipe, registry);
  }

 private:
  void require_fit(const Recipe& recipe) const {
    const std::optional<Parameters> smaller = input_parameters(recipe.parameters);
    require_input(recipe, smaller, smaller ? arguments(recipe.parameters, *smaller) : Arguments{});
  }
};

}  // namespace

const Construction& construction() { return only<Expansion>(); }

}  // namespace changeover::expansion_entry
