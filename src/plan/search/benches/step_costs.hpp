// The costs of the steps of a list.
#pragma once

#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The cost of each set-up after the one before, the first one after the start of the job: as in
/// run_sheet(), but without counting pairs, of which a thousand parts have half a million.
[[nodiscard]] std::vector<Amount> step_costs(const Job& job, const std::vector<Block>& setups);

}  // namespace changeover
