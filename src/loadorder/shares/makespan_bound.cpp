// A lower bound on the loads of the busiest worker.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bounds/stays.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/pairs/pair_bounds.hpp"
#include "loadorder/shares/few_workers.hpp"

namespace changeover {
namespace {

// By counting `pairs` among all loaded items, where one worker alone needs `least_items` loads.
LoadBound bound_by_pairs(std::uint64_t pairs, bool between, std::uint64_t least_items,
                         std::uint64_t alone, std::uint64_t room, std::uint64_t workers) {
  const std::uint64_t needed = ceil_div(pairs, workers);
  const std::uint64_t least = between ? least_between(needed, room) : least_loads(needed, room);
  const std::uint64_t by_items = ceil_div(least_items, workers);
  const std::uint64_t low = std::min(alone, std::max(by_items, least));
  if (low > 0 && low == least) {
    const std::uint64_t fewer = low - 1;
    return {low, fmt::format("one of {} workers brings at least {} of {} together, and with "
                             "{} it brings at most {}",
                             workers, needed, count_of(pairs, "pair"), count_of(fewer, "load"),
                             between ? most_between(fewer, room) : most_pairs(fewer, room))};
  }
  return {low, low == by_items
                   ? fmt::format("{} workers load {} together: one of them at least {}", workers,
                                 count_of(least_items, "item"), low)
                   : fmt::format("one worker alone has at least {}", count_of(low, "load"))};
}

// All pairs of items: what several workers load is end to end a list in which they meet.
LoadBound bound_of_all(LoadBound by_pairs, std::uint64_t items, std::uint64_t room,
                       std::uint64_t workers) {
  LoadBound best = least_at_one_worker(items, workers);
  if (by_pairs.loads >= best.loads) {
    best = std::move(by_pairs);
  }
  const Introductions all = least_introductions(items, std::min(items, room));
  if (const std::uint64_t each = ceil_div(all.count, workers); each > best.loads) {
    return {each, fmt::format("all {} workers together load at least {}P - {}C = {} items "
                              "(docs/theorems.md, Theorem 5): one of them at least {}",
                              workers, all.s + 1, most_meetings(all.s, 2), all.count, each)};
  }
  return best;
}

}  // namespace

LoadBound makespan_lower_bound(const WantedPairs& wanted, std::uint64_t room,
                               std::uint64_t workers) {
  check_workers(workers);
  LoadBound alone = load_lower_bound(wanted, room);
  if (workers == 1) {
    return alone;
  }
  room = std::min(room, std::max<std::uint64_t>(2, wanted.items()));
  LoadBound by_pairs = bound_by_pairs(wanted.count(), wanted.kind() == WantedPairs::Kind::between,
                                      needed_items(wanted), alone.loads, room, workers);
  return wanted.are_all() ? bound_of_all(std::move(by_pairs), wanted.items(), room, workers)
                          : by_pairs;
}

}  // namespace changeover
