// Which columns of a parts list say what, and whether its first row is a header.
//
// A first row that could be either is refused, so that no header becomes a part and no part is
// lost:
//   - two columns: the first row is a header if its second field is no number and another row's is,
//     or if none has a number but the first row has a word of headers (name, part, sample, price,
//     …);
//   - one column: with such a word, unless it is of another kind than all other rows, which is
//     refused;
//   - more columns need a header.
// Rows of one field above a header of several, as a title is, say nothing; nor does a last row
// `Total` with the sum of the costs.
//
// The column of the costs is that which is named; else one of what changes cost ("Change cost",
// "Swap time (min)"), else one of costs, else one of times and work whose fields are numbers. Two
// of the same kind are refused. Slots are in the column "slot", or in one of which more than half
// is names of slots that are known.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {

struct PartColumns {
  bool header = false;
  std::size_t above = 0;  ///< rows that come before the header, or before the first part
  std::size_t name = 0;
  std::optional<std::size_t> cost = {};
  std::optional<std::size_t> slot = {};
  std::optional<std::size_t> quantity = {};
  CostUnit unit = CostUnit::none;  ///< as the head of the costs says
  std::string note = {};  ///< what was made of the first row, in one line, if that is worth saying
};

/// @throws BadInput through the reader for a first row that could be either, or that is of a run
/// sheet, and for a column that is not there.
[[nodiscard]] PartColumns part_columns(const std::vector<Row>& rows, const PartListOptions& options,
                                       const RowReader& reader);

}  // namespace changeover
