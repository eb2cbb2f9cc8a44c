#include "loadorder/shares/few_workers.hpp"

#include <fmt/format.h>

#include "core/checked.hpp"
#include "core/least_number.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

__extension__ using Large = __int128;

// Whether the counts allow W workers with at most ℓ items each to have an item at k workers and
// none at fewer, or every item at more than k.
bool agrees(std::uint64_t items, std::uint64_t workers, std::uint64_t k, std::uint64_t most) {
  const Large p = items;
  const Large w = workers;
  const Large n = k;
  const Large l = most;
  if (p - 1 <= (n - 1) * (l - 1) || (n + 1) * p <= w * l) {
    return true;  // some item is at fewer workers, or all are at more
  }
  const Large spare = n * (l - 1) - (p - 1);
  const Large twice = n * n * (w + n * n - 2 * n) - w * (w - 1);
  return spare >= 0 &&
         (twice <= 0 || w * (w - 1) * (n + 1) * spare >=
                            twice * ((n + 1) * p - w * l) - w * (w - 1) * (n * n - 1));
}

}  // namespace

void check_workers(std::uint64_t workers) {
  if (workers == 0 || workers > most_workers) {
    throw BadInput(fmt::format("{} workers: give 1 to {}", workers, most_workers));
  }
}

LoadBound least_at_one_worker(std::uint64_t items, std::uint64_t workers) {
  LoadBound best{1, "an item is loaded"};
  if (items == 1) {
    return best;
  }
  // Fractional covers of all families of pairwise intersecting sets.
  constexpr std::uint64_t parts[] = {0, 1, 1, 3, 5, 9};
  constexpr std::uint64_t of[] = {1, 1, 1, 2, 3, 5};
  if (workers <= 5) {
    best.loads = ceil_div(checked_multiply(items, of[workers]), parts[workers]);
    best.reason =
        parts[workers] == of[workers]
            ? fmt::format("with {} some worker loads all items (docs/theorems.md, Theorem 17)",
                          count_of(workers, "worker"))
            : fmt::format(
                  "any two items meet at one of {} workers, so one of them loads at least "
                  "{}/{} of {} items (docs/theorems.md, Theorem 17)",
                  workers, of[workers], parts[workers], items);
    return best;
  }
  for (std::uint64_t k = 1; k == 1 || (k - 1) * (k - 1) <= workers; ++k) {
    const std::uint64_t least =
        least_number(1, items, [&](std::uint64_t most) { return agrees(items, workers, k, most); });
    if (least > best.loads) {
      best.loads = least;
      best.reason = fmt::format(
          "any two of {} items meet at one of {} workers; if none loads more than {}, some item is "
          "loaded by at most {} of them and cannot meet all others there, or too many pairs meet "
          "at several (docs/theorems.md, Theorem 17)",
          items, workers, least - 1, k);
    }
  }
  return best;
}

}  // namespace changeover
