#include "search/local/local_search_states.hpp"

#include <cstdint>
#include <limits>

#include "changeover/core/error.hpp"
#include "search/local/segment_pairs.hpp"
#include "search/local/segment_subsets.hpp"

namespace changeover {
namespace {

using Bytes = SegmentPairs<std::uint8_t>;
using Words = SegmentPairs<std::uint16_t>;

template <typename State>
Annealed run(State state, const AnnealSchedule& schedule, Random& random, RunControl& control,
             const AnnealWatch& watch) {
  Annealed annealed;
  annealed.outcome = anneal(state, schedule, random, control, watch);
  if (annealed.outcome.missing == 0) {
    annealed.design = state.design();
  }
  return annealed;
}

}  // namespace

std::uint64_t annealing_bytes(const Parameters& p, std::uint64_t blocks) {
  constexpr std::uint64_t too_many = std::numeric_limits<std::uint64_t>::max();
  constexpr std::uint64_t most_blocks = std::numeric_limits<std::uint32_t>::max();
  constexpr std::uint64_t most_occurrences = std::numeric_limits<std::uint8_t>::max() / 2;
  if (p.v > max_elements_in_memory || blocks > most_blocks) {
    return too_many;
  }
  if (p.strength == 2) {
    // Some element may be in more blocks than the average.
    return blocks * p.k / p.v < most_occurrences ? Bytes::bytes(p.v, p.k, blocks)
                                                 : Words::bytes(p.v, p.k, blocks);
  }
  try {
    return SegmentSubsets::bytes(p, blocks);
  } catch (const ImpossibleParameters&) {
    return too_many;
  }
}

Annealed anneal_blocks(const Design& start, std::size_t frozen, const AnnealSchedule& schedule,
                       Random& random, RunControl& control, const AnnealWatch& watch,
                       std::span<const LockedCell> locked) {
  control.require_memory(annealing_bytes(start.parameters(), start.block_count()),
                         "local search for the " + name(start.parameters()));
  if (start.parameters().strength != 2) {
    return run(SegmentSubsets(start, frozen), schedule, random, control, watch);
  }
  if (Bytes::fits(start)) {
    return run(Bytes(start, frozen, locked), schedule, random, control, watch);
  }
  if (Words::fits(start)) {
    return run(Words(start, frozen, locked), schedule, random, control, watch);
  }
  throw MissingResource("local search supports elements in at most 65535 blocks each");
}

}  // namespace changeover
