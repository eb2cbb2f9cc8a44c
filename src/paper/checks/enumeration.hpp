// Small change covering designs by exhaustion, to settle what the paper says of particular small
// parameters: that a design is unique, that one exists or not.
//
//     Enumeration none = enumerate({.v = 7, .k = 4, .kind = Kind::linear}, 4);
//     none.found == 0 && none.complete;         // there is no linear DCCD(7,4,4)
//
// Depth first over blocks as bit sets, with the counting bound at each step: after each block the
// pairs that are left must not exceed what the blocks that are left can newly cover. The first
// block is {0,…,k−1} and elements that were never in a block enter in increasing order, so a design
// is found at least once up to relabelling. Meant for v ≤ 16 and a handful of blocks; for anything
// larger use a search made for it.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

struct EnumerationOptions {
  std::uint64_t keep = 1;            ///< stop after so many designs
  std::uint64_t nodes = 20'000'000;  ///< give up after so many blocks were tried
};

struct Enumeration {
  std::uint64_t found = 0;      ///< designs, not up to relabelling
  std::vector<Design> designs;  ///< those found
  bool complete = false;        ///< everything was tried: `found` of zero proves that there is none
};

/// Change covering designs with b blocks, strength 2. @throws ImpossibleParameters as check(),
/// BadInput if v > 16 or b is 0.
[[nodiscard]] Enumeration enumerate(const Parameters& parameters, std::uint64_t b,
                                    const EnumerationOptions& options = {});

/// Whether one design becomes the other, block by block and in order, under a relabelling of its
/// elements. Tries all v! of them: v ≤ 8.
[[nodiscard]] bool same_up_to_relabelling(const Design& a, const Design& b);

}  // namespace changeover
