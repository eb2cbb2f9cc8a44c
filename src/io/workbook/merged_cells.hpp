// Merged cells of a sheet: what stands in the first one stands for all of those below it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/workbook/workbook_sheet.hpp"
#include "io/workbook/zip_archive.hpp"

namespace changeover {

/// The merged ranges of a sheet of the archive, which is unpacked once more for them: in the file
/// they stand below the rows. Messages call the sheet `place`. @throws BadInput if it cannot be
/// read, or for more than 100,000 ranges
[[nodiscard]] std::vector<MergedRange> merged_ranges(const ZipArchive& archive,
                                                     const std::string& member,
                                                     std::uint64_t most_bytes,
                                                     const std::string& place);

/// Fills in merged cells row by row.
class MergedCells {
 public:
  MergedCells(std::vector<MergedRange> ranges, std::string place);

  /// Gives the cells of the next row, which has some, what stands in the first cell of their range,
  /// and the row its ranges of several columns. Returns the bytes that were added.
  /// O(cells + ranges here) @throws BadInput for a cell that says something else below a range
  std::uint64_t fill(SheetRow& row);

 private:
  struct Open {
    MergedRange range;
    std::string text;  // of its first cell
  };

  std::vector<MergedRange> ranges_;  // by first row
  std::size_t next_ = 0;
  std::map<std::uint64_t, Open> open_;  // by first column
  std::string place_;
};

}  // namespace changeover
