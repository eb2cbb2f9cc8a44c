#include "curator/weakest.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "../catalog/entries.hpp"
#include "run_program.hpp"

namespace changeover::test::weakest_test {
namespace {

constexpr Kind linear = Kind::linear;
constexpr Kind circular = Kind::circular;

struct Cell {
  Parameters parameters;
  std::uint64_t b, lower_bound;
};

void fill(Catalog& catalog, const std::vector<Cell>& cells) {
  std::mt19937 random(1);
  for (const Cell& cell : cells) {
    CatalogEntry entry = random_entry(cell.parameters, cell.b, random);
    entry.lower_bound = cell.lower_bound;
    catalog.add(entry);
  }
}

std::vector<Parameters> pass(WeakestFirst& cells) {
  std::vector<Parameters> order;
  cells.begin_pass();
  while (const auto p = cells.next()) {
    order.push_back(*p);
  }
  return order;
}

TEST(WeakestFirst, NamesEachWeakCellOnceInAPass) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  fill(catalog, {{{8, 4, 2, linear}, 10, 10},  // nothing to gain
                 {{9, 4, 2, linear}, 12, 11},
                 {{9, 4, 2, circular}, 14, 11},
                 {{20, 4, 1, linear}, 30, 20}});
  WeakestFirst cells(catalog, {});
  const std::vector<Parameters> order = pass(cells);
  EXPECT_EQ(order.size(), 3U);
  EXPECT_EQ(std::set(order.begin(), order.end()).size(), 3U);
  EXPECT_EQ(pass(cells), order);
  WeakestFirst some(catalog, {.change = 1});
  EXPECT_EQ(pass(some), (std::vector<Parameters>{{20, 4, 1, linear}}));
  WeakestFirst wide(catalog, {.gap = 4});
  EXPECT_EQ(pass(wide).size(), 1U);
}

// Two cells with as much over the bound; one of them is the beginning of a third.
TEST(WeakestFirst, WhatOthersGainCounts) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  fill(catalog, {{{20, 5, 2, circular}, 30, 20},
                 {{40, 5, 2, circular}, 30, 20},
                 {{41, 6, 2, circular}, 30, 10}});  // fixed from the second
  WeakestFirst cells(catalog, {.k_to = 5});
  EXPECT_EQ(pass(cells).front(), (Parameters{40, 5, 2, circular}));
}

TEST(WeakestFirst, AFindMakesNeighboursBetter) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  const Parameters found{20, 5, 1, circular};
  fill(catalog, {{found, 30, 20},
                 {{20, 5, 1, linear}, 30, 20},    // cut
                 {{19, 5, 1, linear}, 29, 25},    // truncated
                 {{18, 5, 1, linear}, 24, 20},    // better already
                 {{21, 6, 1, circular}, 40, 24},  // fixed
                 {{22, 7, 1, circular}, 40, 28},  // out of reach: no design has 26 blocks
                 {{40, 10, 2, circular}, 31, 9},  // blown up
                 {{60, 15, 3, linear}, 32, 9}});  // blown up and cut
  WeakestFirst cells(catalog, {});
  cells.begin_pass();
  cells.improved(found, 26);
  const std::map<Parameters, std::uint64_t> expected = {{found, 26},
                                                        {{20, 5, 1, linear}, 26},
                                                        {{19, 5, 1, linear}, 26},
                                                        {{18, 5, 1, linear}, 24},
                                                        {{21, 6, 1, circular}, 26},
                                                        {{22, 7, 1, circular}, 40},
                                                        {{40, 10, 2, circular}, 26},
                                                        {{60, 15, 3, linear}, 26}};
  for (const auto& [p, b] : expected) {
    EXPECT_EQ(cells.known(p), b) << name(p);
  }
  cells.improved(found, 20);
  EXPECT_EQ(cells.known({19, 5, 1, linear}), 26U);  // 25 at least
  const std::vector<Parameters> order = pass(cells);
  EXPECT_EQ(std::ranges::count(order, found), 0);  // It is at its bound.
}

TEST(WeakestFirst, StrengthThreeIsAloneWithItself) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  const Parameters p{7, 4, 1, circular, 3};
  Parameters cut = p;
  cut.kind = linear;
  fill(catalog, {{p, 20, 10}, {cut, 20, 10}});
  WeakestFirst cells(catalog, {});
  cells.improved(p, 15);
  EXPECT_EQ(cells.known(p), 15U);
  EXPECT_EQ(cells.known(cut), 20U);
}

}  // namespace
}  // namespace changeover::test::weakest_test
