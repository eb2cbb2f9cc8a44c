// The table of the steps of one list, or of the lists of several benches.
#pragma once

#include <string>
#include <vector>

#include "io/table/table.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {

struct StepTableOptions {
  bool compact = false;  ///< as in SheetDocument
  bool benches = false;  ///< the bench of each step stands first
};

/// The job and the sheets must outlive the table.
[[nodiscard]] Table step_table(const Job& job, const std::vector<const RunSheet*>& sheets,
                               const Money& money, const StepTableOptions& options);

/// What a page needs besides page_style for the steps of a model: on a phone each value stands
/// behind the name of its parameter. Empty for other jobs.
[[nodiscard]] std::string value_style(const Job& job, bool compact);

}  // namespace changeover
