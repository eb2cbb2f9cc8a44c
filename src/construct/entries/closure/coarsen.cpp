// Coarsen: g consecutive blocks of a single-change design in one. See construct/tools/coarsen.hpp.
#include <fmt/format.h>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/coarsen.hpp"

namespace changeover::coarsen_entry {
namespace {

// The parameters of the single-change design of which p's g-change design is made.
Parameters finer(Parameters p) {
  p.k = p.k + 1 > p.change ? p.k + 1 - p.change : 0;
  p.change = 1;
  return p;
}

constexpr Description description{
    .name = "coarsen",
    .summary = "m consecutive blocks of a single-change design in one, for an m-change design",
    .preconditions = "m >= 2; a single-change design on (v,k-m+1) of the same kind as input",
    .guarantee = "the m-th part of the input's blocks, rarely a few more",
    .place = "src/construct/tools/coarsen.hpp",
};

class Coarsen final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const std::uint64_t first = first_group(recipe);
    const auto coarse =
        coarsened(registry.build_design(recipe.inputs.front()), recipe.parameters.change, first);
    if (!coarse) {
      throw BadInput(fmt::format(
          "coarsen: the blocks of the {} cannot be grouped by {}, with {} in the first group; use "
          "another input",
          changeover::name(recipe.inputs.front().parameters), recipe.parameters.change, first));
    }
    return std::make_unique<BlockListSource>(recipe.parameters, coarse->blocks());
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t first = first_group(recipe);
    return fmt::format("Put {} consecutive blocks of the {} into one, {} first.",
                       recipe.parameters.change, changeover::name(recipe.inputs.front().parameters),
                       first);
  }

 private:
  std::uint64_t first_group(const Recipe& recipe) const {
    const Parameters& p = recipe.parameters;
    const auto given = recipe.arguments.find("first");
    if (given == recipe.arguments.end() || given->second < 1 || p.change < 2 ||
        static_cast<std::uint64_t>(given->second) > p.change || p.k >= p.v || finer(p).k < 2) {
      throw BadInput(fmt::format(
          "coarsen to {} takes a single-change design of its kind on ({},{}) and how many "
          "blocks come first; correct the recipe",
          changeover::name(p), p.v, finer(p).k));
    }
    require_input(recipe, finer(p), {{"first", given->second}});
    return static_cast<std::uint64_t>(given->second);
  }
};

}  // namespace

const Construction& construction() { return only<Coarsen>(); }

}  // namespace changeover::coarsen_entry

namespace changeover {

std::optional<Made> coarsen_recipe(const Recipe& input, const Design& design, std::uint64_t g) {
  std::optional<Made> best;
  for (std::uint64_t first = 1; first <= g; ++first) {
    const auto coarse = coarsened(design, g, first);
    if (coarse && (!best || coarse->block_count() < best->b)) {
      best = Made{{"coarsen",
                   coarse->parameters(),
                   {{"first", static_cast<std::int64_t>(first)}},
                   {input},
                   {}},
                  coarse->block_count()};
    }
  }
  return best;
}

}  // namespace changeover
