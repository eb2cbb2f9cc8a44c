// A design as a table on a terminal.
//
//     B1  B2  B3
//     0   4*  4
//     1   5*  5
//     2*  2   0*
//     3*  3   1*
//       ^   ^   ^
//
// Blocks are columns, in bands that fit the width; rows as aligned_rows() lays them. `*` follows an
// element that is introduced, `.` one that leaves (if asked for), and `^` stands beneath the gap after
// block i for each position i of an expansion set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/io/marks.hpp"
#include "changeover/io/sink.hpp"

namespace changeover {

struct TableOptions {
  std::size_t width = 80;  ///< columns of the terminal; a band has at least one block
  bool introduced = true;  ///< mark introduced elements with `*`
  bool leaving = false;    ///< mark leaving elements with `.`
  bool colour = false;     ///< ANSI colours: introduced green, leaving red, kept dim
  std::vector<std::uint64_t> positions =
      {};  ///< of an expansion set: i is after block i, 0 before all
  BlockNames names = {};
};

/// Writes the table, each line ended by LF. @throws as Sink::write().
void write_table(const Design& design, Sink& sink, const TableOptions& options = {});

}  // namespace changeover
