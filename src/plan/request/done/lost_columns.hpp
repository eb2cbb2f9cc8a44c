// What a list of tests that were done may have lost in a spreadsheet: the column of a slot, or of
// what stays mounted, or a cell of it.
#pragma once

#include <string>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Adds notes to the list: every set-up has a part in each slot that needs one, and what stays
/// mounted, unless that is new. `name` is that of the list. O(places · rows). @throws BadInput
/// where the number of a column says that it is gone
void note_lost_columns(DoneList& list, const Job& job, bool has_benches, const std::string& name);

}  // namespace changeover
