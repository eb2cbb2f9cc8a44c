// Designs as CSV, for spreadsheets and data frames.
//
//     block,element_1,element_2,element_3,element_4,v,change,kind
//     1,0,1,2,3,6,2,circular
//     2,4,5,2,3,6,2,circular
//     3,4,5,0,1,6,2,circular
//
// One block a row, numbered from 1; the columns after the elements say the same in every row, so rows
// can be sorted and filtered without losing what the design is. A column `strength` follows if it is
// not 2, and a column `elements`, which then always says `labels`, if the elements are named by other
// words than 0 … v−1: its cells are names even where they look like numbers. A name that a spreadsheet
// would compute, such as =1+1, has an apostrophe in front, which a reader takes back
// (io/write/csv_cell.hpp). Rows end in LF.
//
// A reader finds the columns by their names, in any order, and ignores others; every column but the
// elements may be missing, and so may the first row, if all rows hold nothing but elements. The
// separator is a comma or a semicolon, whichever comes first in the first row; fields may be quoted.
// The rest is inferred by the rules in io/design_input.hpp. Rows are blocks in the order in which
// they stand. Writing, reading and writing again gives the same bytes; a recipe is not kept, and the
// order of labels is that of their occurrence.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/design_input.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/sink.hpp"

namespace changeover {

/// @throws BadInput as io/design_input.hpp says; MissingResource if reading fails.
[[nodiscard]] Design read_csv(Input& input, const ReadOptions& options = {});

/// Writes the blocks of a design, elements by label.
void write_csv(const Design& design, Sink& sink);

/// The same for a stream, which is read to its end. Returns the number of blocks.
std::uint64_t write_csv(BlockSource& source, Sink& sink,
                        const std::vector<std::string>& labels = {});

}  // namespace changeover
