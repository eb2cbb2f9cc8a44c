// The counting bound as verification knows it: constructions have another count for their promises.
#pragma once

#include <cstdint>

#include "changeover/core/parameters.hpp"
#include "core/checked.hpp"

namespace changeover {

/// What an economical design has [ChafeeStevens2025, Theorem 1]. @throws ImpossibleParameters if a
/// count exceeds 64 bits.
[[nodiscard]] inline std::uint64_t economical_blocks(const Parameters& p) {
  const std::uint64_t all = binomial(p.v, p.strength);
  const std::uint64_t most = newly_covered_at_most(p);
  if (p.v == p.k) {
    return 1;
  }
  return p.kind == Kind::circular ? ceil_div(all, most)
                                  : ceil_div(all - binomial(p.k, p.strength), most) + 1;
}

}  // namespace changeover
