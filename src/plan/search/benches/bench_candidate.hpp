// Lists for several benches, counted as candidates of a plan.
#pragma once

#include <string>

#include "changeover/plan/benches.hpp"
#include "plan/search/benches/bench_field.hpp"

namespace changeover {

/// The name of the candidate that search_lists() makes.
inline constexpr const char* between_benches = "local search between benches";

/// Of lists of all benches those of the working ones, without the first set-ups.
[[nodiscard]] BenchLists without_first(const BenchField& field, const BenchLists& all);

/// The lists of the working benches, without the first set-ups, as a candidate with these: counted
/// by count_benches(), whose result goes to `kept`. @throws InternalError for lists with faults
[[nodiscard]] BenchCandidate counted(const BenchField& field, const std::string& name,
                                     const std::string& how, const BenchLists& lists,
                                     BenchCount* kept = nullptr);

}  // namespace changeover
