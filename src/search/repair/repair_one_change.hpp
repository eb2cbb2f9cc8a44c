// Repairs of one change: most lists that people give have one slip.
#pragma once

#include <optional>

#include "changeover/core/design.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// A design that differs from the list, of which this is the verdict, by two blocks exchanged, one
/// block elsewhere, another block in the place of one (with as many of its elements as can stay),
/// or one block less. This is the order of preference. Returns nullopt if there is none, or if the
/// list is so long that looking takes longer than annealing. Needs two blocks or more. The scope of
/// this thread (run/control.hpp) can stop it. O(b² k) for another order, O(b (v + C(k,t)) + C(v,t))
/// for another block, and a verification for each list whose steps are right.
[[nodiscard]] std::optional<Design> repaired_by_one_change(const Design& list,
                                                           const Verdict& verdict);

}  // namespace changeover
