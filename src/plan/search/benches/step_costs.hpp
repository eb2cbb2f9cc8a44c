// What the steps of a list cost.
#pragma once

#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// What each set-up costs after the one before, the first after the start of the job: as
/// run_sheet() counts it, but without a look at the pairs, of which a thousand parts have half a
/// million.
[[nodiscard]] std::vector<Amount> step_costs(const Job& job, const std::vector<Block>& setups);

}  // namespace changeover
