// The numbers of the steps of a sheet, and the order of its tests by them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/setups/setup_columns.hpp"

namespace changeover {

/// The highest number of a step: spreadsheets keep whole numbers up to it, and sheets can go on
/// from it.
inline constexpr std::uint64_t most_steps = 1'000'000'000'000'000;

/// Puts tests of several sheets, which have rows from each of these on, in the order of their
/// steps, bench by bench, and returns whether that moved some with results. The order stays for a
/// bench with a sheet that has no number in its first row, or one twice. O(rows · log rows)
bool put_sheets_in_order(std::vector<DoneRow>& rows, const std::vector<std::size_t>& begins);

class StepNumbers {
 public:
  /// The number in the next row of a list, by what its cell says; nothing if it is empty or no
  /// whole number. @throws BadInput with the cell for a negative number and one above most_steps
  std::optional<std::uint64_t> take(const Row& row, const SetupColumns& columns,
                                    const std::string& text, const RowReader& reader);

  /// Tests in the order of their steps, whatever the order of the rows: spreadsheets sort them. A
  /// row without a number belongs to the one above it. Rows of a bench keep the places of its rows.
  /// Notes say what was moved, and which numbers say no order.
  void put_in_order(DoneList& list, const Row& header, const SetupColumns& columns,
                    const RowReader& reader) const;

 private:
  enum class Moved { no, yes, cannot };
  Moved put_in_order(DoneList& list, const std::vector<std::size_t>& at,
                     std::size_t& repeated) const;

  std::vector<std::size_t> offsets_;   // by row: that of its cell
  std::optional<std::string> unread_;  // the first cell that is no number, with its place
  std::uint64_t others_ = 0;           // further ones
};

}  // namespace changeover
