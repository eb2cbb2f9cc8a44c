// What is known as people read it: a table with a row for each v, bounds with their reasons; for
// papers in LaTeX, with what the signs mean and whom to cite.
#pragma once

#include <cstdint>
#include <string>

#include "construct/known_documents.hpp"
#include "io/table/table.hpp"

namespace changeover {

/// How LaTeX names the publications of docs/references.bib.
enum class Citations : std::uint8_t {
  cited,   ///< \cite[Theorem 2]{ChafeeStevens2025}, for a document with a bibliography
  written  ///< [ChafeeStevens2025, Theorem 2], for a page without one
};

/// "circular double-change covering designs: blocks of the best known (= minimum, - none exists)".
[[nodiscard]] std::string known_grid_title(const Cells& cells);

/// A row for each v, a column for each k of cells of one kind, by k, then v, none left out; there
/// is one at least. In LaTeX a letter at each number says which construction made it.
[[nodiscard]] Table known_grid(const Cells& cells);

/// The same with what its signs and letters mean below it. Needs booktabs and longtable.
[[nodiscard]] std::string known_grid_latex(const Cells& cells,
                                           Citations citations = Citations::cited);

/// A list with a line for each bound.
[[nodiscard]] std::string bounds_latex(const KnownBounds& known,
                                       Citations citations = Citations::cited);

}  // namespace changeover
