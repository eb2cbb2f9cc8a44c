// Writing a judged design in the format that was asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/output.hpp"
#include "request/request.hpp"

namespace changeover::cli {

/// The formats of a design, the default first.
[[nodiscard]] const std::vector<std::string>& design_formats();

/// What a shown design comes with.
struct Exhibit {
  std::string title;  ///< lines above a table, without the last line feed
  TextHeader header;  ///< labels and recipe
  Judgement judgement;
  std::vector<std::uint64_t> positions;      ///< of an expansion set, marked in tables
  std::optional<std::uint64_t> base_blocks;  ///< c, to name the blocks B_{i,j}
  bool leaving = false;                      ///< mark leaving elements too
};

/// Why a design of that size cannot be written in a format: tables and LaTeX hold all blocks in memory,
/// pictures have a limited number of points.
[[nodiscard]] std::optional<std::string> format_defect(const Parameters& p, std::uint64_t b,
                                                       const std::string& format);

/// Writes the design that `source` streams to the output that was asked for, and commits it. One that is
/// too large for the format is written as text if a search found it (OutputRequest::precious).
/// @throws UsageError with the defect of the format otherwise.
void show_design(BlockSource& source, const Exhibit& exhibit, const OutputRequest& output);

/// Whether the chosen output can begin before the verdict is known: see judge() in request.hpp. Text and
/// JSON say on standard output what they are; CSV has no place for that, so only its files can.
[[nodiscard]] bool can_be_judged_while_written(const OutputRequest& output);

/// Writes a design and verifies it on the way; exhibit.judgement is not used. On standard output the
/// first and the last line of the text say so; JSON has the verdict after the blocks anyway.
/// @throws InternalError, and nothing is committed, if the verdict is not what was promised.
void show_design_while_judging(JudgedWhileRead& source, const Exhibit& exhibit,
                               const OutputRequest& output);

}  // namespace changeover::cli
