// How blocks are laid out in columns, for tables on paper and on a terminal.
//
// In a table of blocks an element keeps its row while it stays, and an introduced element takes the
// row of one that left, so that a reader sees the changes. The marks are those of Transitions.
//
//     for (const AlignedBlock& column : aligned_rows(design)) {
//       column[0].element;  column[0].introduced;  column[0].leaving;
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/output.hpp"

namespace changeover {

struct MarkedElement {
  Element element = 0;
  bool introduced = false;
  bool leaving = false;

  bool operator==(const MarkedElement&) const = default;
};

/// One block, top row first.
using AlignedBlock = std::vector<MarkedElement>;

/// All blocks of a design in rows. The first block keeps its order; those that enter take the rows
/// of those that left, both from the top and in the order in which they are written. O(bk log k).
[[nodiscard]] std::vector<AlignedBlock> aligned_rows(const Design& design);

/// Blocks `first` to `last` of a stream, from 0, as far as it has them; the rows begin at the first
/// of them, the marks are those of the whole. Later blocks are not read (but Transitions read a
/// circular stream to its end once).
/// @throws ImpossibleParameters if v exceeds max_elements_in_memory; as Transitions.
[[nodiscard]] std::vector<AlignedBlock> aligned_rows(
    BlockSource& source, std::uint64_t first,
    std::uint64_t last = std::numeric_limits<std::uint64_t>::max());

/// The names of the blocks of a table.
struct BlockNames {
  std::uint64_t first = 1;  ///< number of the first block
  std::optional<std::uint64_t> base_blocks =
      {};  ///< c: name block i as (i mod c, i div c), both from 0

  bool operator==(const BlockNames&) const = default;
};

/// The columns that display `text` on a terminal: UTF-8 decoded, marks above letters 0, East Asian
/// wide characters 2; a byte that is not UTF-8 counts 1.
[[nodiscard]] std::size_t display_width(std::string_view text);

// A design as a table on a terminal.
//
//     B1  B2  B3
//     0   4*  4
//     1   5*  5
//     2*  2   0*
//     3*  3   1*
//       ^   ^   ^
//
// Blocks are columns, in bands that fit the width; rows are those of aligned_rows(). `*` follows an
// introduced element, `.` a leaving one (if wanted), and `^` is below the gap after block i for
// each position i of an expansion set.

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

// A design as a LaTeX table in the conventions of [ChafeeStevens2025].
//
//     \begin{table}[ht!]
//     \centering
//     \begin{tabular}{lll}
//     $B_{1}$ & $B_{2}$ & $B_{3}$ \\ %
//     0 & 4$^*$ & 4 \\ %
//     1 & 5$^*$ & 5 \\ %
//     2$^*$ & 2 & 0$^*$ \\ %
//     3$^*$ & 3 & 1$^*$
//     \end{tabular}
//     \caption{A circular DCCD(6,4,3)}
//     \end{table}
//
// (The % are not written: they stand here because no comment of C++ may end in a backslash.) Blocks
// are columns; rows are those of aligned_rows(), so an element keeps its row while it stays. $^*$
// marks an introduced element and $_*$ a leaving one; $_{\land}$ is in the last row between blocks
// i and i+1 for each position i of an expansion set. Long designs go on in bands below each other,
// separated by \hline; what is longer than a page is a longtable (package longtable), otherwise no
// package is needed. Labels such as ∞_s and 0_l become $\infty_{s}$ and $0_{l}$; one with other
// letters than ASCII needs an engine or an encoding that knows them.

struct LatexOptions {
  std::size_t columns = 12;  ///< blocks in a band, at least 1
  bool introduced = true;    ///< mark introduced elements
  bool leaving = false;      ///< mark leaving elements
  std::vector<std::uint64_t> positions =
      {};  ///< of an expansion set: i is after block i, 0 before all
  BlockNames names = {};
  std::optional<std::string> caption = {};  ///< LaTeX; nullopt: the design's name, "": no caption
  std::string label = {};                   ///< for \label, or empty
};

/// Writes the table. @throws as Sink::write().
void write_latex(const Design& design, Sink& sink, const LatexOptions& options = {});

/// `text` with all special characters of LaTeX escaped; one line: what is unprintable becomes \x….
[[nodiscard]] std::string latex_escaped(std::string_view text);

/// An element's name in LaTeX, with marks: "0$^*$", "$\infty_{l*}^{*}$".
[[nodiscard]] std::string latex_element(std::string_view label, bool introduced = false,
                                        bool leaving = false);

}  // namespace changeover
