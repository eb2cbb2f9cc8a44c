// The families that serve one block size and every v from some number on: pairs, triples and
// quadruples.
#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover::one_block_size_test {
namespace {

using namespace test;

using Holds = bool (*)(const Parameters& p);

bool always(const Parameters&) { return true; }
bool never(const Parameters&) { return false; }
bool is_circular(const Parameters& p) { return p.kind == Kind::circular; }

struct Served {
  const char* entry;
  std::uint64_t k, change;
  std::uint64_t least_v;
  std::uint64_t built_up_to;           ///< everything that is promised is checked
  std::uint64_t read_up_to;            ///< the verdict is
  std::vector<std::uint64_t> large;    ///< and here
  std::vector<std::uint64_t> largest;  ///< not built
  std::size_t known_minima;            ///< rows of tests/data/minimum.csv
  Holds tight, economical, expansion_set;
  Holds at_the_bound;  ///< b is the lower bound

  [[nodiscard]] Parameters at(std::uint64_t v, Kind kind) const { return {v, k, change, kind, 2}; }
};

std::ostream& operator<<(std::ostream& out, const Served& served) { return out << served.entry; }

bool not_the_closed_walk_of_5(const Parameters& p) { return p.v != 5 || !is_circular(p); }

bool has_the_counting_bound(const Parameters& p) {
  return is_circular(p) ? p.v >= 6 : p.v == 5 || p.v == 8 || p.v >= 11;
}

const std::vector<Served> families{
    {"pairs-double-change",
     2,
     2,
     5,
     80,
     300,
     {1000, 1001},
     {0xffff'ffff},
     8,
     not_the_closed_walk_of_5,
     not_the_closed_walk_of_5,
     never,
     not_the_closed_walk_of_5},
    {"pairs-single-change",
     2,
     1,
     3,
     80,
     300,
     {1000, 1001},
     {0xffff'ffff},
     12,
     always,
     always,
     [](const Parameters& p) { return p.v <= 1 << 20; },
     always},
    {"triples-double-change",
     3,
     2,
     5,
     120,
     420,
     {2000, 2001, 2002, 2003, 2004, 2005},
     {0xffff'ffff},
     22,
     [](const Parameters& p) { return p.v % 6 == 1 || p.v % 6 == 3; },
     // ⌈v/3·⌈(v−1)/2⌉⌉ triples cover all pairs, and no fewer.
     [](const Parameters& p) {
       return p.v != 5 && (p.v * (p.v / 2) + 2) / 3 == (p.v * (p.v - 1) / 2 + 2) / 3;
     },
     never,
     [](const Parameters& p) { return p.v != 5; }},
    {"triples-triple-change",
     3,
     3,
     10,
     90,
     200,
     {600, 601},
     {2000},
     0,
     [](const Parameters& p) { return p.v % 6 == 1 || p.v % 6 == 3; },
     [](const Parameters& p) { return (p.v * (p.v / 2) + 2) / 3 == (p.v * (p.v - 1) / 2 + 2) / 3; },
     never,
     always},
    {"triples-single-change",
     3,
     1,
     4,
     100,
     400,
     {1500, 1501, 1502, 1503},
     {0xffff'fffc, 0xffff'fffd, 0xffff'fffe, 0xffff'ffff},
     18,
     [](const Parameters& p) { return (p.v / 2 % 2 == 0) == is_circular(p); },
     always,
     [](const Parameters& p) { return p.v % 2 == 0 && p.v >= 6 && p.v <= 1 << 20; },
     always},
    {"quadruples-single-change",
     4,
     1,
     5,
     100,
     400,
     {1500, 1501, 1502, 1503, 1504, 1505},
     {0xffff'fffa, 0xffff'fffb, 0xffff'fffc, 0xffff'fffd, 0xffff'fffe, 0xffff'ffff},
     16,
     [](const Parameters& p) { return p.v % 3 != 2 && has_the_counting_bound(p); },
     has_the_counting_bound,
     [](const Parameters& p) {
       return p.v % 3 == 0 && (p.v >= 12 || (is_circular(p) && p.v == 9)) && p.v <= 1 << 20;
     },
     [](const Parameters& p) { return has_the_counting_bound(p) || p.v == 5; }},
};

class OneBlockSize : public testing::TestWithParam<Served> {
 protected:
  const Served& served = GetParam();

  /// The offer, whose promise is the one above.
  [[nodiscard]] Offer offer(const Parameters& p) const {
    const auto offer = offer_of(served.entry, p);
    if (!offer) {
      ADD_FAILURE() << name(p) << " is not served";
      return {};
    }
    EXPECT_EQ(offer->tight, served.tight(p)) << name(p);
    EXPECT_EQ(offer->expansion_set, served.expansion_set(p)) << name(p);
    EXPECT_EQ(offer->economical, served.economical(p)) << name(p);
    if (served.at_the_bound(p)) {
      EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
    }
    return *offer;
  }

  void expect_verdict(const Parameters& p) const {
    const Offer made = offer(p);
    const Verdict verdict = verify(*standard().build(made.recipe));
    EXPECT_TRUE(verdict.valid()) << name(p);
    EXPECT_EQ(verdict.b, made.b) << name(p);
    EXPECT_EQ(verdict.tight(), made.tight) << name(p);
    EXPECT_EQ(verdict.economical(), made.economical) << name(p);
  }
};

TEST_P(OneBlockSize, IsAsPromisedForEveryV) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = served.least_v; v <= served.built_up_to; ++v) {
      expect_as_promised(offer(served.at(v, kind)));
    }
    for (std::uint64_t v = served.built_up_to + 1; v <= served.read_up_to; ++v) {
      expect_verdict(served.at(v, kind));
    }
    for (const std::uint64_t v : served.large) {
      expect_verdict(served.at(v, kind));
    }
  }
}

TEST_P(OneBlockSize, AttainsTheKnownMinima) {
  std::size_t rows = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (row.parameters.k == served.k && row.parameters.change == served.change &&
        row.parameters.v >= served.least_v) {
      ++rows;
      EXPECT_EQ(offer(row.parameters).b, row.b) << name(row.parameters);
    }
  }
  EXPECT_EQ(rows, served.known_minima);
}

TEST_P(OneBlockSize, CanRewindAnywhere) {
  for (std::uint64_t v = 12; v < 18; ++v) {
    const auto source = standard().build(offer(served.at(v, Kind::circular)).recipe);
    const std::vector<Block> all = blocks_of(*source);
    expect_blocks_however_often(*source, all);
  }
}

TEST_P(OneBlockSize, ServesNothingElse) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    std::vector<Parameters> others{{7, served.k + 1, served.change, kind, 2},
                                   {7, served.k, 3 - served.change, kind, 2},
                                   {7, served.k, served.change, kind, 3}};
    for (std::uint64_t v = 0; v < served.least_v; ++v) {
      others.push_back(served.at(v, kind));
    }
    for (const Parameters& p : others) {
      EXPECT_FALSE(offer_of(served.entry, p)) << name(p);
      expect_refused({served.entry, p, {}, {}, {}}, "not served");
    }
  }
}

TEST_P(OneBlockSize, PromisesTheLargestWithoutBuilding) {
  for (const std::uint64_t v : served.largest) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const Offer largest = offer(served.at(v, kind));
      EXPECT_EQ(standard().build(largest.recipe)->block_count(), largest.b);
    }
  }
}

TEST_P(OneBlockSize, RefusesSpoiltRecipes) {
  for (const std::uint64_t v :
       {served.least_v, served.least_v + 1, std::uint64_t{11}, std::uint64_t{18}}) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      Recipe recipe = offer(served.at(v, kind)).recipe;
      expect_spoilt_recipes_refused(recipe, {.any_v = true, .any_kind = true});
      recipe.inputs.push_back(recipe);
      EXPECT_THROW((void)construction(served.entry).explain(recipe), BadInput);
      if (construction(served.entry).expansion_set(offer(served.at(12, kind)).recipe, standard())) {
        EXPECT_THROW((void)construction(served.entry).expansion_set(recipe, standard()), BadInput);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, OneBlockSize, testing::ValuesIn(families), [](const auto& one) {
  std::string name = one.param.entry;
  std::erase(name, '-');
  return name;
});

// What is special to one of them.

Recipe recipe_of(const char* entry, std::uint64_t v, std::uint64_t k, std::uint64_t change,
                 Kind kind = Kind::linear) {
  return offer_of(entry, {v, k, change, kind, 2})->recipe;
}

std::vector<Block> blocks_made(const Recipe& recipe) {
  return standard().build_design(recipe).blocks();
}

std::string explained(const Recipe& recipe) {
  return construction(recipe.construction).explain(recipe);
}

TEST(PairsDoubleChange, ListsFactorAfterFactor) {
  EXPECT_EQ(blocks_made(recipe_of("pairs-double-change", 6, 2, 2)), (std::vector<Block>{{3, 2},
                                                                                        {4, 1},
                                                                                        {0, 5},
                                                                                        {4, 3},
                                                                                        {0, 2},
                                                                                        {1, 5},
                                                                                        {0, 4},
                                                                                        {1, 3},
                                                                                        {2, 5},
                                                                                        {1, 0},
                                                                                        {2, 4},
                                                                                        {3, 5},
                                                                                        {2, 1},
                                                                                        {3, 0},
                                                                                        {4, 5}}));
  const std::vector<Block> nine = blocks_made(recipe_of("pairs-double-change", 9, 2, 2));
  EXPECT_EQ(nine[0], (Block{8, 1}));
  EXPECT_EQ(nine[3], (Block{6, 3}));
  EXPECT_EQ(nine[4], (Block{0, 2}));
}

TEST(PairsSingleChange, ListsVertexAfterVertex) {
  EXPECT_EQ(blocks_made(recipe_of("pairs-single-change", 5, 2, 1)),
            (std::vector<Block>{
                {0, 4}, {0, 1}, {0, 2}, {0, 3}, {1, 3}, {1, 2}, {1, 4}, {2, 4}, {2, 3}, {3, 4}}));
}

TEST(PairsSingleChange, HasAnExpansionSetWhileItsListIsShort) {
  EXPECT_TRUE(offer_of("pairs-single-change", {1 << 20, 2, 1, Kind::linear, 2})->expansion_set);
  const Recipe larger = recipe_of("pairs-single-change", (1 << 20) + 1, 2, 1);
  EXPECT_FALSE(construction("pairs-single-change").expansion_set(larger, standard()));
}

TEST(TriplesDoubleChange, HasTheExcessThatParityForces) {
  for (std::uint64_t v = 12; v <= 40; ++v) {
    const Recipe recipe = recipe_of("triples-double-change", v, 3, 2, Kind::circular);
    const std::uint64_t expected = v % 2 == 1 ? (v % 6 == 5 ? 2 : 0) : v / 2 + (v % 6 == 0 ? 0 : 1);
    EXPECT_EQ(verify(*standard().build(recipe)).excess, expected) << v;
  }
}

TEST(DoubleChange, BeginsTheLargest) {
  const std::uint64_t v = 0xffff'ffff;  // 3 modulo 6
  Block pair(2);
  ASSERT_TRUE(standard().build(recipe_of("pairs-double-change", v, 2, 2))->next(pair));
  EXPECT_EQ(pair, (Block{0xffff'fffe, 1}));
  Block triple(3);
  ASSERT_TRUE(standard().build(recipe_of("triples-double-change", v, 3, 2))->next(triple));
  EXPECT_EQ(triple, (Block{0, 2, static_cast<Element>(v / 3 + 1)}));
}

TEST(OneBlockSizeFamilies, ExplainThemselves) {
  EXPECT_EQ(explained(recipe_of("pairs-double-change", 6, 2, 2)),
            "For i = 0,…,4, the edges {i-j,i+j} over Z_5, j = 2,…,1, and {i,5}.");
  EXPECT_EQ(explained(recipe_of("pairs-double-change", 9, 2, 2)),
            "For i = 0,…,8, the edges {i-j,i+j} over Z_9, j = 1,…,4 with 3 last.");
  EXPECT_NE(explained(recipe_of("pairs-double-change", 5, 2, 2)),
            explained(recipe_of("pairs-double-change", 5, 2, 2, Kind::circular)));
  EXPECT_EQ(explained(recipe_of("pairs-single-change", 9, 2, 1)),
            "For x = 0,…,7, the edges {x,y} with y > x; y = 8 comes first and y = 7 last if x is "
            "even, the other way round if x is odd.");
  const auto triples = [](std::uint64_t v) {
    return explained(recipe_of("triples-double-change", v, 3, 2, Kind::circular));
  };
  EXPECT_EQ(triples(9), "A list of 12 triples.");
  EXPECT_EQ(triples(21),
            "Take Bose's Steiner triple system on Z_7 x Z_3, go round Z_n x Z_3 level by level, "
            "and list at each point triples that contain it.");
  EXPECT_NE(triples(22).find("Then add 21 with 11 pairs"), std::string::npos);
  EXPECT_NE(triples(18).find("excess 9 on Z_6"), std::string::npos);
  EXPECT_NE(triples(19).find("Skolem's"), std::string::npos);
  EXPECT_NE(triples(17).find("excess 2 on Z_5"), std::string::npos);
  EXPECT_EQ(explained(recipe_of("triples-single-change", 8, 3, 1)), "A list of 14 blocks.");
  EXPECT_EQ(explained(recipe_of("triples-single-change", 12, 3, 1)),
            "Extend a listed linear SCCD(8,3) of 14 blocks once by 4 elements: two sets of 2 new "
            "elements are held beside almost every old one.");
  EXPECT_NE(
      explained(recipe_of("triples-single-change", 17, 3, 1)).find("SCCD(5,3) of 5 blocks 3 times"),
      std::string::npos);
  EXPECT_EQ(explained(recipe_of("quadruples-single-change", 8, 4, 1)), "A list of 9 blocks.");
  EXPECT_EQ(explained(recipe_of("quadruples-single-change", 18, 4, 1)),
            "Extend a listed linear SCCD(12,4) of 21 blocks once by 6 elements: two sets of 3 new "
            "elements are held beside almost every old one.");
  EXPECT_NE(explained(recipe_of("quadruples-single-change", 29, 4, 1))
                .find("SCCD(11,4) of 18 blocks 3 times"),
            std::string::npos);
}

}  // namespace
}  // namespace changeover::one_block_size_test
