// How many benches can work at a time, by what each set-up must have.
#pragma once

#include <cstdint>
#include <string>

#include "plan/search/benches/bench_field.hpp"

namespace changeover {

struct BenchesAtWork {
  std::uint64_t most = 1;
  std::string why;  ///< a phrase; empty if it is all
};

/// (2) of the proof in bench_bounds.hpp, for set-ups of `easiest`: a job whose set-ups are at least
/// those of every bench.
[[nodiscard]] BenchesAtWork most_at_a_time(const BenchField& field, const Job& easiest);

}  // namespace changeover
