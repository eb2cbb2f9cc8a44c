// What the files in src/construct/entries share: recognising their own recipes, choosing a design
// to build upon, and a list of blocks as a stream.
//
//     std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
//       require_recipe(recipe, *this, recipe_for(recipe.parameters));   // BadInput, in one line
//       …
//     }
//
// A construction that has only one recipe for given parameters compares the whole of it: what is
// built is then what was offered, and nothing else in a recipe can be silently ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"

namespace changeover {

/// Whether p asks that pairs be covered (strength 2) with m = change, and 2 ≤ k, m ≤ k ≤ v < 2³²,
/// so that products of two of its numbers fit in 64 bits. Never throws, unlike check().
[[nodiscard]] bool asks_for_pairs(const Parameters& p, std::uint64_t change);

/// @throws BadInput, in one line that says what does not fit and what would, unless `recipe` equals
/// `expected`, the only recipe of the construction for these parameters (nullopt if there is none).
void require_recipe(const Recipe& recipe, const Construction& construction,
                    const std::optional<Recipe>& expected);

/// The number of recipes in the tree, itself included.
[[nodiscard]] std::size_t recipe_size(const Recipe& recipe);

/// What a construction needs of the design that it works on.
enum class Need : std::uint8_t { blocks, expansion_set };

/// The offer to build upon: of all constructions but `asking`, the one with the fewest blocks; ties
/// go to a tight one, then to one with an expansion set, then to the smaller recipe, then by name.
///
/// @note So that offers end, whoever asks must ask for fewer elements or, as cut does, for a
/// circular design where a linear one is wanted.
[[nodiscard]] std::optional<Offer> best_input(const Parameters& p, Need need,
                                              const Construction& asking, const Registry& registry);

/// The offer with the fewest blocks of the constructions that do not ask the registry; a circular
/// design serves as a linear one, cut open.
[[nodiscard]] std::optional<Offer> best_leaf(const Parameters& p, const Registry& registry);

/// "0,1,2", or "0,…,9" when there are many; for explanations.
[[nodiscard]] std::string first_elements(std::uint64_t count);

/// A stream that owns its list of blocks.
class BlockListSource final : public BlockSource {
 public:
  /// @throws BadInput unless `parameters` can be those of a design and each block has k distinct
  /// elements below v, at least one block. O(bk log k).
  BlockListSource(const Parameters& parameters, std::vector<Block> blocks);

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return blocks_.size(); }
  bool next(std::span<Element> block) override;
  bool rewind() override {
    position_ = 0;
    return true;
  }

 private:
  Parameters parameters_;
  std::vector<Block> blocks_;
  std::size_t position_ = 0;
};

}  // namespace changeover
