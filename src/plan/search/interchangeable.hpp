// Finds parts that are interchangeable, except for weights of pairs and triples.
#pragma once

#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The parts in classes: any exchange within a class keeps costs, slots, pairs, mounted parts and
/// the start. O(v³/64).
[[nodiscard]] std::vector<std::vector<Element>> interchangeable_parts(const Job& job);

}  // namespace changeover
