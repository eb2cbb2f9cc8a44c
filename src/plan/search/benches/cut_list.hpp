// One list cut for several benches.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

/// A list in at most so many pieces, in its order, so that the dearest costs as little as can be,
/// if each begins on a bench with what the job has at its start. There are as many lists as
/// benches; some may be empty.
[[nodiscard]] BenchLists cut_list(const Job& job, const std::vector<Block>& setups,
                                  std::size_t benches);

}  // namespace changeover
