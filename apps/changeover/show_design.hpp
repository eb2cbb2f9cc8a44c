// Writing a judged design in the format that was asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/io/output_file.hpp"
#include "changeover/io/text.hpp"
#include "request.hpp"

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

/// Writes the design that `source` streams to the output that was asked for, and commits it.
void show_design(BlockSource& source, const Exhibit& exhibit, const OutputRequest& output);

}  // namespace changeover::cli
