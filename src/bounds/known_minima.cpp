// Lower bounds proved by SAT, where they are higher than every bound on paper.
//
// Every smaller number from the bound on paper up was excluded by SAT, and each DRAT proof was
// checked: see docs/trust.md. docs/minima.md says how large the proofs are and whether a design
// meets the bound.
#include "bounds/known_minima.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace changeover {
namespace {

struct Row {
  std::uint32_t strength;
  std::uint64_t change;
  Kind kind;
  std::uint64_t k, v, blocks;
};

constexpr std::array<Row, 52> rows{{
    {2, 2, Kind::linear, 4, 12, 14},   {2, 2, Kind::linear, 5, 9, 6},
    {2, 2, Kind::linear, 5, 11, 9},    {2, 2, Kind::linear, 5, 13, 12},
    {2, 2, Kind::linear, 6, 13, 10},   {2, 2, Kind::circular, 2, 5, 11},
    {2, 2, Kind::circular, 7, 14, 10}, {2, 3, Kind::linear, 3, 8, 12},
    {2, 3, Kind::linear, 3, 9, 14},    {2, 3, Kind::linear, 4, 9, 8},
    {2, 3, Kind::linear, 4, 10, 9},    {2, 3, Kind::linear, 5, 9, 6},
    {2, 3, Kind::linear, 5, 12, 9},    {2, 3, Kind::linear, 5, 13, 10},
    {2, 3, Kind::linear, 6, 11, 6},    {2, 3, Kind::linear, 6, 14, 9},
    {2, 3, Kind::linear, 7, 13, 6},    {2, 3, Kind::linear, 7, 16, 9},
    {2, 3, Kind::linear, 8, 14, 6},    {2, 3, Kind::circular, 3, 8, 12},
    {2, 3, Kind::circular, 3, 9, 14},  {2, 3, Kind::circular, 4, 9, 8},
    {2, 3, Kind::circular, 4, 10, 9},  {2, 3, Kind::circular, 5, 9, 6},
    {2, 3, Kind::circular, 5, 12, 9},  {2, 3, Kind::circular, 5, 13, 10},
    {2, 3, Kind::circular, 6, 11, 6},  {2, 3, Kind::circular, 6, 14, 9},
    {2, 3, Kind::circular, 6, 15, 10}, {2, 3, Kind::circular, 7, 16, 9},
    {3, 1, Kind::circular, 4, 6, 8},   {3, 1, Kind::circular, 4, 7, 13},
    {3, 1, Kind::circular, 5, 8, 12},  {3, 1, Kind::circular, 5, 9, 15},
    {3, 1, Kind::circular, 6, 9, 11},  {3, 2, Kind::linear, 4, 6, 6},
    {3, 2, Kind::linear, 4, 7, 10},    {3, 2, Kind::linear, 5, 7, 5},
    {3, 2, Kind::linear, 5, 8, 8},     {3, 2, Kind::circular, 4, 6, 6},
    {3, 2, Kind::circular, 4, 7, 10},  {3, 2, Kind::circular, 5, 7, 6},
    {3, 2, Kind::circular, 5, 8, 8},   {3, 2, Kind::circular, 6, 9, 8},
    {3, 3, Kind::linear, 4, 7, 15},    {3, 3, Kind::linear, 5, 8, 8},
    {3, 3, Kind::linear, 5, 9, 10},    {3, 3, Kind::linear, 6, 9, 7},
    {3, 3, Kind::circular, 4, 7, 17},  {3, 3, Kind::circular, 5, 8, 8},
    {3, 3, Kind::circular, 5, 9, 10},  {3, 3, Kind::circular, 6, 9, 8},
}};

constexpr auto place(const Row& row) {
  return std::tuple(row.strength, row.change, row.kind, row.k, row.v);
}

static_assert(std::ranges::is_sorted(rows, [](const Row& a, const Row& b) {
  return place(a) < place(b);
}));

}  // namespace

std::optional<std::uint64_t> excluded_below(const Parameters& p) {
  const auto wanted = std::tuple(p.strength, p.change, p.kind, p.k, p.v);
  const auto row = std::lower_bound(rows.begin(), rows.end(), wanted,
                                    [](const Row& a, const auto& b) { return place(a) < b; });
  return row == rows.end() || place(*row) != wanted ? std::nullopt : std::optional(row->blocks);
}

}  // namespace changeover
