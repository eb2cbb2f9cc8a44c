// Minima settled by exhaustive search, where no bound above reaches them.
//
// Computed once by up to three independent programs: two SAT models and a depth-first search. The same
// table, whole, is tests/data/minimum.csv.
#include "known_minima.hpp"

#include <algorithm>
#include <array>

namespace changeover {
namespace {

constexpr std::string_view dfs = "depth-first search";
constexpr std::string_view sat = "a SAT model";
constexpr std::string_view sat_dfs = "a SAT model and depth-first search";
constexpr std::string_view two_sat = "two SAT models";
constexpr std::string_view all = "two SAT models and depth-first search";

struct Row {
  std::uint64_t change;
  Kind kind;
  std::uint64_t v, k, minimum;
  std::string_view by;
};

constexpr std::array<Row, 11> rows{{
    {1, Kind::linear, 9, 4, 12, all},
    {1, Kind::linear, 10, 4, 15, all},
    {1, Kind::linear, 11, 5, 14, all},
    {2, Kind::circular, 5, 2, 11, sat_dfs},
    {2, Kind::circular, 5, 3, 5, all},
    {2, Kind::circular, 11, 5, 9, all},
    {2, Kind::linear, 5, 3, 5, all},
    {2, Kind::linear, 12, 4, 14, sat},
    {2, Kind::linear, 9, 5, 6, all},
    {2, Kind::linear, 11, 5, 9, all},
    {2, Kind::linear, 13, 5, 12, sat},
}};

}  // namespace

std::optional<KnownMinimum> known_minimum(const Parameters& p) {
  if (p.strength != 2) {
    return std::nullopt;
  }
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
    return r.change == p.change && r.kind == p.kind && r.v == p.v && r.k == p.k;
  });
  return row == rows.end() ? std::nullopt : std::optional(KnownMinimum{row->minimum, row->by});
}

}  // namespace changeover
