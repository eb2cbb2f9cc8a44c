// Pieces of a part, named so that people see what there is: of two pieces, the first two.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The same plan with the first pieces of each part in every set-up, as many as were in it; a piece
/// that stays is then one of them. The plan itself where that would cost more or test less, which
/// may be if others are mounted at the start. O(size of the plan).
[[nodiscard]] RunPlan with_first_pieces(const Job& job, RunPlan plan);

}  // namespace changeover
