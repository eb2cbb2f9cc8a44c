// Designs as people in the field see them.
//
//     Design design(Parameters{.v = 6, .k = 4, .kind = Kind::circular},
//                   std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
//     std::string array = svg(draw(design));
//     std::string stays = svg(draw(design, {.picture = PictureKind::stays}), Theme::dark);
//
// What is drawn need not be valid: a list with wrong steps and uncovered pairs is drawn as it is,
// with both marked, for repairs start there. Nothing is verified here; who verified says so in
// `note`.
//
//   array      blocks as columns, elements in the row in which they stay, as printed in
//              [ChafeeStevens2025]: a star above an element that is introduced, below one that
//              leaves, carets at an expansion set. A step that does not change m elements is marked
//              between its blocks.
//   stays      a row an element, a bar a stay: the blocks from where it is introduced to where it
//              leaves. In a circular design a stay over the end is one.
//   coverage   for each pair of elements, below the diagonal the block of their first meeting,
//              above it how often they are newly covered when that is not once.
//   circle     points on a circle. If the blocks are developed from base blocks under a rotation,
//              these with the pairs that they newly cover and their differences; else the first
//              blocks with theirs.
//   recipe     the tree of constructions that made it, with parameters, numbers of blocks and
//              theorems.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/construct/best_known.hpp"
#include "changeover/construct/one_factorization.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/draw/picture.hpp"

namespace changeover {

enum class PictureKind : std::uint8_t { array, stays, coverage, circle, recipe };

/// The word for a kind of picture: "array", "stays", …
[[nodiscard]] std::string_view to_string(PictureKind kind);

/// The kind of that name; nullopt for any other word.
[[nodiscard]] std::optional<PictureKind> picture_kind_from_string(std::string_view name);

/// The order of elements: of their first blocks, of their numbers of stays, or as they are
/// numbered.
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
  std::optional<std::uint64_t> to = {};             ///< the last one; nullopt: to the end
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

/// Why no blocks can be meant by `from` and `to`, whatever the design, in one line; nullopt if some
/// can.
[[nodiscard]] std::optional<std::string> range_defect(const DrawOptions& options);

/// Why a design with this number of blocks cannot be drawn with these options (range_defect(), or
/// it is too large), in one line that says how a part of it can be drawn; nullopt if it can. Cheap.
[[nodiscard]] std::optional<std::string> draw_defect(const Parameters& p, std::uint64_t blocks,
                                                     const DrawOptions& options);

/// @throws BadInput with the defect, which is BadOption if there is no block `from` or no block
/// `to`; if the picture is of a recipe and the design has none, or a wrong one.
[[nodiscard]] Picture draw(const Design& design, const DrawOptions& options = {});

/// A picture of the design in a stream, which is read from where it stands; labels are empty or one
/// for each element. A circular one is read twice. It has no recipe. @throws also as
/// BlockSource::read() and Transitions.
[[nodiscard]] Picture draw(BlockSource& source, const DrawOptions& options = {},
                           const std::vector<std::string>& labels = {});

/// The tree of a recipe; `note` below its headline. @throws BadInput as Registry::build().
[[nodiscard]] Picture draw_recipe(const Recipe& recipe,
                                  const Registry& registry = Registry::standard(),
                                  const std::string& note = {});

/// A circle shows the base blocks if there are no more: more lines say nothing. Otherwise it has
/// the first two blocks.
inline constexpr std::uint64_t most_circle_blocks = 12;

/// Base blocks that were found in a list of blocks: block i·c + j is the image of base block j
/// under π^(shift·i).
struct FoundRotation {
  Automorphism pi;
  std::uint64_t shift = 1;
  std::vector<Block> base_blocks;  ///< c of them

  bool operator==(const FoundRotation&) const = default;
};

/// The rotation of least c under which a circular design is developed: π is x ↦ x + 1 over Z_v, the
/// same over Z_(v−1) with one fixed element, or has cycles of length b/c and at most three fixed
/// elements; nullopt if there is none. O(b·k·v) at worst, in practice O(b·k).
[[nodiscard]] std::optional<FoundRotation> find_rotation(const Design& design);

// Pictures on a circle: 1-factorizations and cyclic designs.
//
//     FactorFigure k8 = factor_figure(one_factorization(8), 7);
//     std::string page = svg(draw_factors(k8));
//
//     // The base block of DCCD(11,4) and its successor [ChafeeStevens2025, Fig. 3]:
//     CircleFigure circle{.v = 11, .blocks = {{{0, 1, 2, 5}, {2, 5}}, {{1, 2, 3, 6}, {3, 6}}}};
//     std::string figure = tikz(draw_circle(circle));
//
// A picture is 480 by 480 and scalable, and has a title and a description but no headline. Beyond
// seven colours lines are dashed too.

/// A 1-factorization of K_order: one colour a factor.
struct FactorFigure {
  std::uint32_t order = 0;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> factors = {};
  std::vector<std::string> names = {};       ///< of the vertices; empty: 0, 1, …
  std::optional<std::uint32_t> centre = {};  ///< the vertex in the middle, if any
  std::string title = {};                    ///< empty: "1-factorization of K_n"
};

/// Without names. In GK_n, n > 2, it is vertex n − 1 that the rotation fixes and that belongs into
/// the middle.
[[nodiscard]] FactorFigure factor_figure(const OneFactorization& factorization,
                                         std::optional<std::uint32_t> centre = {});

/// A block in a picture, with those of its elements that it introduces.
struct DrawnBlock {
  Block elements;
  Block introduced;
};

/// Blocks on a circle of v points. Each block has a colour, in which its newly covered pairs are
/// drawn: those with an introduced element. Elements that several of the blocks share, or that the
/// only one did not introduce, are black: the unchanged subset.
struct CircleFigure {
  std::uint64_t v = 0;  ///< at most 1000
  std::vector<DrawnBlock> blocks = {};
  std::vector<std::string> names = {};       ///< of the points; empty: 0, 1, …
  std::string title = {};                    ///< empty: "Blocks on v points"
  std::optional<std::uint32_t> centre = {};  ///< the point in the middle, if any
};

/// Blocks `first` to `first` + `count` − 1 of a design (from 0), as far as it has them, with what
/// they introduce.
[[nodiscard]] CircleFigure circle_figure(const Design& design, std::uint64_t first,
                                         std::uint64_t count);

/// @throws BadInput if a vertex, point or the number of names does not fit the order.
[[nodiscard]] Picture draw_factors(const FactorFigure& figure);
[[nodiscard]] Picture draw_circle(const CircleFigure& figure);

// A table of designs as a picture: a square for each v and k.
//
//     const BestKnownTable plan = best_known_table(
//         Registry::standard(), {.v_from = 5, .v_to = 12, .k_from = 3, .k_to = 5});
//     std::vector<KnownCell> cells;
//     for (const KnownCell& cell : plan.cells()) {
//       if (cell.parameters.kind == Kind::linear) {
//         cells.push_back(cell);
//       }
//     }
//     std::string page = svg(draw_heatmap(cells, HeatMeasure::gap));
//
// Each square is a rectangle of class "cell" with data-v and data-k and a title that says in words
// what is known. Colour is never alone: what it cannot say is a sign in the square (= minimum, ?
// open, - none exists).

/// What a colour shows: blocks over the lower bound as a ratio, the status, blocks less the lower
/// bound.
enum class HeatMeasure : std::uint8_t { ratio, status, gap };

/// "ratio", "status" or "gap".
[[nodiscard]] std::string_view to_string(HeatMeasure measure);
[[nodiscard]] std::optional<HeatMeasure> heat_measure_from_string(std::string_view name);

/// The most squares of a picture.
inline constexpr std::size_t most_cells_of_a_heatmap = 20'000;

/// The cells of one kind and one change number, in any order; those that are missing stay empty.
/// @throws BadInput if there is none, if two have the same v and k, if kinds or change numbers
/// differ, or if they span more than most_cells_of_a_heatmap.
[[nodiscard]] Picture draw_heatmap(std::span<const KnownCell> cells, HeatMeasure measure);

}  // namespace changeover
