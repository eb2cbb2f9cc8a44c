// What a bench makes of a job.
#pragma once

#include <cstddef>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover {

/// The job on this bench alone: its costs, room, slots, what is mounted and comes first. Parts that
/// it cannot have are in a slot of their own that holds none. What must meet is what can meet
/// there; what is mounted at the start, only parts that it can have.
/// @throws BadInput (without the name of the bench) for a change factor by which costs have more
/// than six decimals and for limits of slots that the job does not have.
[[nodiscard]] Job job_of_bench(const Job& job, const Bench& bench);

/// The same without slots that are empty there, as check(Job) wants it.
[[nodiscard]] Job job_by_itself(const Job& job, const Bench& bench);

/// So many benches that are alike.
[[nodiscard]] std::vector<Bench> benches_alike(std::uint64_t number);

/// By part: whether the bench cannot have it: it says so, or there is none and it has none of its
/// own.
[[nodiscard]] std::vector<bool> barred_parts(const Job& job, const Bench& bench);

}  // namespace changeover
