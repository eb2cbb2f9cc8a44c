// The question of a workbook, asked again with another model.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/job_request.hpp"

namespace changeover {

/// Leaves out of the lists of a question whose job was `before` what names values or parameters
/// that the model has no more; returns their names. All others get their full names, "OS: Debian",
/// which mean the same in both models. O(the lists)
[[nodiscard]] std::vector<std::string> fit_to_model(JobRequest& question, const Job& before,
                                                    const Model& model);

}  // namespace changeover
