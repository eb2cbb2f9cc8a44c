// Pictures on a circle: 1-factorizations and cyclic designs.
//
//     FactorFigure k8 = factor_figure(one_factorization(8), 7);
//     std::string page = svg(draw_factors(k8));
//
//     // The base block of DCCD(11,4) and its successor [ChafeeStevens2025, Fig. 3]:
//     CircleFigure circle{.v = 11, .blocks = {{{0, 1, 2, 5}, {2, 5}}, {{1, 2, 3, 6}, {3, 6}}}};
//     std::string figure = tikz(draw_circle(circle));
//
// A picture is 480 by 480 and scalable, and has a title and a description but no headline. Beyond seven colours lines are dashed
// too.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/draw/picture.hpp"

namespace changeover {

/// A 1-factorization of K_order: one colour a factor.
struct FactorFigure {
  std::uint32_t order = 0;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> factors = {};
  std::vector<std::string> names = {};       ///< of the vertices; empty: 0, 1, …
  std::optional<std::uint32_t> centre = {};  ///< the vertex in the middle, if one shall be there
  std::string title = {};                    ///< empty: "1-factorization of K_n"
};

/// Without names. In GK_n, n > 2, it is vertex n − 1 that the rotation fixes and that belongs into the middle.
[[nodiscard]] FactorFigure factor_figure(const OneFactorization& factorization,
                                         std::optional<std::uint32_t> centre = {});

/// A block in a picture, with those of its elements that it introduces.
struct DrawnBlock {
  Block elements;
  Block introduced;
};

/// Blocks on a circle of v points. Each block has a colour, in which its newly covered pairs are drawn:
/// those with an introduced element. Elements that several of the blocks share, or that the only
/// one did not introduce, are black: the unchanged subset.
struct CircleFigure {
  std::uint64_t v = 0;  ///< at most 1000
  std::vector<DrawnBlock> blocks = {};
  std::vector<std::string> names = {};       ///< of the points; empty: 0, 1, …
  std::string title = {};                    ///< empty: "Blocks on v points"
  std::optional<std::uint32_t> centre = {};  ///< the point in the middle, if one shall be there
};

/// Blocks `first` to `first` + `count` − 1 of a design (from 0), as far as it has them, with what they
/// introduce.
[[nodiscard]] CircleFigure circle_figure(const Design& design, std::uint64_t first,
                                         std::uint64_t count);

/// @throws BadInput if a vertex, point or the number of names does not fit the order.
[[nodiscard]] Picture draw_factors(const FactorFigure& figure);
[[nodiscard]] Picture draw_circle(const CircleFigure& figure);

}  // namespace changeover
