// Places of a planned test that cannot be empty, by the question of its workbook.
#pragma once

#include <string>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/job.hpp"

namespace changeover {

/// Refuses a run sheet on which a test with a number and a result has an empty cell, though every
/// set-up of `job` has more there: a value of each parameter, the least of a slot, what stays
/// mounted. A test without a number is of the user's own, and may lack it. `sheet` names the list
/// in the message. O(rows · (parts of a set-up + slots)) @throws BadInput with the row
void refuse_emptied_places(const std::string& sheet, const DoneList& list, const Job& job,
                           const std::vector<Bench>& benches);

}  // namespace changeover
