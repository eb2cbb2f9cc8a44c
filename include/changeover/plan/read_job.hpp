// What an experimenter writes down: parts with their change costs, pairs, and set-ups.
//
//     # bench.csv                          pairs.csv              done.csv
//     component,change cost                Pump A,Valve 2         Pump A,Valve 2,Motor
//     Pump A,12.50                         3,7                    2,3,5
//     "Valve, large",8
//
// Files are rows of fields with commas, or with semicolons if the first row has one before any comma; a
// field may be quoted; lines that begin with # and blank lines say nothing. Where a part is expected, its
// name or its number in the parts list counts, from 1; a name wins over a number.
//   - Parts: a name, and a change cost if there is a second field. A first row is a header if its first
//     field is name, part, component or item, or if its second is a word without digits; then the columns
//     for names and for costs (the first one that says "cost") are found by it, and others are ignored.
//   - Pairs: two parts a row.
//   - Set-ups: the parts of one a row. The CSV of a run sheet (plan/sheet_formats.hpp) is taken too: its
//     columns slot_1, slot_2, … count, or its column set_up with all parts in one field, and its rows in
//     their order.
// Lists are UTF-8; control characters and those that turn the direction of writing around are refused.
// They are read a line at a time: at most 16 MiB a line, 1 GiB and 4,194,304 rows in all.
// A violation is BadInput with one line: `NAME:LINE:COLUMN: what is wrong; how to mend it`.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/plan/job.hpp"

namespace changeover {

struct PartList {
  std::vector<std::string> names;
  std::vector<std::optional<Amount>> change_costs;  ///< by part; nothing where none is given
};

/// The parts in the order of their rows.
/// @throws BadInput for no part, an empty or repeated name, a cost that is none, too many fields;
/// MissingResource if reading fails.
[[nodiscard]] PartList read_parts(Input& input);

/// The pairs, as elements below names.size(); repetitions are fine. @throws BadInput for unknown parts, a
/// part with itself, rows that are no pair; MissingResource if reading fails.
[[nodiscard]] PairSet read_pairs(Input& input, const std::vector<std::string>& names);

/// The set-ups in order. @throws BadInput for unknown or repeated parts and for a set-up of more than
/// `at_once`; MissingResource if reading fails.
[[nodiscard]] std::vector<Block> read_setups(
    Input& input, const std::vector<std::string>& names,
    std::uint64_t at_once = std::numeric_limits<std::uint64_t>::max());

/// Parts in one line, "Pump A, 3"; fields as in files. @throws BadInput (without a place) for unknown or
/// repeated parts.
[[nodiscard]] Block parse_parts(std::string_view text, const std::vector<std::string>& names);

/// The same parts again by name, so that parse_parts() reads them back.
[[nodiscard]] std::string parts_text(const Block& parts, const std::vector<std::string>& names);

}  // namespace changeover
