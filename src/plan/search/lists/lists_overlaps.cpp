// How long scarce parts are on two benches at a time, if no bench waits: what a search counts that
// cannot ask the clock after every move.
#include <algorithm>

#include "core/bit_number.hpp"
#include "plan/search/lists/lists.hpp"

namespace changeover {

void Lists::set_overlaps(const ListsJob& job) {
  scarce_.assign(benches(), Bits((parts_ + 63) / 64, 0));
  spent_ = cost_;
  for (std::size_t bench = 0; bench < benches(); ++bench) {
    for (Element x = 0; x < parts_; ++x) {
      const bool one_only = job.clock->quantity[x] == 1 && job.clock->shared[bench][x];
      scarce_[bench][x >> 6] |= std::uint64_t{one_only} << (x & 63);
    }
  }
}

// Σ number(a set-up there, its bench) · for how long it is at the same time.
template <typename Number>
std::int64_t Lists::sum_of_overlaps(std::size_t bench, const Place& place, Number&& number) const {
  std::int64_t all = 0;
  for (std::size_t other = 0; other < benches(); ++other) {
    if (other == bench) {
      continue;
    }
    const std::vector<std::uint32_t>& order = order_[other];
    auto at = std::ranges::lower_bound(order, place.end, {},
                                       [&](std::uint32_t handle) { return places_[handle].begin; });
    while (at != order.begin() && places_[*--at].begin + longest_ > place.begin) {
      const Place& there = places_[*at];
      const std::int64_t both = std::min(place.end, there.end) - std::max(place.begin, there.begin);
      all += both > 0 ? both * number(there, other) : 0;
    }
  }
  return all;
}

std::int64_t Lists::overlap_of(std::size_t bench, const Place& place) const {
  if (scarce_.empty()) {
    return 0;
  }
  const Bits& own = scarce_[bench];
  return sum_of_overlaps(bench, place, [&](const Place& there, std::size_t other) {
    std::int64_t number = 0;
    for (std::size_t w = 0; w < own.size(); ++w) {
      number += number_of_bits(place.bits[w] & there.bits[w] & own[w] & scarce_[other][w]);
    }
    return number;
  });
}

std::int64_t Lists::overlap_of(std::size_t bench, const Place& place, Element x) const {
  return scarce_.empty() || !bit(scarce_[bench], x)
             ? 0
             : sum_of_overlaps(bench, place, [&](const Place& there, std::size_t other) {
                 return bit(there.bits, x) && bit(scarce_[other], x) ? 1 : 0;
               });
}

// The times of a set-up that was put here; those of the others stay.
void Lists::set_time(Spot where) {
  const std::vector<std::uint32_t>& order = order_[where.bench];
  Place& place = places_[order[where.at]];
  place.begin = where.at + 1 < order.size() ? places_[order[where.at + 1]].begin
                : where.at > 0              ? places_[order[where.at - 1]].end
                                            : spent_[where.bench];
  place.end = place.begin + place.cost;
  longest_ = std::max(longest_, place.cost);
}

void Lists::retime() {
  if (scarce_.empty()) {
    return;
  }
  longest_ = 0;
  for (std::size_t bench = 0; bench < benches(); ++bench) {
    std::int64_t now = spent_[bench];
    for (const std::uint32_t handle : order_[bench]) {
      Place& place = places_[handle];
      place.begin = now;
      place.end = now += place.cost;
      longest_ = std::max(longest_, place.cost);
    }
  }
  std::int64_t twice = 0;
  for (std::size_t bench = 0; bench < benches(); ++bench) {
    for (const std::uint32_t handle : order_[bench]) {
      twice += overlap_of(bench, places_[handle]);
    }
  }
  overlap_ = twice / 2;
}

void Lists::do_reverse(std::size_t bench, Stretch where) {
  changed({bench, where.first});
  const std::vector<std::uint32_t>& order = order_[bench];
  for (std::size_t at = where.first; at <= where.last && !scarce_.empty(); ++at) {
    overlap_ -= overlap_of(bench, places_[order[at]]);
  }
  std::int64_t begin = places_[order[where.first]].begin;
  std::reverse(order_[bench].begin() + static_cast<std::ptrdiff_t>(where.first),
               order_[bench].begin() + static_cast<std::ptrdiff_t>(where.last) + 1);
  const std::int64_t latest = where.last + 1 < order.size()
                                  ? places_[order[where.last + 1]].begin
                                  : std::numeric_limits<std::int64_t>::max();
  for (std::size_t at = where.first; at <= where.last && !scarce_.empty(); ++at) {
    Place& place = places_[order[at]];
    const std::int64_t takes = place.end - place.begin;
    place.begin = std::min(begin, latest);
    place.end = begin = place.begin + takes;
  }
  for (std::size_t at = where.first; at <= where.last && !scarce_.empty(); ++at) {
    overlap_ += overlap_of(bench, places_[order[at]]);
  }
  for (std::size_t at = where.first; at <= where.last + 1; ++at) {
    price({bench, at});
  }
}

}  // namespace changeover
