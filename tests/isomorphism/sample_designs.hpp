// Lists of blocks to compare: random ones, known ones, and what a map makes of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/isomorphism/isomorphism.hpp"

namespace changeover::test {

using Generator = std::mt19937_64;

inline std::size_t below(Generator& random, std::size_t n) { return random() % n; }

template <typename T>
void shuffle(Generator& random, std::vector<T>& items) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[below(random, i)]);
  }
}

/// Any blocks, whether they are a design or not; repetitions are likely when few blocks are
/// possible.
inline Design random_blocks(Generator& random, std::size_t v, std::size_t k, std::size_t b,
                            Kind kind) {
  Design design(Parameters{.v = v, .k = k, .change = 1, .kind = kind});
  std::vector<Element> elements(v);
  std::iota(elements.begin(), elements.end(), Element{0});
  for (std::size_t i = 0; i < b; ++i) {
    shuffle(random, elements);
    design.append(std::span(elements).first(k));
  }
  return design;
}

/// A map that may act on the design: any permutation, a rotation if it is circular, a reversal if
/// allowed.
inline Isomorphism random_map(Generator& random, const Design& design, bool reversal) {
  const std::size_t b = design.block_count();
  Isomorphism map = identity(design.v());
  shuffle(random, map.elements);
  map.reversed = reversal && below(random, 2) == 1;
  map.shift = design.parameters().kind == Kind::circular ? below(random, b)
              : map.reversed                             ? b - 1
                                                         : 0;
  return map;
}

/// Base + 0, base + 1, …, base + (v−1) over Z_v, circular.
inline Design developed(std::size_t v, std::size_t change, const Block& base) {
  Design design(Parameters{.v = v, .k = base.size(), .change = change, .kind = Kind::circular});
  for (std::size_t i = 0; i < v; ++i) {
    Block block = base;
    for (Element& x : block) {
      x = static_cast<Element>((x + i) % v);
    }
    design.append(block);
  }
  return design;
}

/// One element of one block exchanged for another.
inline Design mutated(Generator& random, const Design& design) {
  const std::size_t victim = below(random, design.block_count());
  Design other(design.parameters());
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    Block block(design.block(i).begin(), design.block(i).end());
    if (i == victim) {
      Element fresh = 0;
      do {
        fresh = static_cast<Element>(below(random, design.v()));
      } while (std::find(block.begin(), block.end(), fresh) != block.end());
      block[below(random, block.size())] = fresh;
    }
    other.append(block);
  }
  return other;
}

}  // namespace changeover::test
