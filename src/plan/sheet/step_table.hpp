// The table of the steps of one list, or of the lists of several benches.
#pragma once

#include <string>
#include <vector>

#include "io/table/table.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"
#include "plan/sheet/places.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

struct StepTableOptions {
  bool compact = false;                     ///< as in SheetDocument
  const BenchCalendar* calendar = nullptr;  ///< if set, times are days and hours
};

/// What the sheets refer to must outlive the table. Names of benches are in its first column.
[[nodiscard]] Table step_table(const std::vector<ShownSheet>& sheets, const Money& money,
                               const StepTableOptions& options);

/// Additional style for the steps of a model: on a phone each value follows the name of its
/// parameter. Empty for other jobs.
[[nodiscard]] std::string value_style(const Job& job, bool compact);

}  // namespace changeover
