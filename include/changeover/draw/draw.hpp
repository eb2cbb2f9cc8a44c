// Designs as people in the field see them.
//
//     Design design(Parameters{.v = 6, .k = 4, .kind = Kind::circular},
//                   std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
//     std::string array = svg(draw(design));
//     std::string stays = svg(draw(design, {.picture = PictureKind::stays}), Theme::dark);
//
// What is drawn need not be valid: a list with wrong steps and uncovered pairs is drawn as it is, with both marked, for
// repairs start there. Nothing is verified here; who verified says so in `note`.
//
//   array      blocks as columns, elements in the row in which they stay, as printed in [ChafeeStevens2025]: a star above an element
//              that is introduced, below one that leaves, carets at an expansion set. A step that does not change m
//              elements is marked between its blocks.
//   stays      a row an element, a bar a stay: the blocks from where it is introduced to where it leaves. In a circular
//              design a stay over the end is one.
//   coverage   for each pair of elements, below the diagonal the block of their first meeting, above it how often they are
//              newly covered when that is not once.
//   circle     points on a circle. If the blocks are developed from base blocks under a rotation, these with the pairs that they
//              newly cover and their differences; else the first blocks with theirs.
//   recipe     the tree of constructions that made it, with parameters, numbers of blocks and theorems.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/core/automorphism.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/recipe.hpp"
#include "changeover/core/transitions.hpp"
#include "changeover/draw/picture.hpp"

namespace changeover {

enum class PictureKind : std::uint8_t { array, stays, coverage, circle, recipe };

/// "array", "stays", …
[[nodiscard]] std::string_view to_string(PictureKind kind);

/// The kind of that name; nullopt for any other word.
[[nodiscard]] std::optional<PictureKind> picture_kind_from_string(std::string_view name);

/// The order of elements: of their first blocks, of their numbers of stays, or as they are numbered.
enum class ElementOrder : std::uint8_t { first, stays, given };

/// "first", "stays" or "given".
[[nodiscard]] std::string_view to_string(ElementOrder order);
[[nodiscard]] std::optional<ElementOrder> element_order_from_string(std::string_view name);

/// What the colour of a stay says: how long it is, or its number among those of its element.
enum class StayColour : std::uint8_t { length, ordinal };

[[nodiscard]] std::string_view to_string(StayColour colour);
[[nodiscard]] std::optional<StayColour> stay_colour_from_string(std::string_view name);

struct DrawOptions {
  PictureKind picture = PictureKind::array;
  ElementOrder order = ElementOrder::first;         ///< of stays and coverage
  StayColour colour = StayColour::length;           ///< of stays
  bool leaving = false;                             ///< array: mark leaving elements too
  std::vector<UnchangedSubset> expansion_set = {};  ///< array: marked by carets
  std::uint64_t from = 1;                           ///< the first block that is drawn, from 1
  std::optional<std::uint64_t> to = {};             ///< the last one; nothing: to the end
  std::string name = {};  ///< in the headline; empty: the parameters and the number of blocks
  std::string note = {};  ///< below the headline: one line, for instance the verdict
};

/// How much is drawn at once.
inline constexpr std::uint64_t most_drawn_blocks = 20'000;       ///< array, stays
inline constexpr std::uint64_t most_drawn_elements = 200'000;    ///< array: blocks times k
inline constexpr std::uint64_t most_drawn_rows = 2'000;          ///< stays: v
inline constexpr std::uint64_t most_drawn_lines = 500;           ///< coverage: v
inline constexpr std::uint64_t most_drawn_points = 1'000;        ///< circle: v
inline constexpr std::uint64_t most_read_elements = 20'000'000;  ///< circle: blocks times k

/// Why no blocks can be meant by `from` and `to`, whatever the design, in one line; nullopt if some can.
[[nodiscard]] std::optional<std::string> range_defect(const DrawOptions& options);

/// The same, or why so many blocks cannot be drawn like this, in one line that says how a part of them can; nullopt if they can. Cheap.
[[nodiscard]] std::optional<std::string> draw_defect(const Parameters& p, std::uint64_t blocks,
                                                     const DrawOptions& options);

/// @throws BadInput with the defect, which is BadOption if there is no block `from` or no block `to`; if the picture is of a recipe and the design has
/// none, or a wrong one.
[[nodiscard]] Picture draw(const Design& design, const DrawOptions& options = {});

/// The same of a stream, which is read from where it stands; labels are empty or one for each element. A circular one is read twice.
/// It has no recipe. @throws also as BlockSource::read() and Transitions.
[[nodiscard]] Picture draw(BlockSource& source, const DrawOptions& options = {},
                           const std::vector<std::string>& labels = {});

/// The tree of a recipe; `note` below its headline. @throws BadInput as Registry::build().
[[nodiscard]] Picture draw_recipe(const Recipe& recipe,
                                  const Registry& registry = Registry::standard(),
                                  const std::string& note = {});

/// Base blocks that were found in a list of blocks: block i·c + j is the image of base block j under π^(shift·i).
struct FoundRotation {
  Automorphism pi;
  std::uint64_t shift = 1;
  std::vector<Block> base_blocks;  ///< c of them

  bool operator==(const FoundRotation&) const = default;
};

/// The rotation of least c under which a circular design is developed: π is x ↦ x + 1 over Z_v, the same over Z_(v−1) with one
/// fixed element, or has cycles of length b/c and at most three fixed elements; nullopt if there is none.
/// O(b·k·v) at worst, in practice O(b·k).
[[nodiscard]] std::optional<FoundRotation> find_rotation(const Design& design);

}  // namespace changeover
