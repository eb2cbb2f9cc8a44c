// Ring: a linear single-change design made circular by a path from its last block to its first,
// on new elements.
//
// The recipe's input is the design; its first list names positions of the path, and the path's
// blocks follow. The elements in no unchanged subset there are anchors: k−1 in the path's first
// block, k−1 in its last. See construct/tools/concatenation/pieces.hpp.
#include <fmt/format.h>

#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/tools/concatenation/pieces.hpp"
#include "construct/tools/short_blocks.hpp"
#include "core/words.hpp"

namespace changeover::ring_entry {
namespace {

constexpr Description description{
    .name = "ring",
    .summary = "a linear single-change design closed by a path of blocks on new elements",
    .preconditions = "circular, m = 1; disjoint ends; a path that is split but for 2(k-1)",
    .guarantee = "the blocks over the counting bound, before rounding, are those of both",
    .place = "docs/theorems.md, Theorem 13",
};

class Ring final : public Described<Entry, description> {
 public:
  // What it asks for asks neither itself nor this.
  bool asks_registry() const override { return true; }

  // After designs that end with a piece, new elements, or with ends that are apart.
  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::circular) {
      return std::nullopt;
    }
    std::optional<Offer> best;
    for (const WrittenPiece& path : closing_pieces()) {
      if (path.k != p.k || p.v < path.fresh + 2 * p.k) {
        continue;
      }
      auto input = best_concatenation(p.as(Kind::linear).on(p.v - path.fresh), registry, true);
      if (!input) {
        continue;
      }
      std::vector<Block> blocks = short_blocks(path.blocks);
      const std::uint64_t b =
          count_with_pieces(p.v - path.fresh, input->b, closing_piece(blocks, path.positions), 1);
      blocks.insert(blocks.begin(), path.positions);
      if (!best || b < best->b) {
        best = Offer{{std::string(name()), p, {}, {std::move(input->recipe)}, std::move(blocks)},
                     b,
                     false,
                     b == counting_bound(p),
                     false};
      }
    }
    return best;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    return blocks_of(fans(recipe, registry));
  }

  std::unique_ptr<FanSource> fans(const Recipe& recipe, const Registry& registry) const override {
    Piece piece = path_of(recipe);
    return with_pieces(registry.fans(recipe.inputs.front()), std::move(piece), 1,
                       recipe.parameters);
  }

  std::string explain(const Recipe& recipe) const override {
    const Piece piece = path_of(recipe);
    return fmt::format(
        "Close the {} by a path of {} on {} and {} at each of its ends; beside "
        "{} unchanged subsets, which hold all new ones, every other element is inserted.",
        changeover::name(recipe.inputs.front().parameters), count_of(piece.blocks.size(), "block"),
        count_of(piece.fresh.size(), "new element"), piece.first.size(), piece.parts.size());
  }

 private:
  Piece path_of(const Recipe& recipe) const {
    const Parameters& p = recipe.parameters;
    const bool fits = recipe.inputs.size() == 1 && recipe.arguments.empty() &&
                      recipe.blocks.size() > 2 && asks_for_pairs(p, 1) &&
                      p.kind == Kind::circular && recipe.provenance.empty();
    if (fits) {
      const Parameters& input = recipe.inputs.front().parameters;
      const std::uint64_t fresh = recipe.blocks.front().size() * (p.k - 1);
      std::vector<Block> blocks(recipe.blocks.begin() + 1, recipe.blocks.end());
      if (input.v >= 2 * p.k - 2 && p.v > fresh && input == p.as(Kind::linear).on(p.v - fresh)) {
        for (const Block& block : blocks) {
          if (block.size() != p.k) {
            throw BadInput(
                fmt::format("ring: a block of the path has {}, not k = {}; correct the block",
                            count_of(block.size(), "element"), p.k));
          }
        }
        return closing_piece(std::move(blocks), recipe.blocks.front());
      }
    }
    throw BadInput(fmt::format(
        "ring to {} takes a linear single-change design with the same k, positions of a path that "
        "hold k-1 new elements each, and the blocks of the path; correct the recipe",
        changeover::name(p)));
  }
};

}  // namespace

const Construction& construction() { return only<Ring>(); }

}  // namespace changeover::ring_entry
