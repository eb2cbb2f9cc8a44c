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
// Blocks are columns; rows are those of aligned_rows(), so an element keeps its row while it stays.
// $^*$ marks an introduced element and $_*$ a leaving one; $_{\land}$ stands in the last row between
// blocks i and i+1 for each position i of an expansion set. Long designs go on in bands below each
// other, separated by \hline. Labels such as ∞_s and 0_l become $\infty_{s}$ and $0_{l}$. No package is
// needed; a label with other letters than ASCII needs an engine or an encoding that knows them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/io/marks.hpp"
#include "changeover/io/sink.hpp"

namespace changeover {

struct LatexOptions {
  std::size_t columns = 12;  ///< blocks in a band, at least 1
  bool introduced = true;    ///< mark introduced elements
  bool leaving = false;      ///< mark leaving elements
  std::vector<std::uint64_t> positions =
      {};  ///< of an expansion set: i is after block i, 0 before all
  BlockNames names = {};
  std::optional<std::string> caption = {};  ///< LaTeX; nothing: the design's name, "": no caption
  std::string label = {};                   ///< for \label, or empty
};

/// Writes the table. @throws as Sink::write().
void write_latex(const Design& design, Sink& sink, const LatexOptions& options = {});

/// `text` with everything escaped that means something to LaTeX; one line (core/printable.hpp).
[[nodiscard]] std::string latex_escaped(std::string_view text);

/// An element's name in LaTeX, with marks: "0$^*$", "$\infty_{l*}^{*}$".
[[nodiscard]] std::string latex_element(std::string_view label, bool introduced = false,
                                        bool leaving = false);

}  // namespace changeover
