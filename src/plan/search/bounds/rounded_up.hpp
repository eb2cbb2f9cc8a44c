// What several bounds need.
#pragma once

#include "changeover/plan/job.hpp"

namespace changeover {

/// The cost rounded up to a multiple of what divides all costs: every list costs one.
[[nodiscard]] Amount rounded_up(const Job& job, Amount cost);

}  // namespace changeover
