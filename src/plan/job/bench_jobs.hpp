// Derives the job of a bench.
#pragma once

#include <cstddef>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover {

/// The job on this bench alone: its costs, room, slots, mounted parts and first set-ups. Parts that
/// it cannot have are in a separate slot with room for none. The needed pairs are those that
/// can meet on it, and the start has only parts that it can have. @throws BadInput (without the
/// name of the bench) for a change factor by which costs have more than six decimals, and for
/// limits of slots that the job does not have.
[[nodiscard]] Job job_of_bench(const Job& job, const Bench& bench);

/// The same of a job without triples, of which this is known: the pairs that can meet on the bench,
/// and perhaps others that are not needed. What can meet takes long to find where rules say it.
[[nodiscard]] Job job_of_bench(const Job& job, const Bench& bench, const PairSet& can_meet);

/// The same without slots that are empty on this bench, as check(Job) requires.
[[nodiscard]] Job job_by_itself(const Job& job, const Bench& bench);

/// `number` equal benches.
[[nodiscard]] std::vector<Bench> benches_alike(std::uint64_t number);

/// By part: whether the bench cannot have it, because it says so, or because there are no pieces
/// and it does not have its own piece.
[[nodiscard]] std::vector<bool> barred_parts(const Job& job, const Bench& bench);

/// The benches that work, at most so many, those that can have the most parts first.
[[nodiscard]] std::vector<std::size_t> benches_with_most_parts(const Job& job,
                                                               const std::vector<Bench>& benches,
                                                               std::size_t most);

}  // namespace changeover
