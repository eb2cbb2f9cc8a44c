// A table of designs as a picture: a square for each v and k.
//
//     const Plan plan = plan_range(Registry::standard(), {.v_from = 5, .v_to = 12, .k_from = 3, .k_to = 5});
//     std::vector<PlannedCell> cells;
//     for (const PlannedCell& cell : plan.cells()) {
//       if (cell.parameters.kind == Kind::linear) {
//         cells.push_back(cell);
//       }
//     }
//     std::string page = svg(draw_heatmap(cells, HeatMeasure::gap));
//
// Each square is a rectangle of class "cell" with data-v and data-k and a title that says in words what is known. Colour
// is never alone: what it cannot say is a sign in the square (= minimum, ? open, - none exists).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "changeover/construct/planner.hpp"
#include "changeover/draw/picture.hpp"

namespace changeover {

/// What a colour says: blocks over the lower bound as a ratio, the status, blocks less the lower bound.
enum class HeatMeasure : std::uint8_t { ratio, status, gap };

/// "ratio", "status" or "gap".
[[nodiscard]] std::string_view to_string(HeatMeasure measure);
[[nodiscard]] std::optional<HeatMeasure> heat_measure_from_string(std::string_view name);

/// The most squares of a picture.
inline constexpr std::size_t most_cells_of_a_heatmap = 20'000;

/// The cells of one kind and one change number, in any order; those that are missing stay empty.
/// @throws BadInput if there is none, if two have the same v and k, if kinds or change numbers differ, or if they span more than
/// most_cells_of_a_heatmap.
[[nodiscard]] Picture draw_heatmap(std::span<const PlannedCell> cells, HeatMeasure measure);

}  // namespace changeover
