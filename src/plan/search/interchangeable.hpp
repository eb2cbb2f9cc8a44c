// Parts that nothing in a job tells apart, but weights of pairs and triples.
#pragma once

#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The parts by classes within which any exchange leaves costs, slots, pairs, what is mounted and
/// what is at the start as they are. O(v³/64).
[[nodiscard]] std::vector<std::vector<Element>> interchangeable_parts(const Job& job);

}  // namespace changeover
