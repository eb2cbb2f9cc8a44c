// Join ends: a linear design closed to a circular one by the blocks of a shortest way from its last
// block to its first.
//
// All pairs stay covered. If s is the least number of steps from the last block to the first, s − 1
// blocks are added: those between them. Where the two differ in d elements, s is ⌈d/m⌉ or more. It
// is more if d < m, and in some narrow cases (construct/tools/path.hpp).
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/path.hpp"
#include "construct/trusted_entry.hpp"

namespace changeover::join_ends_entry {
namespace {

constexpr Description description{
    .name = "join-ends",
    .summary = "a linear design, and after it a shortest way from its last block back to its first",
    .preconditions =
        "circular; as input a linear design on (v,k), same m, >= 3 blocks, the last not the first",
    .guarantee = "s-1 more blocks, if s is the least number of steps from the last to the first",
};

class JoinEnds final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    const Parameters& p = recipe.parameters;
    if (p.kind != Kind::circular || p.v <= p.k) {
      require_recipe(recipe, *this, std::nullopt);
    }
    require_input(recipe, p.as(Kind::linear), {});
    const Design design = read_within_memory(*registry.build(recipe.inputs.front()));
    std::vector<Block> blocks = design.blocks();
    if (!join_ends_recipe(recipe.inputs.front(), design)) {
      throw BadInput(fmt::format(
          "join-ends needs a linear design of 3 blocks or more, the last not the first; this "
          "{} is none",
          changeover::name(design.parameters())));
    }
    for (Block& each : connecting_blocks(blocks.back(), blocks.front(), p.change, p.v)) {
      blocks.push_back(std::move(each));
    }
    return std::make_unique<BlockListSource>(p, std::move(blocks));
  }

  std::string explain(const Recipe& recipe) const override {
    require_input(recipe, recipe.parameters.as(Kind::linear), {});
    return fmt::format("Close the {} by a shortest way from its last block to its first.",
                       changeover::name(recipe.inputs.front().parameters));
  }
};

}  // namespace

const Construction& construction() { return only<JoinEnds>(); }

}  // namespace changeover::join_ends_entry

namespace changeover {

std::optional<Made> join_ends_recipe(const Recipe& input, const Design& design) {
  const Parameters& p = input.parameters;
  if (p.kind != Kind::linear || design.block_count() < 3) {
    return std::nullopt;
  }
  const auto first = design.block(0);
  const auto last = design.block(design.block_count() - 1);
  const std::uint64_t distance = distance_between(last, first);
  const auto steps = connecting_steps(distance, p.k, p.change, p.v);
  if (distance == 0 || !steps) {
    return std::nullopt;
  }
  return Made{{"join-ends", p.as(Kind::circular), {}, {input}, {}},
              design.block_count() + *steps - 1};
}

}  // namespace changeover
