// Partitions of three groups of 6 or of 10 elements into triples, where there is no ring for lines.
//
// For 10 they are two orthogonal Latin squares [Parker1959]: 10 classes, each pair of two groups
// once. For 6 there are no such squares; 7 classes have each pair once or more, found by annealing.
#pragma once

#include <cstdint>

namespace changeover {

/// How many classes are written for three groups of g; 0 but for g = 6 and 10.
[[nodiscard]] std::uint64_t written_class_count(std::uint64_t g);

/// The element of group i, i < 3, that is with element a of group 0 in class `index`.
[[nodiscard]] std::uint64_t in_written_class(std::uint64_t g, std::uint64_t index, std::uint64_t i,
                                             std::uint64_t a);

}  // namespace changeover
