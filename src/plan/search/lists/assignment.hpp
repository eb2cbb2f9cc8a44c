// The cheapest assignment of the rows of a table to different columns.
//
// For the rows 4 1 3 and 2 0 5 it is 3: the third column of the first row and the second column of
// the second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace changeover {

/// The least sum of entries, one per row, no two in a column, of a table given row by row; rows ≤
/// columns. The Hungarian method with potentials and shortest augmenting paths [Kuhn1955]. O(rows²
/// · columns).
[[nodiscard]] std::int64_t cheapest_assignment(std::size_t rows, std::size_t columns,
                                               std::span<const std::int64_t> costs);

}  // namespace changeover
