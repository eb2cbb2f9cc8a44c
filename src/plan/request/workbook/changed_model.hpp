// The question of a workbook, asked again with another model.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/job_request.hpp"

namespace changeover {

/// Reads the model of the request, whose text it keeps, and fits the lists of the question to it;
/// of the costs of the request those that came from the workbook `book`, if it has any. What names
/// values or parameters that the model has no more is left out with a note; all else gets its full
/// name, "OS: Debian", which means the same in both models. O(the lists and models)
/// @throws BadInput for a wrong model, and if all pairs that were to be tested are gone
void take_other_model(JobRequest& request, JobRequest& question, const std::string& book,
                      bool has_costs_of_book, std::vector<std::string>& notes);

}  // namespace changeover
