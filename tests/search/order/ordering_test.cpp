#include "changeover/search/local_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"
#include "run/random.hpp"

namespace changeover::ordering_test {
namespace {

using Order = std::vector<std::size_t>;

std::vector<Block> developed(const std::vector<Block>& base, Element v) {
  std::vector<Block> blocks;
  for (const Block& block : base) {
    for (Element shift = 0; shift < v; ++shift) {
      Block moved;
      for (const Element x : block) {
        moved.push_back((x + shift) % v);
      }
      blocks.push_back(moved);
    }
  }
  return blocks;
}

const std::vector<Block> fano = developed({{0, 1, 3}}, 7);
const std::vector<Block> sts13 = developed({{0, 1, 4}, {0, 2, 7}}, 13);

std::vector<Block> sts9() {
  std::vector<Block> lines;
  for (Element i = 0; i < 3; ++i) {
    lines.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    for (Element slope = 0; slope < 3; ++slope) {
      lines.push_back({i, 3 + (i + slope) % 3, 6 + (i + 2 * slope) % 3});
    }
  }
  return lines;
}

std::vector<Block> shuffled(std::vector<Block> blocks, Random& random) {
  for (std::size_t i = blocks.size(); i > 1; --i) {
    std::swap(blocks[i - 1], blocks[random.below(static_cast<std::uint32_t>(i))]);
  }
  return blocks;
}

Block random_subset(std::uint32_t v, std::size_t k, Random& random) {
  std::set<Element> chosen;
  while (chosen.size() < k) {
    chosen.insert(random.below(v));
  }
  return {chosen.begin(), chosen.end()};
}

// So many, each of `least` elements or up to `spread` − 1 more.
std::vector<Block> random_subsets(std::size_t count, std::uint32_t v, std::size_t least,
                                  std::uint32_t spread, Random& random) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = least + (spread == 0 ? 0 : random.below(spread));
    blocks.push_back(random_subset(v, size, random));
  }
  return blocks;
}

std::size_t common(const Block& a, const Block& b) {
  return static_cast<std::size_t>(std::count_if(
      a.begin(), a.end(), [&](Element x) { return std::find(b.begin(), b.end(), x) != b.end(); }));
}

ChangeOrder ordered(const std::vector<Block>& blocks, const ChangeWanted& wanted,
                    const ChangeOrderOptions& options = {}) {
  RunControl control({});
  return order_for_change(blocks, wanted, options, control);
}

LeastChangeOrder ordered(const std::vector<Block>& blocks, const LeastChangeWanted& wanted,
                         const LeastChangeOptions& options = {}) {
  RunControl control({});
  return order_for_least_change(blocks, wanted, options, control);
}

bool changes_as_wanted(const std::vector<Block>& list, const ChangeWanted& wanted) {
  const std::size_t b = list.size();
  for (std::size_t i = 0; i + 1 < b + (wanted.kind == Kind::circular && b > 1 ? 1U : 0U); ++i) {
    if (common(list[i], list[(i + 1) % b]) + wanted.m != list[i].size()) {
      return false;
    }
  }
  return true;
}

bool some_permutation_changes(const std::vector<Block>& blocks, const ChangeWanted& wanted) {
  Order order(blocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    if (changes_as_wanted(arranged(blocks, order), wanted)) {
      return true;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return false;
}

std::uint64_t naive_cost(const std::vector<Block>& list, const LeastChangeWanted& wanted) {
  std::uint64_t cost = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) {
      cost += list[i].size() - common(list[i - 1], list[i]);
    } else if (wanted.kind == Kind::circular) {
      cost += list[0].size() - common(list.back(), list[0]);
    } else if (wanted.first_counts) {
      cost += list[0].size();
    }
  }
  return cost;
}

std::uint64_t least_cost(const std::vector<Block>& blocks, const LeastChangeWanted& wanted) {
  Order order(blocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::uint64_t least = ~std::uint64_t{0};
  do {
    least = std::min(least, naive_cost(arranged(blocks, order), wanted));
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

const std::vector<LeastChangeWanted> all_kinds(std::uint64_t v) {
  return {{v, Kind::linear, true}, {v, Kind::linear, false}, {v, Kind::circular, true}};
}

// ---- For a number of changes.

TEST(OrderForChange, AgreesWithTryingAllPermutations) {
  Random random(1);
  std::size_t found = 0;
  std::size_t none = 0;
  std::size_t by_solver = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::uint32_t v = 5 + random.below(4);
    const std::size_t k = 2 + random.below(3);
    const std::size_t b = 1 + random.below(7);
    const std::vector<Block> blocks =
        random_subsets(b, v, std::min<std::size_t>(k, v - 1), 0, random);
    const ChangeWanted wanted{v, 1 + random.below(2),
                              random.one_in_two() ? Kind::linear : Kind::circular};
    const ChangeOrder order = ordered(blocks, wanted, {.rotations = 100});
    ASSERT_NE(order.outcome, Outcome::unknown);
    ASSERT_EQ(order.outcome == Outcome::found, some_permutation_changes(blocks, wanted));
    if (order.outcome == Outcome::found) {
      ++found;
      EXPECT_TRUE(changes_as_wanted(arranged(blocks, order.order), wanted));
      EXPECT_EQ(order.why_stopped, WhyStopped::found);
    } else {
      ++none;
      EXPECT_FALSE(order.reason.empty());
      EXPECT_EQ(order.why_stopped, WhyStopped::exhausted);
      by_solver += order.reason.find("SAT solver") != std::string::npos ? 1U : 0U;
    }
  }
  EXPECT_GE(found, 30U);
  EXPECT_GE(none, 30U);
  EXPECT_GE(by_solver, 5U);
}

TEST(OrderForChange, AnyOrderOfTheFanoPlaneIsDoubleChange) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const ChangeOrder order = ordered(fano, {7, 2, kind});
    ASSERT_EQ(order.outcome, Outcome::found);
    EXPECT_EQ(order.rotations, 0U);
    const Design design({7, 3, 2, kind, 2}, arranged(fano, order.order));
    EXPECT_TRUE(verify(design).valid());
  }
  EXPECT_EQ(ordered(fano, {7, 1, Kind::linear}).outcome, Outcome::none);
}

TEST(OrderForChange, OrdersSteinerTripleSystemsForDoubleChange) {
  for (const auto& [blocks, v] : {std::pair(sts9(), 9U), std::pair(sts13, 13U)}) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const ChangeOrder order = ordered(blocks, {v, 2, kind});
      ASSERT_EQ(order.outcome, Outcome::found);
      EXPECT_TRUE(verify(Design({v, 3, 2, kind, 2}, arranged(blocks, order.order))).tight() ||
                  kind == Kind::linear);
      EXPECT_TRUE(verify(Design({v, 3, 2, kind, 2}, arranged(blocks, order.order))).valid());
    }
  }
}

TEST(OrderForChange, OrdersDisjointTriplesOfSts13ButNotOfSts9) {
  EXPECT_EQ(ordered(sts13, {13, 3, Kind::circular}).outcome, Outcome::found);
  // Each line of the plane of order 3 misses only its two parallels: four triangles.
  const ChangeOrder order = ordered(sts9(), {9, 3, Kind::linear});
  EXPECT_EQ(order.outcome, Outcome::none);
  EXPECT_NE(order.reason.find("is not reached"), std::string::npos);
}

TEST(OrderForChange, NoneIsSaidBySatAndByAllPermutationsAlike) {
  // Differences of single changes: a star with three long arms has a spanning path of neither kind.
  const std::vector<Block> spider{{0, 1}, {1, 2}, {2, 3}, {1, 4}, {4, 5}, {1, 6}, {6, 7}};
  const std::vector<Block> claw{{0, 9}, {0, 1}, {1, 2}, {3, 9}, {3, 4}, {5, 9}, {5, 6}};
  for (const std::vector<Block>& blocks : {spider, claw}) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const ChangeWanted wanted{10, 1, kind};
      const bool exists = some_permutation_changes(blocks, wanted);
      EXPECT_EQ(ordered(blocks, wanted, {.rotations = 1000}).outcome,
                exists ? Outcome::found : Outcome::none);
    }
  }
  // A bipartite graph with sides of 3 and 5, all degrees at least 3: no cheap argument, none all
  // the same.
  const std::vector<Block> pairs{{0, 3}, {1, 3}, {2, 3}, {0, 4}, {1, 4}, {2, 4}, {0, 5}};
  const ChangeWanted wanted{6, 2, Kind::circular};
  const ChangeOrder order = ordered(pairs, wanted, {.rotations = 1000});
  EXPECT_EQ(order.outcome,
            some_permutation_changes(pairs, wanted) ? Outcome::found : Outcome::none);
}

TEST(OrderForChange, FindsItsWayThroughAShuffledDesign) {
  Random random(5);
  const Design design = Registry::standard().build_design(
      Registry::standard().best({61, 4, 2, Kind::circular, 2})->recipe);
  const ChangeOrder order = ordered(shuffled(design.blocks(), random), {61, 2, Kind::linear});
  EXPECT_NE(order.outcome, Outcome::none);
  const ChangeOrder three = ordered(shuffled(design.blocks(), random), {61, 3, Kind::circular});
  EXPECT_EQ(three.outcome, Outcome::found);
}

TEST(OrderForChange, IsDeterministicAndStops) {
  EXPECT_EQ(ordered(sts13, {13, 3, Kind::circular}).order,
            ordered(sts13, {13, 3, Kind::circular}).order);
  RunControl control({.time = std::chrono::seconds(0)});
  const ChangeOrder order = order_for_change(sts13, {13, 3, Kind::circular}, {}, control);
  EXPECT_EQ(order.outcome, Outcome::unknown);
  EXPECT_EQ(order.why_stopped, WhyStopped::time_limit);
}

TEST(OrderForChange, TakesOneAndTwoBlocks) {
  EXPECT_EQ(ordered({{0, 1}}, ChangeWanted{2, 1, Kind::circular}).order, Order{0});
  EXPECT_EQ(ordered({{0, 1}, {0, 2}}, ChangeWanted{3, 1, Kind::circular}).outcome, Outcome::found);
  EXPECT_EQ(ordered({{0, 1}, {0, 1}}, ChangeWanted{3, 1, Kind::linear}).outcome, Outcome::none);
}

TEST(OrderForChange, RefusesMalformedBlocks) {
  const ChangeWanted wanted{5, 1, Kind::linear};
  EXPECT_REFUSAL((void)ordered({}, wanted), BadInput, "there are no blocks to order");
  EXPECT_REFUSAL((void)ordered({{0, 1}, {0, 1, 2}}, wanted), BadInput,
                 "block 2 has 3 elements and block 1 has 2; all need the same");
  EXPECT_REFUSAL((void)ordered({{0, 5}}, wanted), BadInput,
                 "block 1 has the element 5, which is not below v = 5");
  EXPECT_REFUSAL((void)ordered({{1, 1}}, wanted), BadInput, "block 1 has the element 1 twice");
  EXPECT_REFUSAL((void)ordered({{0, 1}}, ChangeWanted{5, 0, Kind::linear}), ImpossibleParameters,
                 "consecutive blocks must differ; give a change number of at least 1");
}

// ---- For the least total change.

TEST(OrderForLeastChange, AgreesWithTryingAllPermutations) {
  Random random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const std::uint32_t v = 6 + random.below(6);
    const std::size_t b = 1 + random.below(7);
    const std::vector<Block> blocks = random_subsets(b, v, 0, 5, random);
    for (const LeastChangeWanted& wanted : all_kinds(v)) {
      const LeastChangeOrder order = ordered(blocks, wanted);
      EXPECT_EQ(order.cost, least_cost(blocks, wanted));
      EXPECT_EQ(order.cost, naive_cost(arranged(blocks, order.order), wanted));
      EXPECT_TRUE(order.least());
    }
  }
}

TEST(OrderForLeastChange, LocalSearchIsNeverBelowTheLeastAndMostlyThere) {
  Random random(3);
  std::uint64_t missed = 0;
  std::uint64_t proved = 0;
  std::uint64_t trials = 0;
  for (int trial = 0; trial < 25; ++trial) {
    const std::size_t b = 9 + random.below(5);
    const std::vector<Block> blocks = random_subsets(b, 16, 2, 6, random);
    for (const LeastChangeWanted& wanted : all_kinds(16)) {
      const LeastChangeOrder exact = ordered(blocks, wanted);
      const LeastChangeOrder searched = ordered(blocks, wanted, {.exact_blocks = 0});
      EXPECT_EQ(searched.cost, naive_cost(arranged(blocks, searched.order), wanted));
      ASSERT_GE(searched.cost, exact.cost);
      ASSERT_LE(searched.lower_bound, exact.cost);
      ++trials;
      missed += searched.cost > exact.cost ? 1U : 0U;
      proved += searched.least() ? 1U : 0U;
    }
  }
  EXPECT_LE(missed, trials / 20);
  EXPECT_GE(proved, trials / 3);
}

TEST(OrderForLeastChange, BoundsStayBelowTheLeastForTinyCases) {
  Random random(4);
  for (int trial = 0; trial < 40; ++trial) {
    const std::vector<Block> blocks = random_subsets(9, 12, 0, 7, random);
    for (const LeastChangeWanted& wanted : all_kinds(12)) {
      const LeastChangeOrder exact = ordered(blocks, wanted);
      for (const std::uint64_t effort : {0U, 50U, 1000U, 100'000U}) {
        const LeastChangeOrder searched =
            ordered(blocks, wanted, {.exact_blocks = 0, .kicks = 0, .bound_effort = effort});
        ASSERT_LE(searched.lower_bound, exact.cost);
        ASSERT_GE(searched.cost, exact.cost);
      }
    }
  }
}

TEST(OrderForLeastChange, PutsAShuffledSlidingWindowBack) {
  Random random(6);
  std::vector<Block> windows;
  for (Element i = 0; i < 400; ++i) {
    windows.push_back({i, i + 1, i + 2, i + 3, i + 4});
  }
  const LeastChangeOrder order = ordered(shuffled(windows, random), LeastChangeWanted{404});
  EXPECT_EQ(order.cost, 404U);
  EXPECT_EQ(order.lower_bound, 404U);
  EXPECT_EQ(order.why_stopped, WhyStopped::exhausted);
  EXPECT_GT(order.first_cost, 1900U);
}

TEST(OrderForLeastChange, BeginsWithALargeBlockIfThatIsFree) {
  const std::vector<Block> blocks{{0}, {0, 1, 2, 3, 4, 5}, {7}};
  const LeastChangeOrder order = ordered(blocks, {8, Kind::linear, false});
  EXPECT_EQ(order.order.front(), 1U);
  EXPECT_EQ(order.cost, 1U);
  EXPECT_EQ(ordered(blocks, {8, Kind::linear, true}).cost, 7U);
}

TEST(OrderForLeastChange, TakesRepeatedAndEmptyBlocks) {
  std::vector<Block> blocks(30, Block{1, 2, 3});
  blocks.insert(blocks.begin() + 7, 5, Block{});
  const LeastChangeOrder order = ordered(blocks, LeastChangeWanted{4});
  EXPECT_EQ(order.cost, 3U);
  EXPECT_EQ(ordered({{}}, LeastChangeWanted{1}).cost, 0U);
  EXPECT_EQ(ordered({{0}}, {1, Kind::circular, true}).cost, 0U);
}

TEST(OrderForLeastChange, OrdersADesignNoWorseThanTheDesignDoes) {
  Random random(8);
  const Parameters p{25, 4, 2, Kind::circular, 2};
  const Design design = Registry::standard().build_design(Registry::standard().best(p)->recipe);
  const LeastChangeOrder order =
      ordered(shuffled(design.blocks(), random), {p.v, Kind::circular, true}, {.kicks = 20'000});
  const std::size_t b = design.block_count();
  EXPECT_LE(order.cost, 2 * b + b / 10);
  EXPECT_LE(order.lower_bound, 2 * b);
}

TEST(OrderForLeastChange, IsDeterministicAndStops) {
  Random random(9);
  const std::vector<Block> blocks = random_subsets(200, 40, 6, 0, random);
  const LeastChangeOrder once = ordered(blocks, LeastChangeWanted{40});
  const LeastChangeOrder again = ordered(blocks, LeastChangeWanted{40});
  EXPECT_EQ(once.order, again.order);
  EXPECT_EQ(once.lower_bound, again.lower_bound);
  EXPECT_EQ(once.kicks, 10'000U);
  RunControl control({.time = std::chrono::seconds(0)});
  const LeastChangeOrder stopped =
      order_for_least_change(blocks, LeastChangeWanted{40}, {}, control);
  EXPECT_EQ(stopped.why_stopped, WhyStopped::time_limit);
  EXPECT_LE(stopped.lower_bound, once.cost);
}

RC_GTEST_PROP(OrderForLeastChange, CostsWhatARecountSays, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto b = *rc::gen::inRange<std::size_t>(1, 80);
  const auto v = *rc::gen::inRange<std::uint32_t>(8, 100);
  const std::vector<Block> blocks = random_subsets(b, v, 0, 8, random);
  for (const LeastChangeWanted& wanted : all_kinds(v)) {
    const LeastChangeOrder order = ordered(blocks, wanted, {.kicks = 300});
    RC_ASSERT(order.cost == naive_cost(arranged(blocks, order.order), wanted));
    RC_ASSERT(order.cost <= order.first_cost);
    RC_ASSERT(order.lower_bound <= order.cost);
  }
}

TEST(OrderForLeastChange, RefusesMalformedInput) {
  EXPECT_REFUSAL((void)ordered({}, LeastChangeWanted{5}), BadInput, "there are no blocks to order");
  EXPECT_THROW((void)ordered({{0, 5}}, LeastChangeWanted{5}), BadInput);
  EXPECT_REFUSAL((void)ordered({{1, 1}}, LeastChangeWanted{5}), BadInput,
                 "block 1 has the element 1 twice");
  const std::vector<Block> two{{0}, {1}};
  EXPECT_REFUSAL((void)change_cost(two, Order{0, 0}, {2}), BadInput,
                 "an order must name each block exactly once");
  EXPECT_REFUSAL((void)change_cost(two, Order{0}, {2}), BadInput,
                 "an order must name each block exactly once");
  EXPECT_REFUSAL((void)change_cost(two, Order{0, 2}, {2}), BadInput,
                 "an order must name each block exactly once");
  EXPECT_REFUSAL((void)arranged(two, Order{2}), BadInput, "there is no block 3 among 2");
  RunControl control({});
  const std::vector<Block> many(10'000, Block{0});
  EXPECT_REFUSAL((void)order_for_least_change(many, {std::uint64_t{1} << 32}, {}, control),
                 MissingResource,
                 "10000 blocks on 4294967296 elements need more than 4 GiB as bit sets");
}

TEST(OrderForLeastChange, SlowOrdersTwentyThousandBlocks) {
  Random random(10);
  const std::vector<Block> blocks = random_subsets(20'000, 300, 10, 0, random);
  const LeastChangeOrder order = ordered(blocks, LeastChangeWanted{300}, {.kicks = 200'000});
  EXPECT_LT(order.cost, order.first_cost * 3 / 4);
  EXPECT_GT(order.lower_bound, order.cost / 2);
}

}  // namespace
}  // namespace changeover::ordering_test
