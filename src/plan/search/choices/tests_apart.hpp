// Lower bounds on the tests of a model from tuples that do not fit into one test.
#pragma once

#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// Needed pairs, or triples, of which no two fit into one test, so their number is a lower bound on
/// the tests. Two tuples exclude each other if they have different values of a parameter, values
/// that a rule excludes, or a value out of range in only one of them. The tuples are a clique in
/// the graph of such exclusions, found by local search. Each tuple is a block. Deterministic;
/// O(tuples · moves), with fewer moves for more tuples; empty for more than 200'000.
[[nodiscard]] std::vector<Block> tuples_for_tests_apart(const Job& job);

}  // namespace changeover
