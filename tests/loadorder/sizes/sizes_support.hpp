// Items of different size: the definition in plain code, and the fewest bytes by trying everything.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../pairs/pairs_support.hpp"

namespace changeover::test {

inline std::shared_ptr<const ItemSizes> sizes_of(std::vector<std::uint64_t> bytes,
                                                 std::uint64_t memory) {
  return std::make_shared<const ItemSizes>(ItemSizes{std::move(bytes), memory});
}

/// Items of 1 to `largest` bytes; memory is for the two largest and up to `spare` bytes more.
inline std::shared_ptr<const ItemSizes> random_sizes(std::mt19937& random, std::size_t items,
                                                     std::uint64_t largest, std::uint64_t spare) {
  std::vector<std::uint64_t> bytes;
  for (std::size_t i = 0; i < items; ++i) {
    bytes.push_back(1 + random() % largest);
  }
  std::vector<std::uint64_t> sorted = bytes;
  std::sort(sorted.rbegin(), sorted.rend());
  return sizes_of(bytes, sorted[0] + sorted[1] + random() % (spare + 1));
}

/// The definition in plain code, for one worker: bytes that are loaded, and a fault. Pairs that
/// meet are added to `met`.
inline std::pair<std::uint64_t, std::string> play(StepSource& steps, const ItemSizes& sizes,
                                                  std::set<ItemPair>& met) {
  std::set<Element> memory;
  std::uint64_t held = 0;
  std::uint64_t loaded = 0;
  for (Step step; steps.next(step);) {
    for (const Element x : step.evict) {
      if (memory.erase(x) != 1) {
        return {0, "evicts what is not there"};
      }
      held -= sizes.bytes[x];
    }
    for (const Element x : step.load) {
      if (!memory.insert(x).second) {
        return {0, "loads what is there"};
      }
      held += sizes.bytes[x];
      loaded += sizes.bytes[x];
      for (const Element y : memory) {
        met.emplace(std::min(x, y), std::max(x, y));
      }
    }
    if (held > sizes.memory) {
      return {0, "too much memory"};
    }
  }
  return {loaded, ""};
}

/// Whether all wanted pairs have met.
inline bool have_all_met(const std::set<ItemPair>& met, std::uint64_t items,
                         const WantedPairs& wanted) {
  for (Element y = 0; y < items; ++y) {
    for (Element x = 0; x < y; ++x) {
      if (wanted.contains(x, y) && met.count({x, y}) == 0) {
        return false;
      }
    }
  }
  return true;
}

/// The same of one order.
inline std::pair<std::uint64_t, std::string> play(StepSource& steps, const ItemSizes& sizes,
                                                  const WantedPairs& wanted) {
  std::set<ItemPair> met;
  const auto played = play(steps, sizes, met);
  return played.second.empty() && !have_all_met(met, sizes.bytes.size(), wanted)
             ? std::pair(std::uint64_t{0}, std::string("a pair is missing"))
             : played;
}

/// The fewest bytes there can be, through all memories and sets of pairs that have met.
inline std::uint64_t fewest_bytes(const ItemSizes& sizes, const WantedPairs& wanted) {
  const auto items = static_cast<unsigned>(sizes.bytes.size());
  std::uint32_t all = 0;
  const auto pairs_in = [&](unsigned memory) {
    std::uint32_t pairs = 0;
    unsigned bit = 0;
    for (unsigned y = 1; y < items; ++y) {
      for (unsigned x = 0; x < y; ++x, ++bit) {
        const bool both = (memory >> x & memory >> y & 1U) != 0;
        pairs |= both && wanted.contains(x, y) ? 1U << bit : 0U;
      }
    }
    return pairs;
  };
  all = pairs_in((1U << items) - 1);
  const auto bytes_in = [&](unsigned memory) {
    std::uint64_t bytes = 0;
    for (unsigned x = 0; x < items; ++x) {
      bytes += (memory >> x & 1U) != 0 ? sizes.bytes[x] : 0;
    }
    return bytes;
  };
  using Place = std::pair<unsigned, std::uint32_t>;
  std::map<Place, std::uint64_t> best{{{0, 0}, 0}};
  std::set<std::pair<std::uint64_t, Place>> next{{0, {0, 0}}};
  while (!next.empty()) {
    const auto [cost, place] = *next.begin();
    next.erase(next.begin());
    if (cost > best.at(place)) {
      continue;
    }
    if (place.second == all) {
      return cost;
    }
    for (unsigned x = 0; x < items; ++x) {
      const unsigned memory = place.first ^ (1U << x);
      const bool loads = (memory >> x & 1U) != 0;
      if (bytes_in(memory) > sizes.memory) {
        continue;
      }
      const Place to{memory, place.second | pairs_in(memory)};
      const std::uint64_t its = cost + (loads ? sizes.bytes[x] : 0);
      const auto [found, is_new] = best.emplace(to, its);
      if (is_new || its < found->second) {
        found->second = its;
        next.emplace(its, to);
      }
    }
  }
  return 0;
}

}  // namespace changeover::test
