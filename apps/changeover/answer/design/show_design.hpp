// Writing a judged design in the format that was asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer/answer.hpp"
#include "answer/design/judgement.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/output.hpp"

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

/// Why a design of that size cannot be written in a format: tables and LaTeX hold all blocks in
/// memory, pictures have a limited number of points.
[[nodiscard]] std::optional<std::string> format_defect(const Parameters& p, std::uint64_t b,
                                                       const std::string& format);

/// Writes a design in one of the formats but "table", which is for a terminal. What is too large
/// for the format is for the caller to refuse (format_defect()). @throws as Sink::write() and
/// read_all().
void write_design(BlockSource& source, const Exhibit& exhibit, const std::string& format,
                  Sink& out);

/// The formats in which elements are marked, for --leaving.
[[nodiscard]] const std::vector<std::string>& formats_of_marks();

/// The design that `source` streams, in the format that was asked for. One that is too large for
/// the format is written as text if a search found it (OutputRequest::precious); if FILE's name
/// says otherwise, to FILE.txt, and the fault of the answer says so.
/// @throws UsageError with the defect of the format otherwise.
[[nodiscard]] Answer show_design(std::shared_ptr<BlockSource> source, Exhibit exhibit,
                                 const OutputRequest& output, int code = exit_code::done);
/// The same for one in memory.
[[nodiscard]] Answer show_design(const Design& design, Exhibit exhibit, const OutputRequest& output,
                                 int code = exit_code::done);

/// Whether the chosen output can begin before the verdict is known: see judge() in judgement.hpp.
/// Text and JSON say on standard output what they are; CSV has no place for that, so only its files
/// can.
[[nodiscard]] bool can_be_judged_while_written(const OutputRequest& output);

/// A design that is verified while it is written; exhibit.judgement is not used. On standard output
/// the first and the last line of the text say so; JSON has the verdict after the blocks anyway.
/// The writer
/// @throws InternalError, and nothing is committed, if the verdict is not what was promised.
[[nodiscard]] Answer show_design_while_judging(std::shared_ptr<BlockSource> source,
                                               const Offer& promise, const Exhibit& exhibit,
                                               const OutputRequest& output);

}  // namespace changeover::cli
