// Anneals a list of blocks with counters of the right type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "changeover/core/design.hpp"
#include "search/local/anneal.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

struct Annealed {
  std::optional<Design> design;  ///< if nothing is missing; not verified
  AnnealOutcome outcome;
};

/// The memory for annealing so many blocks, at most; the largest number if that exceeds 64 bits.
[[nodiscard]] std::uint64_t annealing_bytes(const Parameters& p, std::uint64_t blocks);

/// Anneals all blocks but the first `frozen`; elements in locked cells stay there (strength 2).
/// While it starts, the scope of this thread can stop it. @throws MissingResource if the counters
/// would need more memory than `control` allows.
[[nodiscard]] Annealed anneal_blocks(const Design& start, std::size_t frozen,
                                     const AnnealSchedule& schedule, Random& random,
                                     RunControl& control, const AnnealWatch& watch = {},
                                     std::span<const LockedCell> locked = {});

}  // namespace changeover
