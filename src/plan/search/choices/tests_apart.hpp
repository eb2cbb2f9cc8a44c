// Lower bounds on tests of a model from what cannot be in one test.
#pragma once

#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Needed pairs, or triples, of which no two are tested by one test, so that there are at least as
/// many tests: two tuples have different values of a parameter, or values that a rule keeps apart,
/// or values that are out of range in one of them only. As many as a local search finds in the
/// graph of such tuples, in which they are a clique. Each tuple is a block. Deterministic;
/// O(tuples · moves), with fewer moves for more tuples; nothing for more than 200'000.
[[nodiscard]] std::vector<Block> tuples_for_tests_apart(const Job& job);

}  // namespace changeover
