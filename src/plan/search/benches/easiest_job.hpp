// The job that is at least as easy as that of any bench.
#pragma once

#include "plan/search/benches/bench_field.hpp"

namespace changeover {

/// The least costs of all benches, the largest room and the widest slots, and what stays mounted on
/// all; with an empty start. @pre there is a working bench
[[nodiscard]] Job easiest_job(const BenchField& field);

}  // namespace changeover
