// The table of the steps of one list, or of the lists of several benches.
#pragma once

#include <string>
#include <vector>

#include "io/table/table.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

struct StepTableOptions {
  bool compact = false;                   ///< as in SheetDocument
  std::vector<std::string> benches = {};  ///< by sheet: the bench of each step, in the first column
  std::vector<const Job*> jobs = {};  ///< by sheet: the job as shown on it; empty: the common one
  std::vector<const std::vector<StepTime>*> times =
      {};                                   ///< by sheet: times of steps; empty: sums of costs
  const BenchCalendar* calendar = nullptr;  ///< if set, times are days and hours
};

/// The jobs, the sheets, the times and the calendar must outlive the table.
[[nodiscard]] Table step_table(const Job& job, const std::vector<const RunSheet*>& sheets,
                               const Money& money, const StepTableOptions& options);

/// Additional style for the steps of a model: on a phone each value follows the name of its
/// parameter. Empty for other jobs.
[[nodiscard]] std::string value_style(const Job& job, bool compact);

}  // namespace changeover
