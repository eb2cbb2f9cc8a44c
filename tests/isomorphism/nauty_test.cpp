// A second library's opinion: nauty on a directed graph, where the order of blocks is a path or a
// circle of arrows, against sorting columns.
#include <gtest/gtest.h>

#include "changeover/isomorphism/isomorphism.hpp"
#include "sample_designs.hpp"

// nauty.h is C; C++ spells this keyword differently.
#define _Thread_local thread_local
#include <nauty/nautinv.h>
#include <nauty/nauty.h>
#undef _Thread_local

namespace changeover::test::nauty_test {
namespace {

struct Opinion {
  std::vector<graph> canonical;
  double group_order = 0;
};

// Elements 0, …, v−1, then blocks; edges both ways between a block and its elements, an arrow from
// each block to the next.
Opinion ask_nauty(const Design& design) {
  const int v = static_cast<int>(design.v());
  const int b = static_cast<int>(design.block_count());
  const int n = v + b;
  const int words = SETWORDSNEEDED(n);
  const auto size = static_cast<std::size_t>(words) * static_cast<std::size_t>(n);
  std::vector<graph> arrows(size, 0);
  Opinion opinion{.canonical = std::vector<graph>(size, 0)};
  const auto row = [&](int vertex) { return arrows.data() + std::ptrdiff_t{words} * vertex; };
  for (int i = 0; i < b; ++i) {
    for (const Element x : design.block(static_cast<std::size_t>(i))) {
      ADDELEMENT(row(v + i), static_cast<int>(x));
      ADDELEMENT(row(static_cast<int>(x)), v + i);
    }
    if (i + 1 < b || design.parameters().kind == Kind::circular) {
      ADDELEMENT(row(v + i), v + (i + 1) % b);
    }
  }
  const auto places = static_cast<std::size_t>(n);
  std::vector<int> labels(places);
  std::vector<int> cells(places, 1);
  std::vector<int> orbits(places);
  std::iota(labels.begin(), labels.end(), 0);
  cells[static_cast<std::size_t>(v) - 1] =
      0;  // the cell of elements ends, the cell of blocks begins
  cells.back() = 0;
  DEFAULTOPTIONS_DIGRAPH(options);
  options.getcanon = TRUE;
  options.defaultptn = FALSE;
  statsblk stats;
  densenauty(arrows.data(), labels.data(), cells.data(), orbits.data(), &options, &stats, words, n,
             opinion.canonical.data());
  opinion.group_order = stats.grpsize1;
  for (int i = 0; i < stats.grpsize2; ++i) {
    opinion.group_order *= 10;
  }
  return opinion;
}

TEST(Nauty, AgreesOnWhichDesignsAreTheSameAndOnGroups) {
  Generator random(9);
  int same = 0;
  for (int round = 0; round < 400; ++round) {
    const Kind kind = below(random, 2) == 0 ? Kind::linear : Kind::circular;
    const std::size_t v = 3 + below(random, 8);
    const std::size_t k = 2 + below(random, v - 2);
    const Design one = random_blocks(random, v, k, 3 + below(random, 10), kind);
    const Design other =
        below(random, 2) == 0 ? image(random_map(random, one, false), one) : mutated(random, one);
    const Opinion a = ask_nauty(one);
    const Opinion c = ask_nauty(other);
    const bool ours = find_isomorphism(one, other).has_value();
    EXPECT_EQ(a.canonical == c.canonical, ours);
    EXPECT_EQ(a.group_order, std::stod(automorphisms(one).order));
    same += ours ? 1 : 0;
  }
  EXPECT_GT(same, 100);
  EXPECT_LT(same, 300);
}

TEST(Nauty, AgreesOnDesignsWithSymmetry) {
  for (const Block& base : {Block{0, 1, 2, 5}, Block{0, 1, 2, 3}, Block{0, 2, 3, 7}}) {
    const Design design = developed(11, 2, base);
    EXPECT_EQ(ask_nauty(design).group_order, std::stod(automorphisms(design).order));
  }
}

}  // namespace
}  // namespace changeover::test::nauty_test
