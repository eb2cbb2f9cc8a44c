// Names pieces of a part naturally: two pieces are the first two.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The same plan with the first pieces of each part in every set-up, as many as were in it; a piece
/// that stays is one of them. Returns the plan unchanged if that would cost more or test less,
/// which is possible if other pieces are mounted at the start. O(size of the plan).
[[nodiscard]] RunPlan with_first_pieces(const Job& job, RunPlan plan);

}  // namespace changeover
