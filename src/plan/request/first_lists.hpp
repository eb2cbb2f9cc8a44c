// Reads the set-ups that come first, on one bench or on several.
#pragma once

#include <vector>

#include "plan/request/asked_benches.hpp"

namespace changeover {

/// Reads the set-ups that come first: those without a bench come first on every bench, the others
/// only on theirs, after them. A test of a model may leave values open: each bench sets those that
/// it has. @throws as read_first(), and BadInput for a bench that is not among them
void take_first(Input& input, const OldListOptions& options, Job& job, std::vector<Bench>& benches);

}  // namespace changeover
