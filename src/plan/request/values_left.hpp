// A job of a model without the values that broke.
#pragma once

#include "changeover/plan/job.hpp"
#include "plan/request/parts_left.hpp"

namespace changeover {

/// The job of a model with the values that remain: the same parameters and rules, the same names
/// and costs. @throws BadInput if a parameter has no value left. O(values²)
[[nodiscard]] Job values_left(const Job& all, const PartsLeft& left);

}  // namespace changeover
