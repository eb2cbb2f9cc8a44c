// Unfix: take away an element that is in every block, the converse of fix. The steps change what
// they changed and the other pairs are where they were, so a design on (v+1, k+1) becomes one on
// (v, k). Whether an element is in every block is known only when they are there, so nothing is
// offered; see construct/best_known.hpp.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"

namespace changeover::unfix_entry {
namespace {

constexpr Description description{
    .name = "unfix",
    .summary = "take away an element that is in every block",
    .preconditions = "a design on (v+1, k+1), m <= k, with a fixed element",
    .guarantee = "as many blocks",
};

class Unfix final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const auto without = [fixed = taken(recipe)](std::span<const Element> from,
                                                 std::span<Element> to) {
      std::size_t at = 0;
      for (const Element x : from) {
        if (x != fixed && at < to.size()) {
          to[at++] = x > fixed ? x - 1 : x;
        }
      }
      if (at != to.size() || std::ranges::find(from, fixed) == from.end()) {
        throw BadInput(
            fmt::format("unfix: element {} is not in every block; name one that is", fixed));
      }
    };
    return mapped(recipe.parameters, registry.build(recipe.inputs.front()), without);
  }

  std::string explain(const Recipe& recipe) const override {
    return fmt::format(
        "Take element {} out of every block of the {}; larger elements move up by one.",
        taken(recipe), changeover::name(recipe.inputs.front().parameters));
  }

 private:
  Element taken(const Recipe& recipe) const {
    Parameters larger = recipe.parameters;
    ++larger.v;
    ++larger.k;
    return element_of(
        recipe, larger,
        fmt::format("one input, a {}, and the element to take away", changeover::name(larger)));
  }
};

}  // namespace

const Construction& construction() { return only<Unfix>(); }

}  // namespace changeover::unfix_entry

namespace changeover {

std::optional<Recipe> unfix_recipe(const Recipe& input, const Design& design) {
  const Parameters& p = input.parameters;
  if (design.block_count() == 0 || p.k <= p.change || p.k <= p.strength) {
    return std::nullopt;
  }
  std::vector<std::size_t> blocks(static_cast<std::size_t>(p.v), 0);
  for (const Element x : design.elements()) {
    ++blocks[x];
  }
  const auto fixed = std::ranges::find(blocks, design.block_count());
  if (fixed == blocks.end()) {
    return std::nullopt;
  }
  Parameters smaller = p;
  --smaller.v;
  --smaller.k;
  return Recipe{"unfix", smaller, {{"element", fixed - blocks.begin()}}, {input}, {}};
}

}  // namespace changeover
