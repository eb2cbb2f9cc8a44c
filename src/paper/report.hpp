// The source paper, rebuilt: every table, figure, theorem and corollary of [ChafeeStevens2025]
// compared with what this library builds and proves.
//
//     PaperReport report = run_paper_report(Registry::standard());
//     report.count(PaperStatus::differs);       // in how many places the print is not right
//     std::cout << render_text(report);         // one line an item, details beneath
//
// An item is one claim at one place, with what was found of it:
//   reproduced    rebuilt, or recomputed, and equal in every cell that was compared
//   differs       the print says one thing and the computation another; each finding says both,
//                 and why
//   refuted       a mathematical statement that is false: each finding is a counterexample, built
//                 and verified, or a bound that excludes what is said to exist
//   vacuous       true, but of nothing: there is no design of which it says something
//   not checkable no statement that a program could decide, or one for which the paper names too
//                 little; the reason is given
// Nothing is hard-coded: a misprint is found because a comparison fails, and every comparison can
// fail (the print is an argument). "For all k" is checked for every k up to a limit, not proved.
//
// Deterministic: the same text every time, no times and no machine in it. A few seconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "paper/print/printed.hpp"

namespace changeover {

enum class PaperStatus : std::uint8_t { reproduced, differs, refuted, vacuous, not_checkable };

/// "reproduced", "differs", "refuted", "vacuous", "not checkable".
[[nodiscard]] std::string_view to_string(PaperStatus status);

/// Where print and computation part.
struct PaperFinding {
  std::string printed;
  std::string truth;
  std::string why;

  bool operator==(const PaperFinding&) const = default;
};

struct PaperItem {
  std::string place;  ///< "Table 11", "Corollary 15"
  std::string what;   ///< one line: the claim, or what was compared
  PaperStatus status = PaperStatus::reproduced;
  std::uint64_t checked = 0;           ///< how many comparisons were made
  std::string unit;                    ///< of what: "blocks", "cells", "designs"
  std::vector<PaperFinding> findings;  ///< of an item that differs or is refuted
  std::vector<std::string> notes;      ///< remarks, and reasons why an item is not checkable
  /// the place of the item with the same cause, which says it; empty for an item without such a
  /// cause
  std::string follows = {};
  bool comes_first = false;  ///< what a reader should know before the rest

  bool operator==(const PaperItem&) const = default;
};

struct PaperReport {
  std::vector<PaperItem> items;  ///< in the order of the paper

  /// Items of that status, without those that follow from another one.
  [[nodiscard]] std::size_t count(PaperStatus status) const;

  /// Items that follow from another one.
  [[nodiscard]] std::size_t consequences() const;
};

struct PaperReportOptions {
  std::uint64_t largest_k = 40;  ///< theorems "for all k" are checked up to this block size
};

/// Checks the print against the constructions of a registry.
/// @param paper what is printed; tests pass falsified copies.
/// @throws BadInput if the print cannot be read; a table whose columns are no blocks differs, but
/// it throws if other items depend on it.
[[nodiscard]] PaperReport run_paper_report(const Registry& registry,
                                           const PaperReportOptions& options = {},
                                           const Paper& paper = printed_paper());

/// For a terminal: a line for each item, findings and notes beneath, counts at the end.
[[nodiscard]] std::string render_text(const PaperReport& report);

/// The same as a Markdown page.
[[nodiscard]] std::string render_markdown(const PaperReport& report);

/// {"format":"changeover-paper/3","reproduced":n,"differs":n,"refuted":n,"vacuous":n,
/// "not_checkable":n,"consequences":n,"items":[{"place","what","status","checked","unit","follows",
/// "findings":[{"printed","truth","why"}],"notes":[…]}]}. One line. "follows" is a place or null.
[[nodiscard]] std::string render_json(const PaperReport& report);

// The figures of the paper, redrawn from its data as SVG and TikZ.
//
//     for (const PaperFigure& figure : paper_figures()) {
//       write(directory / figure.file, figure.content);       // figure-1.svg, figure-1.tex, …
//     }
//
// Figures 1 and 2 are the 1-factorizations of K_6 and K_8, Figures 3, 4a and 4b two consecutive
// blocks of Tables 8 and 11 [ChafeeStevens2025]. Colours are ours.

struct PaperFigure {
  std::string file;
  std::string content;

  bool operator==(const PaperFigure&) const = default;
};

/// All of them, in the order of the paper, SVG before TikZ.
/// @throws BadInput if a figure does not fit its table.
[[nodiscard]] std::vector<PaperFigure> paper_figures(const Paper& paper = printed_paper());

}  // namespace changeover
