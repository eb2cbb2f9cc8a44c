#include "search/local_search_states.hpp"

#include <cstdint>

#include "changeover/core/error.hpp"
#include "changeover/search/segment_pairs.hpp"
#include "changeover/search/segment_subsets.hpp"

namespace changeover {
namespace {

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

Annealed anneal_blocks(const Design& start, std::size_t frozen, const AnnealSchedule& schedule,
                       Random& random, RunControl& control, const AnnealWatch& watch) {
  using Bytes = SegmentPairs<std::uint8_t>;
  using Words = SegmentPairs<std::uint16_t>;
  if (start.parameters().strength != 2) {
    return run(SegmentSubsets(start, frozen), schedule, random, control, watch);
  }
  if (Bytes::fits(start)) {
    return run(Bytes(start, frozen), schedule, random, control, watch);
  }
  if (Words::fits(start)) {
    return run(Words(start, frozen), schedule, random, control, watch);
  }
  throw MissingResource("local search supports elements in at most 65535 blocks each");
}

}  // namespace changeover
