// Finds the columns of a parts list, and whether its first row is a header.
//
// A first row that could be either is refused, so that no header becomes a part and no part is
// lost:
//   - two columns: the first row is a header if its second field is not a number and another row's
//     is; or if no row has a number there, but the first row has a header word (name, part, sample,
//     price, …);
//   - one column: with such a word, unless it is of another kind than all other rows, which is
//     refused;
//   - more columns need a header.
//
// Rows of one field above a header of several, such as a title, are ignored, and so is a last row
// `Total` with the sum of the costs.
//
// The column of the costs is the one that was named; otherwise one for changes ("Change cost",
// "Swap time (min)"), otherwise one of costs, otherwise one of times and work whose fields are
// numbers. Two of the same kind are refused. Slots are in the column "slot", or in one where more
// than half of the fields are known slots.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {

struct PartColumns {
  bool header = false;
  std::size_t above = 0;  ///< number of rows before the header, or before the first part
  std::size_t name = 0;
  std::optional<std::size_t> cost = {};
  std::optional<std::size_t> slot = {};
  std::optional<std::size_t> quantity = {};
  CostUnit unit = CostUnit::none;  ///< from the heading of the costs
  std::string note =
      {};  ///< one line on how the first row was interpreted, if that is worth telling
};

/// @throws BadInput through the reader for a first row that could be either, for one of a run
/// sheet, and for a column that does not exist.
[[nodiscard]] PartColumns part_columns(const std::vector<Row>& rows, const PartListOptions& options,
                                       const RowReader& reader);

}  // namespace changeover
