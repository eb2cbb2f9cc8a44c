// What some bench must mount, since parts that must meet have a bench in common: docs/theorems.md,
// Theorem 26.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/search/bounds/job_numbers.hpp"

namespace changeover {

/// Parts that benches share, by number.
struct SharedParts {
  std::vector<Amount> costs = {};            ///< of putting a part in once, at least
  std::vector<std::vector<bool>> meet = {};  ///< by two parts: whether they must
  /// Parts by number, and how many of them a test has at most.
  std::vector<std::pair<std::vector<bool>, std::uint64_t>> limits = {};
  Amount test = {};
};

/// The parts of a job that do not stay mounted and must meet some other; `is_there` says which are
/// on some bench at the start, where they cost nothing.
[[nodiscard]] SharedParts shared_parts(const Job& job, const JobNumbers& n,
                                       const std::function<bool(Element)>& is_there);

/// Each part is given to some benches, such that two parts that must meet are given to the same one
/// at least once. A bench puts in each of its parts once, and has as many tests as the limits need.
/// Returns the least cost of the most expensive bench; nullopt if that is no more than `known`, or
/// if
/// it was not found within a fixed number of steps. Exponential in the parts; at most 6 benches.
/// Stopped if the scope of this thread (run/control.hpp) requests it.
[[nodiscard]] std::optional<Amount> cost_of_fullest(const SharedParts& shared, std::size_t benches,
                                                    Amount known);

}  // namespace changeover
