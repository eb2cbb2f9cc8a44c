// The definition of a change covering design, word by word, with sets: slow and easy to check.
// Shares no code with verify/.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover::test {

using Subset = std::set<Element>;

struct NaiveVerdict {
  bool valid = false;
  std::uint64_t bad_steps = 0;
  std::uint64_t uncovered = 0;
  std::uint64_t covered = 0;
  std::uint64_t never_newly_covered = 0;
  std::uint64_t excess = 0;
  std::vector<std::uint64_t> introductions;
  std::vector<std::uint64_t> blocks;
  std::vector<std::uint64_t> element_excess;  // strength 2
  std::set<Subset> unchanged;
};

inline void subsets_of(const std::vector<Element>& from, std::size_t size, std::size_t start,
                       Subset& chosen, std::set<Subset>& out) {
  if (chosen.size() == size) {
    out.insert(chosen);
    return;
  }
  for (std::size_t i = start; i < from.size(); ++i) {
    chosen.insert(from[i]);
    subsets_of(from, size, i + 1, chosen, out);
    chosen.erase(from[i]);
  }
}

inline std::set<Subset> subsets_of(const Subset& set, std::size_t size) {
  std::set<Subset> out;
  Subset chosen;
  subsets_of({set.begin(), set.end()}, size, 0, chosen, out);
  return out;
}

inline bool contains(const Subset& set, const Subset& subset) {
  return std::includes(set.begin(), set.end(), subset.begin(), subset.end());
}

inline NaiveVerdict naive_verdict(const Design& design) {
  const Parameters& p = design.parameters();
  std::vector<Subset> list;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    const auto block = design.block(i);
    list.emplace_back(block.begin(), block.end());
  }
  const std::size_t b = list.size();
  const bool wraps = p.kind == Kind::circular && b > 1;
  NaiveVerdict verdict;

  for (std::size_t i = 0; i < b; ++i) {
    if (i + 1 < b || wraps) {
      Subset kept;
      for (const Element x : list[i]) {
        if (list[(i + 1) % b].count(x) != 0) {
          kept.insert(x);
        }
      }
      verdict.bad_steps += p.k - kept.size() != p.change ? 1U : 0U;
      verdict.unchanged.insert(kept);
    }
  }

  Subset all;
  for (Element x = 0; x < p.v; ++x) {
    all.insert(x);
  }
  std::map<Element, std::uint64_t> covered_at;
  std::map<Element, std::uint64_t> distinct_at;
  for (const Subset& subset : subsets_of(all, p.strength)) {
    bool occurs = false;
    std::uint64_t times = 0;
    for (std::size_t i = 0; i < b; ++i) {
      if (contains(list[i], subset)) {
        occurs = true;
        const bool has_previous = i > 0 || wraps;
        const bool held_before = has_previous && contains(list[(i + b - 1) % b], subset);
        times += held_before ? 0 : 1;
      }
    }
    verdict.uncovered += occurs ? 0 : 1;
    verdict.never_newly_covered += occurs && times == 0 ? 1 : 0;
    verdict.covered += times;
    verdict.excess += times > 1 ? times - 1 : 0;
    for (const Element x : subset) {
      covered_at[x] += times;
      distinct_at[x] += times > 0 ? 1 : 0;
    }
  }

  for (Element x = 0; x < p.v; ++x) {
    std::uint64_t introductions = 0;
    std::uint64_t blocks = 0;
    for (std::size_t i = 0; i < b; ++i) {
      if (list[i].count(x) != 0) {
        ++blocks;
        const bool has_previous = i > 0 || wraps;
        introductions += has_previous && list[(i + b - 1) % b].count(x) != 0 ? 0U : 1U;
      }
    }
    verdict.introductions.push_back(introductions);
    verdict.blocks.push_back(blocks);
    verdict.element_excess.push_back(covered_at[x] - distinct_at[x]);
  }
  verdict.valid = b > 0 && verdict.bad_steps == 0 && verdict.uncovered == 0;
  return verdict;
}

}  // namespace changeover::test
