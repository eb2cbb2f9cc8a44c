// The same f new elements in every block: DCCD(v,k,b) → DCCD(v+f,k+f,b), for any m and both kinds.
//
// A closure rule on recipes: it makes no offers, which would recurse without end. Constructions
// that know which input to take compose it.
#include <fmt/format.h>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"

namespace changeover::fix_entry {
namespace {

constexpr Description description{
    .name = "fix",
    .summary = "f new elements in every block of a design",
    .preconditions = "a design on (v-f,k-f) of the same kind and m, as input; f >= 1",
    .guarantee = "as many blocks as the input",
};

class Fix final : public Described<Rule, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    (void)number(recipe);
    return with_fixed(recipe.parameters, registry.build(recipe.inputs.front()));
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t f = number(recipe);
    const Parameters& input = recipe.inputs.front().parameters;
    const std::uint64_t last = recipe.parameters.v - 1;
    const std::string added = f == 1   ? fmt::format("element {}", last)
                              : f == 2 ? fmt::format("elements {} and {}", last - 1, last)
                                       : fmt::format("elements {},…,{}", input.v, last);
    return fmt::format("Add the new {} to every block of the {}.", added, changeover::name(input));
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    (void)number(recipe);
    return labels_with_new(recipe, registry);
  }

 protected:
  std::uint64_t number_between(const Parameters& small, const Parameters& large) const override {
    const std::uint64_t f = small.v < large.v ? large.v - small.v : 0;
    return f < large.k && small.k == large.k - f && small.change == large.change ? f : 0;
  }
  Recipe with(const Recipe& input, std::uint64_t f) const override { return fix_recipe(input, f); }
  std::string_view needs() const override {
    return "with f >= 1 fewer elements in all and in each block, otherwise with the same "
           "parameters";
  }
};

}  // namespace

const Construction& construction() { return only<Fix>(); }

}  // namespace changeover::fix_entry

namespace changeover {

Recipe fix_recipe(const Recipe& input, std::uint64_t f) {
  if (f == 0) {
    return input;
  }
  Parameters p = input.parameters;
  p.v = checked_add(p.v, f);
  p.k = checked_add(p.k, f);
  return {"fix", p, {{"f", static_cast<std::int64_t>(f)}}, {input}, {}};
}

}  // namespace changeover
