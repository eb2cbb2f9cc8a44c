// Close up: one element fewer, and at least as many blocks fewer as the element has stays. See
// construct/tools/close_up.hpp for the rule and why it loses no pair.
#include <fmt/format.h>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/close_up.hpp"

namespace changeover::close_up_entry {
namespace {

constexpr Description description{
    .name = "close-up",
    .summary = "delete an element of a single-change design and close the gaps between stays",
    .preconditions = "a linear single-change design on v+1 > k+1 elements, as input",
    .guarantee = "a block fewer for each stay of the element, or better",
    .place = "src/construct/tools/close_up.hpp",
};

class CloseUp final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Element x = deleted(recipe);
    const auto closed = closed_up(registry.build_design(recipe.inputs.front()), x);
    return std::make_unique<BlockListSource>(recipe.parameters, closed.value().blocks());
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format(
        "Delete element {} of the {} and let each stay begin as soon as another one has ended; the "
        "last element takes its name.",
        deleted(recipe), changeover::name(recipe.inputs.front().parameters));
  }

 private:
  Element deleted(const Recipe& recipe) const {
    const Parameters larger = recipe.parameters.on(recipe.parameters.v + 1);
    if (larger.v <= larger.k + 1 || larger.change != 1 || larger.kind != Kind::linear ||
        larger.strength != 2) {
      require_recipe(recipe, *this, std::nullopt);
    }
    return element_of(recipe, larger,
                      "a linear single-change design on one element more and the number of the "
                      "element to delete");
  }
};

}  // namespace

const Construction& construction() { return only<CloseUp>(); }

}  // namespace changeover::close_up_entry

namespace changeover {

std::optional<Made> close_up_recipe(const Recipe& input, const Design& design) {
  constexpr std::size_t most_tries = 4;
  const Parameters& p = input.parameters;
  if (p.kind != Kind::linear || p.change != 1 || p.strength != 2 || p.v <= p.k + 1) {
    return std::nullopt;
  }
  const auto best = best_to_close_up(design, most_tries);
  if (!best) {
    return std::nullopt;
  }
  return Made{{"close-up", p.on(p.v - 1), {{"element", best->element}}, {input}, {}}, best->blocks};
}

}  // namespace changeover
