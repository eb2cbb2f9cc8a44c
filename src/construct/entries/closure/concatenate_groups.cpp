// Concatenate with groups: a design and pieces on groups of new elements, for every m ≥ 2.
//
// The recipe's inputs are W, the circular design of the pieces unless each is one block, and the
// linear design of the last piece if that is another. Its lists are the positions of the parts of W
// and the hinge. Arguments: `groups`, how many; `at`, the position of the hinge; `reversed`, 1 if
// all this is of W read backwards; `dropped`, how many pieces lack the blocks inside the hole. See
// construct/tools/concatenation/groups.hpp.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/concatenation/groups.hpp"
#include "construct/trusted_entry.hpp"

namespace changeover::concatenate_groups_entry {
namespace {

constexpr Description description{
    .name = "concatenate-groups",
    .summary = "a design, and pieces on groups of new elements at one of its unchanged subsets",
    .preconditions = "m >= 2; disjoint unchanged subsets, one for each class of the groups",
    .guarantee = "the new pairs over those covered are those of the design and of the pieces",
    .place = "docs/theorems.md, Theorem 15",
};

struct Given {
  Grouping how;
  const Recipe* base = nullptr;
  const Recipe* closed = nullptr;
  const Recipe* open = nullptr;
};

class ConcatenateGroups final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Given given = required(recipe);
    const auto design_of = [&](const Recipe* input) {
      return input == nullptr ? std::nullopt
                              : std::optional<Design>(read_within_memory(*registry.build(*input)));
    };
    const std::optional<Design> base = design_of(given.base);
    const std::optional<Design> closed = design_of(given.closed);
    const std::optional<Design> open = design_of(given.open);
    return std::make_unique<BlockListSource>(
        recipe.parameters, with_groups(recipe.parameters, given.how, *base,
                                       closed ? &*closed : nullptr, open ? &*open : nullptr));
  }

  std::string explain(const Recipe& recipe) const override {
    const Given given = required(recipe);
    const Groups& groups = given.how.groups;
    const std::size_t parts = given.how.hinge.positions.size();
    const std::uint64_t hole =
        given.base->parameters.v - parts * (recipe.parameters.k - recipe.parameters.change);
    std::string pieces = fmt::format("a {}-subset of the hole and the group", recipe.parameters.k);
    if (given.closed != nullptr) {
      pieces = fmt::format("the {} opened there", changeover::name(given.closed->parameters));
    }
    return fmt::format(
        "The {} has {} disjoint unchanged subsets. At each of them the new elements, {} groups of "
        "{}, are inserted so that two of different groups meet. The {} old elements that are "
        "left, the hole, meet each group in a piece: {}{}{}.",
        changeover::name(given.base->parameters), parts, groups.groups, groups.size, hole, pieces,
        given.how.dropped == 0
            ? ""
            : fmt::format(", {} of them without the blocks inside the hole", given.how.dropped),
        given.open == nullptr
            ? ""
            : fmt::format(", and the {} at the end", changeover::name(given.open->parameters)));
  }

 private:
  /// @throws BadInput if the recipe is none.
  Given required(const Recipe& recipe) const {
    const Parameters& p = recipe.parameters;
    Given given;
    const auto argument = [&](const char* name, std::uint64_t& to) {
      const auto found = recipe.arguments.find(name);
      if (found == recipe.arguments.end() || found->second < 0) {
        return false;
      }
      to = static_cast<std::uint64_t>(found->second);
      return true;
    };
    std::uint64_t reversed = 0;
    if (asks_for_pairs(p, p.change) && p.change >= 2 && p.change < p.k &&
        recipe.arguments.size() == 4 && argument("groups", given.how.groups.groups) &&
        argument("at", given.how.hinge.at) && argument("reversed", reversed) && reversed < 2 &&
        argument("dropped", given.how.dropped) && recipe.blocks.size() == 2 &&
        !recipe.inputs.empty() && recipe.inputs.size() <= 3) {
      given.how.hinge.reversed = reversed == 1;
      given.how.hinge.positions = recipe.blocks[0];
      given.how.hinge.elements = recipe.blocks[1];
      given.base = &recipe.inputs[0];
      const std::uint64_t groups = given.how.groups.groups;
      const std::uint64_t w = given.base->parameters.v;
      const bool base_fits = fits(p, *given.base) && w < p.v && groups >= 2 &&
                             (p.v - w) % groups == 0 &&
                             (p.kind == Kind::linear || is_circular(*given.base)) &&
                             !(given.how.hinge.reversed && is_circular(*given.base));
      if (base_fits && pieces_fit(recipe, given)) {
        given.how.groups.size = (p.v - w) / groups;
        return given;
      }
    }
    throw BadInput(fmt::format(
        "concatenate-groups to {} takes groups, at, reversed (0 or 1) and dropped; a design of "
        "fewer elements, for the pieces a circular one, a linear one or both; positions of parts, "
        "and the hinge",
        changeover::name(p)));
  }

  static bool is_circular(const Recipe& recipe) { return recipe.parameters.kind == Kind::circular; }

  static bool fits(Parameters p, const Recipe& input) {
    p.v = input.parameters.v;
    p.kind = input.parameters.kind;
    return p == input.parameters && p.v >= p.k;
  }

  // Only where the list ends with the pieces may the last one be open.
  static bool pieces_fit(const Recipe& recipe, Given& given) {
    for (std::size_t i = 1; i < recipe.inputs.size(); ++i) {
      const Recipe& input = recipe.inputs[i];
      const Recipe*& place = is_circular(input) ? given.closed : given.open;
      if (!fits(recipe.parameters, input) || place != nullptr || (i == 2 && is_circular(input))) {
        return false;
      }
      place = &input;
    }
    return given.open == nullptr || recipe.parameters.kind == Kind::linear;
  }
};

}  // namespace

const Construction& construction() { return only<ConcatenateGroups>(); }

}  // namespace changeover::concatenate_groups_entry
