// Completes a list of set-ups.
#include <algorithm>
#include <limits>

#include "changeover/core/error.hpp"
#include "plan/search/anneal/anneal.hpp"
#include "plan/search/listener.hpp"

namespace changeover {
namespace {

// The set-up closest to `beside` that contains x and y: parts that they must not meet are removed
// and, if there is no room, those with the fewest uncovered pairs, which are assumed to be at the
// end.
std::optional<Block> with_pair(const Sequence& s, std::span<const Element> beside, Element x,
                               Element y) {
  const Job& job = s.job();
  auto setup =
      s.fitting().grown(with_mounted(job, {x, y}), beside, [&](const Block& others, Element z) {
        return std::ranges::none_of(others,
                                    [&](Element other) { return job.never.contains(other, z); });
      });
  return setup && setup->size() <= job.at_once ? setup : std::nullopt;
}

// Inserts the cheapest set-up that covers the pair; returns false, with nothing inserted, if
// stopped.
bool insert_pair(Sequence& s, Element x, Element y, Listener& listener) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::size_t most_covered = 0;
  std::size_t place = 0;
  Block chosen;
  for (std::size_t at = 0; at <= s.size(); ++at) {
    for (const bool before : {true, false}) {
      if ((before && at == 0 && s.size() > 0) || (!before && at == s.size())) {
        continue;
      }
      if (listener.stop_wanted(s.job().room() * s.job().room())) {
        return false;
      }
      const std::span<const Element> beside = !before   ? s.setup(at)
                                              : at == 0 ? std::span<const Element>(s.job().start)
                                                        : s.setup(at - 1);
      const auto setup = with_pair(s, beside, x, y);
      if (!setup) {
        throw InternalError("a needed pair has no set-up");
      }
      const std::int64_t cost = s.cost();
      const std::size_t missing = s.uncovered();
      s.insert(at, *setup);
      const std::int64_t rise = s.cost() - cost;
      const std::size_t covered = missing - s.uncovered();
      if (rise < least || (rise == least && covered > most_covered)) {
        least = rise;
        most_covered = covered;
        place = at;
        chosen = *setup;
      }
      s.forget(s.take_out(at));
    }
  }
  s.insert(place, chosen);
  return true;
}

}  // namespace

bool repair(Sequence& sequence, RunControl& control) {
  Listener listener(control);
  while (sequence.uncovered() > 0) {
    const auto [x, y] = sequence.uncovered_pair(0);
    if (!insert_pair(sequence, x, y, listener)) {
      return false;
    }
  }
  return true;
}

}  // namespace changeover
