// Cuts one list into pieces for several benches.
#pragma once

#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/benches/bench_field.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

/// Cuts a list into at most this many pieces, in its order, so that the most expensive piece costs
/// as little as possible, if each starts on a bench with the start of the job. Returns one list per
/// bench; some may be empty.
[[nodiscard]] BenchLists cut_list(const Job& job, const std::vector<Block>& setups,
                                  std::size_t benches);
/// The same for all benches of a field, with only the set-ups that are allowed on each.
[[nodiscard]] BenchLists cut_list(const BenchField& field, const Job& job,
                                  const std::vector<Block>& setups);

}  // namespace changeover
