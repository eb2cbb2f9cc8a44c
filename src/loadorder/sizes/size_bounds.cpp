// A lower bound on the bytes that an order of items of different sizes loads.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/least_number.hpp"
#include "core/words.hpp"
#include "loadorder/shares/few_workers.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

// Sums of products of sizes exceed 64 bits; rounded down, they remain bounds.
using Real = long double;
constexpr Real rounding = 1e-12L;  // relative error of all sums together

std::uint64_t rounded_up(Real bytes) {
  return bytes <= 0 ? 0 : static_cast<std::uint64_t>(std::ceil(bytes * (1 - rounding)));
}

struct SizeWeights {
  Real pairs = 0;    // the sum of s_x s_y over all pairs
  Real brought = 0;  // the most that one load of each item can add
  Real capped = 0;   // the same, limited by the pairs of each item
  std::uint64_t bytes = 0;
  std::uint64_t items = 0;
  std::uint64_t largest = 0;
  std::uint64_t smallest = ~std::uint64_t{0};
  std::uint64_t best_capped = 0;  // the most that a byte can add
};

// For the items with at least `least` bytes.
SizeWeights size_weights_of(const ItemSizes& sizes, const WantedPairs& wanted,
                            std::uint64_t least) {
  SizeWeights w;
  const std::uint64_t memory = sizes.memory;
  const auto counts = [&](Element x) { return wanted.needs(x) && sizes.bytes[x] >= least; };
  Real all = 0;
  for (Element x = 0; x < sizes.bytes.size(); ++x) {
    all += counts(x) ? static_cast<Real>(sizes.bytes[x]) : 0;
  }
  for (Element x = 0; x < sizes.bytes.size(); ++x) {
    if (!counts(x)) {
      continue;
    }
    const std::uint64_t size = sizes.bytes[x];
    Real partners = wanted.are_all() ? all - static_cast<Real>(size) : 0;
    if (!wanted.are_all()) {
      each_partner(wanted, sizes.bytes.size(), x, [&](Element y) {
        partners += counts(y) ? static_cast<Real>(sizes.bytes[y]) : 0;
      });
    }
    const std::uint64_t beside = memory - size;
    const Real cap = std::min(partners, static_cast<Real>(beside));
    w.pairs += static_cast<Real>(size) * partners / 2;
    w.brought += static_cast<Real>(size) * static_cast<Real>(beside);
    w.capped += static_cast<Real>(size) * cap;
    w.best_capped = std::max(w.best_capped, static_cast<std::uint64_t>(std::ceil(cap)));
    w.bytes = checked_add(w.bytes, size);
    ++w.items;
    w.largest = std::max(w.largest, size);
    w.smallest = std::min(w.smallest, size);
  }
  return w;
}

// The bytes that these items need beyond one load each, and the most that a loaded byte adds. A
// load of x adds products of its size and those in memory, at most s_x (M - s_x); the loads before
// memory can be full add M (M - s) / 2 less, where s is the largest size.
std::pair<std::uint64_t, std::uint64_t> bytes_beyond(const SizeWeights& w, std::uint64_t memory) {
  std::pair<std::uint64_t, std::uint64_t> best{0, 0};
  const auto consider = [&](Real lacking, std::uint64_t most) {
    const std::uint64_t more =
        most > 0 ? rounded_up(lacking / static_cast<Real>(most)) : std::uint64_t{0};
    best = std::max(best, std::pair(more, most));
  };
  const Real m = static_cast<Real>(memory);
  if (w.bytes > memory) {
    const Real less = m * (m - static_cast<Real>(w.largest)) / 2;
    consider(w.pairs + less - w.brought, memory - w.smallest);
  }
  consider(w.pairs - w.capped, w.best_capped);
  return best;
}

// Treats an item as the number of units that fit into it, which move together. With several
// workers this bounds the bytes of the busiest.
LoadBound by_units(const ItemSizes& sizes, std::uint64_t bytes, std::uint64_t workers) {
  std::uint64_t unit = 0;
  for (const std::uint64_t size : sizes.bytes) {
    unit = std::gcd(unit, size);
  }
  constexpr std::uint64_t most_units = 1'000'000;
  unit = std::max(unit, ceil_div(bytes, most_units));
  const std::uint64_t units =
      sum_of(sizes.bytes, [&](const std::uint64_t size) { return size / unit; });
  const std::uint64_t room = sizes.memory / unit;
  if (units <= room || room < 2) {
    return {};
  }
  const LoadBound bound = makespan_lower_bound(units, room, workers);
  return {checked_multiply(unit, bound.loads),
          fmt::format("items are {} units of {} that move together, with room for {}: {}", units,
                      count_of(unit, "byte"), room, bound.reason)};
}

// The bytes of all items that each item must meet.
std::vector<std::uint64_t> partner_bytes(const ItemSizes& sizes, const WantedPairs& wanted) {
  std::vector<std::uint64_t> sums(sizes.bytes.size(), 0);
  const std::uint64_t all =
      wanted.are_all() ? std::accumulate(sizes.bytes.begin(), sizes.bytes.end(), std::uint64_t{0})
                       : 0;
  for (Element x = 0; x < sums.size(); ++x) {
    if (wanted.are_all()) {
      sums[x] = all - sizes.bytes[x];
    } else if (wanted.needs(x)) {
      each_partner(wanted, sums.size(), x, [&](Element y) { sums[x] += sizes.bytes[y]; });
    }
  }
  return sums;
}

// However large the memory: an item is loaded by so many workers that all that it must meet fits
// beside it into what they load.
LoadBound by_workers_of_items(const ItemSizes& sizes, const WantedPairs& wanted,
                              const std::vector<std::uint64_t>& partners, std::uint64_t high,
                              std::uint64_t workers) {
  const std::uint64_t least = least_number(0, high, [&](std::uint64_t bytes) {
    Real loaded = 0;
    for (Element x = 0; x < partners.size(); ++x) {
      if (!wanted.needs(x)) {
        continue;
      }
      if (bytes < sizes.bytes[x] || (bytes == sizes.bytes[x] && partners[x] > 0)) {
        return false;
      }
      const std::uint64_t times =
          partners[x] == 0 ? 1 : ceil_div(partners[x], bytes - sizes.bytes[x]);
      loaded += static_cast<Real>(sizes.bytes[x]) * static_cast<Real>(times);
    }
    return loaded * (1 - rounding) <= static_cast<Real>(bytes) * static_cast<Real>(workers);
  });
  return {least, fmt::format("if no worker loads {} bytes, an item is loaded by so many workers "
                             "that what it must meet fits beside it, and all together are more "
                             "than {} workers load",
                             least, workers)};
}

// A load of s bytes, when T bytes have been loaded, adds at most s min(T, most) to what pairs
// weigh: no more than the integral of min(t, most) from T to T + s, and s²/2 less below `most`.
LoadBound by_weight(const SizeWeights& w, std::uint64_t most, std::uint64_t high,
                    std::uint64_t workers) {
  const auto weight = [&](std::uint64_t bytes) {
    const std::uint64_t rising = std::min(bytes, most);
    const std::uint64_t inside = rising - std::min(rising, w.largest);
    const Real r = static_cast<Real>(rising);
    return r * r / 2 + static_cast<Real>(bytes - rising) * static_cast<Real>(most) -
           static_cast<Real>(w.smallest) * static_cast<Real>(inside) / 2;
  };
  const std::uint64_t least = least_number(0, high, [&](std::uint64_t bytes) {
    return weight(bytes) * static_cast<Real>(workers) >= w.pairs * (1 - rounding);
  });
  return {least, fmt::format("a pair weighs the product of its sizes, all of them {:.4g}, and {} "
                             "workers that load fewer than {} bytes each bring less together",
                             static_cast<double>(w.pairs), workers, least)};
}

}  // namespace

LoadBound sized_makespan_bound(const ItemSizes& sizes, const WantedPairs& wanted,
                               std::uint64_t workers) {
  check_workers(workers);
  LoadBound alone = sized_lower_bound(sizes, wanted);
  if (workers == 1) {
    return alone;
  }
  LoadBound best{ceil_div(alone.loads, workers),
                 fmt::format("all {} workers together load at least {} bytes: {}", workers,
                             alone.loads, alone.reason)};
  const auto consider = [&](LoadBound bound) {
    if (bound.loads > best.loads) {
      best = std::move(bound);
    }
  };
  const std::vector<std::uint64_t> partners = partner_bytes(sizes, wanted);
  consider(by_workers_of_items(sizes, wanted, partners, alone.loads, workers));
  const SizeWeights w = size_weights_of(sizes, wanted, 0);
  consider(by_weight(w, std::min(sizes.memory - w.smallest, *std::ranges::max_element(partners)),
                     alone.loads, workers));
  if (wanted.are_all()) {
    consider(by_units(sizes, w.bytes, workers));
  }
  return best;
}

LoadBound sized_lower_bound(const ItemSizes& sizes, const WantedPairs& wanted) {
  check_sizes(sizes, wanted);
  const std::uint64_t bytes = size_weights_of(sizes, wanted, 0).bytes;
  LoadBound best{bytes, fmt::format("each item is loaded, {} bytes in all", bytes)};
  if (bytes <= sizes.memory) {
    return best;
  }
  // The loads of some items are an order for these; all others are loaded once.
  std::vector<std::uint64_t> thresholds = sizes.bytes;
  std::ranges::sort(thresholds);
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  constexpr std::size_t most_tried = 64;
  const std::size_t tried = std::min(most_tried, thresholds.size());
  for (std::size_t i = 0; i < tried; ++i) {
    const SizeWeights w = size_weights_of(sizes, wanted, thresholds[i * thresholds.size() / tried]);
    const auto [more, most] = bytes_beyond(w, sizes.memory);
    if (checked_add(bytes, more) > best.loads) {
      const std::string which =
          w.items == sizes.bytes.size()
              ? std::string("all pairs")
              : fmt::format("the pairs of the {} items from {} bytes on", w.items, w.smallest);
      best = {bytes + more,
              fmt::format("each item is loaded, {} bytes in all, and {} bytes more: a pair weighs "
                          "the product of its sizes, a loaded byte brings at most {}, and {} weigh "
                          "{:.4g}",
                          bytes, more, most, which, static_cast<double>(w.pairs))};
    }
  }
  if (wanted.are_all()) {
    if (LoadBound units = by_units(sizes, bytes, 1); units.loads > best.loads) {
      best = std::move(units);
    }
  }
  return best;
}

}  // namespace changeover
