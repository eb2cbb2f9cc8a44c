// The figures of the paper, drawn anew from its data as SVG and TikZ.
//
//     for (const PaperFigure& figure : paper_figures()) {
//       write(directory / figure.file, figure.content);       // figure-1.svg, figure-1.tex, …
//     }
//
// Figures 1 and 2 are the 1-factorizations of K_6 and K_8, Figures 3, 4a and 4b two consecutive
// blocks of Tables 8 and 11 [ChafeeStevens2025]. Colours are ours.
#pragma once

#include <string>
#include <vector>

#include "paper/print/printed.hpp"

namespace changeover {

struct PaperFigure {
  std::string file;
  std::string content;

  bool operator==(const PaperFigure&) const = default;
};

/// All of them, in the order of the paper, SVG before TikZ.
/// @throws BadInput if a figure does not fit its table.
[[nodiscard]] std::vector<PaperFigure> paper_figures(const Paper& paper = printed_paper());

}  // namespace changeover
