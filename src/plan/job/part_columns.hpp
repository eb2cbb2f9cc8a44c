// Which columns of a parts list say what, and whether its first row is a header.
//
// A first row that could be either is refused, so that no header becomes a part and no part is lost:
//   - two columns: the first row is a header if its second field is no number and another row's is, or if
//     none has a number but the first row has a word of headers (name, part, sample, price, …);
//   - one column: with such a word, unless it is of another kind than all other rows, which is refused;
//   - more columns need a header.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

struct PartColumns {
  bool header = false;
  std::size_t name = 0;
  std::optional<std::size_t> cost = {};
  std::optional<std::size_t> slot = {};
  std::string note = {};  ///< what was made of the first row, in one line, if that is worth saying
};

/// @throws BadInput through the reader for a first row that could be either, or that is of a run sheet.
[[nodiscard]] PartColumns part_columns(const std::vector<Row>& rows, Header header,
                                       const RowReader& reader);

/// Whether a text is what heads a column of parts: "Part", "component 2", "sample".
[[nodiscard]] bool heads_parts(std::string_view text);

/// The same for a column of costs ("Change cost", "Preis"), and of slots.
[[nodiscard]] bool heads_costs(std::string_view text);
[[nodiscard]] bool heads_slots(std::string_view text);

/// Lower case, of ASCII letters only.
[[nodiscard]] std::string lower(std::string_view text);

}  // namespace changeover
