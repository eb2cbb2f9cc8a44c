// A lower bound on the bytes that an order of items of different sizes loads.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

// Sums of products of sizes exceed 64 bits; rounded down, they remain bounds.
using Wide = long double;
constexpr Wide rounding = 1e-12L;  // relative error of all sums together

std::uint64_t rounded_up(Wide bytes) {
  return bytes <= 0 ? 0 : static_cast<std::uint64_t>(std::ceil(bytes * (1 - rounding)));
}

struct Weights {
  Wide pairs = 0;    // the sum of s_x s_y over all pairs
  Wide brought = 0;  // the most that one load of each item can add
  Wide capped = 0;   // the same, limited by the pairs of each item
  std::uint64_t bytes = 0;
  std::uint64_t items = 0;
  std::uint64_t largest = 0;
  std::uint64_t smallest = ~std::uint64_t{0};
  std::uint64_t best_capped = 0;  // the most that a byte can add
};

// For the items with at least `least` bytes.
Weights weights_of(const ItemSizes& sizes, const WantedPairs& wanted, std::uint64_t least) {
  Weights w;
  const std::uint64_t memory = sizes.memory;
  const auto counts = [&](Element x) { return wanted.needs(x) && sizes.bytes[x] >= least; };
  Wide all = 0;
  for (Element x = 0; x < sizes.bytes.size(); ++x) {
    all += counts(x) ? static_cast<Wide>(sizes.bytes[x]) : 0;
  }
  for (Element x = 0; x < sizes.bytes.size(); ++x) {
    if (!counts(x)) {
      continue;
    }
    const std::uint64_t size = sizes.bytes[x];
    Wide partners = wanted.are_all() ? all - static_cast<Wide>(size) : 0;
    if (!wanted.are_all()) {
      each_partner(wanted, sizes.bytes.size(), x, [&](Element y) {
        partners += counts(y) ? static_cast<Wide>(sizes.bytes[y]) : 0;
      });
    }
    const std::uint64_t beside = memory - size;
    const Wide cap = std::min(partners, static_cast<Wide>(beside));
    w.pairs += static_cast<Wide>(size) * partners / 2;
    w.brought += static_cast<Wide>(size) * static_cast<Wide>(beside);
    w.capped += static_cast<Wide>(size) * cap;
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
std::pair<std::uint64_t, std::uint64_t> bytes_beyond(const Weights& w, std::uint64_t memory) {
  std::pair<std::uint64_t, std::uint64_t> best{0, 0};
  const auto consider = [&](Wide lacking, std::uint64_t most) {
    const std::uint64_t more =
        most > 0 ? rounded_up(lacking / static_cast<Wide>(most)) : std::uint64_t{0};
    best = std::max(best, std::pair(more, most));
  };
  const Wide m = static_cast<Wide>(memory);
  if (w.bytes > memory) {
    const Wide less = m * (m - static_cast<Wide>(w.largest)) / 2;
    consider(w.pairs + less - w.brought, memory - w.smallest);
  }
  consider(w.pairs - w.capped, w.best_capped);
  return best;
}

// Treats an item as the number of units that fit into it, which move together.
LoadBound by_units(const ItemSizes& sizes, std::uint64_t bytes) {
  std::uint64_t unit = 0;
  for (const std::uint64_t size : sizes.bytes) {
    unit = std::gcd(unit, size);
  }
  constexpr std::uint64_t most_units = 1'000'000;
  unit = std::max(unit, ceil_div(bytes, most_units));
  std::uint64_t units = 0;
  for (const std::uint64_t size : sizes.bytes) {
    units += size / unit;
  }
  const std::uint64_t room = sizes.memory / unit;
  if (units <= room || room < 2) {
    return {};
  }
  const LoadBound bound = load_lower_bound(units, room);
  return {checked_multiply(unit, bound.loads),
          fmt::format("items are {} units of {} bytes that move together, with room for {}: {}",
                      units, unit, room, bound.reason)};
}

}  // namespace

LoadBound sized_lower_bound(const ItemSizes& sizes, const WantedPairs& wanted) {
  check_sizes(sizes, wanted);
  const std::uint64_t bytes = weights_of(sizes, wanted, 0).bytes;
  LoadBound best{bytes, fmt::format("each item is loaded, {} bytes in all", bytes)};
  if (bytes <= sizes.memory) {
    return best;
  }
  // The loads of some items are an order for these; all others are loaded once.
  std::vector<std::uint64_t> thresholds = sizes.bytes;
  std::sort(thresholds.begin(), thresholds.end());
  thresholds.erase(std::unique(thresholds.begin(), thresholds.end()), thresholds.end());
  constexpr std::size_t most_tried = 64;
  const std::size_t tried = std::min(most_tried, thresholds.size());
  for (std::size_t i = 0; i < tried; ++i) {
    const Weights w = weights_of(sizes, wanted, thresholds[i * thresholds.size() / tried]);
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
    if (LoadBound units = by_units(sizes, bytes); units.loads > best.loads) {
      best = std::move(units);
    }
  }
  return best;
}

}  // namespace changeover
