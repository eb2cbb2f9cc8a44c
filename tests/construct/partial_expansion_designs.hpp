// Small designs of every sort, for the tests of partial expansion.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "changeover/construct/expansion.hpp"
#include "construction_checks.hpp"

namespace changeover::test {

inline Design built(std::string_view by, std::uint64_t v, std::uint64_t k, std::uint64_t m = 2,
                    Kind kind = Kind::circular) {
  return standard().build_design(offer_of(by, {v, k, m, kind, 2})->recipe);
}

// The circular design gone through twice: no longer tight.
inline Design twice(const Design& design) {
  Design result(design.parameters());
  for (std::size_t i = 0; i < 2 * design.block_count(); ++i) {
    result.append(design.block(i % design.block_count()));
  }
  return result;
}

inline Design cut_at(const Design& design, std::size_t at) {
  Parameters p = design.parameters();
  p.kind = Kind::linear;
  Design result(p);
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    result.append(design.block((at + i) % design.block_count()));
  }
  return result;
}

// Circular and linear, tight and not, k even and odd, m = 1 and 2.
inline const std::vector<Design>& some_designs() {
  static const std::vector<Design> designs{
      built("doubling", 6, 4),
      built("doubling", 10, 6),
      built("fixed-element", 7, 5),
      built("cyclic-paper", 7, 3),
      built("cyclic-paper", 11, 4),
      built("cyclic-paper", 21, 4),
      built("cyclic-paper", 15, 5),
      built("cyclic-paper", 19, 6),
      twice(built("doubling", 6, 4)),
      twice(built("cyclic-paper", 11, 4)),
      built("printed", 7, 3, 2, Kind::linear),
      cut_at(built("cyclic-paper", 11, 4), 3),
      cut_at(built("cyclic-paper", 15, 5), 0),
      cut_at(built("doubling", 6, 4), 1),
      built("short-long-runs", 8, 5),
      cut_at(built("short-long-runs", 8, 5), 2),
      built("mcsorley-circular", 3, 2, 1),
      built("mcsorley-circular", 5, 3, 1),
      built("mcsorley-circular", 9, 5, 1),
      twice(built("mcsorley-circular", 7, 4, 1)),
      cut_at(built("mcsorley-circular", 7, 4, 1), 2),
      cut_at(built("mcsorley-circular", 11, 6, 1), 0),
  };
  return designs;
}

inline CoverOptions for_w(std::uint64_t w) {
  CoverOptions options;
  options.new_elements = w;
  return options;
}

inline std::string title(const Design& design, std::uint64_t w) {
  return name(design.parameters()) + " with " + std::to_string(design.block_count()) +
         " blocks, w = " + std::to_string(w);
}

// Whether w can be added at all: otherwise there is nothing to come beside.
inline bool fits(const Design& design, std::uint64_t w) {
  return w >= design.parameters().change ||
         design.v() >= design.k() + 2 * design.parameters().change - w;
}

inline bool leaves_one_out(const UnchangedCover& cover, std::uint64_t v) {
  std::set<Element> met;
  for (const UnchangedSubset& subset : cover.subsets) {
    met.insert(subset.elements.begin(), subset.elements.end());
  }
  return met.size() < v;
}

}  // namespace changeover::test
