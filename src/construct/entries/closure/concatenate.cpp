// Concatenate: linear single-change designs V and W one after the other, where k−1 elements at
// the end of V serve W too.
//
// The recipe's inputs are V and W; its list of positions names unchanged subsets of W that
// partition W without k−1 elements of its first or last block. `times` says how often W comes.
// See construct/tools/concatenation/pieces.hpp.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/concatenation/pieces.hpp"
#include "construct/trusted_entry.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover::concatenate_entry {
namespace {

constexpr Description description{
    .name = "concatenate",
    .summary = "two linear single-change designs with k-1 elements in common, one after the other",
    .preconditions = "linear, m = 1; one is split into unchanged subsets but for k-1 at its end",
    .guarantee = "the blocks over the counting bound, before rounding, are those of both",
    .place = "docs/theorems.md, Theorem 13",
};

class Concatenate final : public Described<Entry, description> {
 public:
  // It asks neither itself nor what asks it.
  bool asks_registry() const override { return true; }

  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    return best_concatenation(p, registry, false);
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    return blocks_of(fans(recipe, registry));
  }

  std::unique_ptr<FanSource> fans(const Recipe& recipe, const Registry& registry) const override {
    const std::uint64_t times = required_times(recipe);
    const std::unique_ptr<BlockSource> second = registry.build(recipe.inputs[1]);
    Piece piece = open_piece(read_within_memory(*second).blocks(), recipe.blocks.front());
    return with_pieces(registry.fans(recipe.inputs[0]), std::move(piece), times, recipe.parameters);
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t times = required_times(recipe);
    const Parameters& second = recipe.inputs[1].parameters;
    return fmt::format(
        "After the {} put the {}{}: {} at the end of what is there {} the new one's too, "
        "the others new; beside {} unchanged subsets, which hold all of these, every old element "
        "is inserted.",
        changeover::name(recipe.inputs[0].parameters), changeover::name(second),
        times == 1 ? "" : fmt::format(" {} times", times), count_of(second.k - 1, "element"),
        second.k == 2 ? "is" : "are", recipe.blocks.front().size());
  }

 private:
  /// @throws BadInput if the recipe is none.
  std::uint64_t required_times(const Recipe& recipe) const {
    const auto given = recipe.arguments.find("times");
    if (recipe.inputs.size() == 2 && recipe.blocks.size() == 1 && given != recipe.arguments.end() &&
        given->second > 0 && asks_for_pairs(recipe.parameters, 1)) {
      const auto times = static_cast<std::uint64_t>(given->second);
      const Parameters& p = recipe.parameters;
      const Parameters& first = recipe.inputs[0].parameters;
      const Parameters& second = recipe.inputs[1].parameters;
      const auto alike = [&](Parameters q) {
        q.v = p.v;
        return q == p && p.kind == Kind::linear;
      };
      const std::uint64_t fresh = second.v - std::min(second.v, p.k - 1);
      if (alike(first) && alike(second) && first.v >= p.k && first.v < p.v && fresh > 0 &&
          fresh == recipe.blocks.front().size() * (p.k - 1) && (p.v - first.v) / fresh == times &&
          (p.v - first.v) % fresh == 0 && recipe.arguments.size() == 1) {
        return times;
      }
    }
    throw BadInput(fmt::format(
        "concatenate to {} takes two linear single-change designs with the same k, positions of "
        "the second that leave k-1 of its w elements out, and how many times w-k+1 elements are "
        "added; correct the recipe",
        changeover::name(recipe.parameters)));
  }
};

}  // namespace

const Construction& construction() { return only<Concatenate>(); }

}  // namespace changeover::concatenate_entry

namespace changeover {

Recipe concatenate_recipe(Recipe first, Recipe second, std::vector<Element> positions,
                          std::uint64_t times) {
  Parameters p = first.parameters;
  p.v = checked_add(p.v, checked_multiply(times, checked_multiply(positions.size(), p.k - 1)));
  return {"concatenate",
          p,
          {{"times", static_cast<std::int64_t>(times)}},
          {std::move(first), std::move(second)},
          {std::move(positions)}};
}

}  // namespace changeover
