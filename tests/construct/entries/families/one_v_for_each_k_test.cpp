// The circular families that serve one v for each block size k.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "construction_checks.hpp"

namespace changeover::one_v_for_each_k_test {
namespace {

using namespace test;

struct Served {
  const char* entry;
  std::uint64_t change;
  std::uint64_t twice_k_less_v;
  std::uint64_t least_k;
  std::uint64_t step;  ///< from one block size to the next
  std::uint64_t (*b)(std::uint64_t k);
  bool tight;
  std::uint64_t expansion_set;  ///< the k that has one

  [[nodiscard]] Parameters at(std::uint64_t k) const {
    return {2 * k - twice_k_less_v, k, change, Kind::circular, 2};
  }
};

std::ostream& operator<<(std::ostream& out, const Served& served) { return out << served.entry; }

const std::vector<Served> families{
    {"mcsorley-circular", 1, 1, 2, 1, [](std::uint64_t k) { return 2 * k - 1; }, true, 0},
    {"doubling", 2, 2, 2, 2, [](std::uint64_t k) { return k - 1; }, true, 4},
    {"fixed-element", 2, 3, 3, 2, [](std::uint64_t k) { return k - 2; }, true, 0},
    {"short-long-runs", 2, 2, 5, 2, [](std::uint64_t k) { return k; }, false, 0},
};

class OneVForEachK : public testing::TestWithParam<Served> {
 protected:
  const Served& served = GetParam();
};

TEST_P(OneVForEachK, IsExactlyAsPromised) {
  for (std::uint64_t k = served.least_k; k <= 61; k += served.step) {
    const auto offer = offer_of(served.entry, served.at(k));
    ASSERT_TRUE(offer) << k;
    EXPECT_EQ(offer->b, served.b(k));
    EXPECT_EQ(offer->tight, served.tight);
    EXPECT_EQ(offer->economical, served.tight);
    EXPECT_EQ(offer->expansion_set, k == served.expansion_set);
    expect_exactly_as_promised(*offer);
  }
}

TEST_P(OneVForEachK, ServesNothingElse) {
  for (std::uint64_t k = 2; k <= 60; ++k) {
    if (k < served.least_k || (k - served.least_k) % served.step != 0) {
      EXPECT_FALSE(offer_of(served.entry, served.at(k))) << k;
      continue;
    }
    Parameters other = served.at(k);
    other.kind = Kind::linear;
    EXPECT_FALSE(offer_of(served.entry, other)) << k;
    other = served.at(k);
    other.change = 3 - served.change;
    EXPECT_FALSE(offer_of(served.entry, other)) << k;
    other = served.at(k);
    other.strength = 3;
    EXPECT_FALSE(offer_of(served.entry, other)) << k;
    other = served.at(k);
    ++other.v;
    EXPECT_FALSE(offer_of(served.entry, other)) << k;
  }
  EXPECT_FALSE(offer_of(served.entry, {1, 1, served.change, Kind::circular, 2}));
}

TEST_P(OneVForEachK, RefusesSpoiltRecipes) {
  for (const std::uint64_t index : {0U, 1U, 2U, 3U}) {
    const std::uint64_t k = served.least_k + index * served.step;
    expect_spoilt_recipes_refused(offer_of(served.entry, served.at(k))->recipe);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, OneVForEachK, testing::ValuesIn(families), [](const auto& one) {
  std::string name = one.param.entry;
  std::erase(name, '-');
  return name;
});

// What is special to one of them.

Recipe recipe_of(const char* entry, std::uint64_t k) {
  const auto served = std::ranges::find(families, std::string_view(entry), &Served::entry);
  return offer_of(entry, served->at(k))->recipe;
}

Design made(const char* entry, std::uint64_t k) {
  return standard().build_design(recipe_of(entry, k));
}

std::string explained(const char* entry, std::uint64_t k) {
  return construction(entry).explain(recipe_of(entry, k));
}

TEST(McSorleyCircular, DevelopsConsecutiveResidues) {
  EXPECT_EQ(made("mcsorley-circular", 3).blocks(),
            (std::vector<Block>{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
}

TEST(Doubling, MakesThePrintedDesignForBlockSizeFour) {
  std::vector<Block> blocks = made("doubling", 4).blocks();
  std::ranges::for_each(blocks, [](Block& block) { std::ranges::sort(block); });
  EXPECT_EQ(blocks, (std::vector<Block>{{0, 1, 2, 3}, {2, 3, 4, 5}, {0, 1, 4, 5}}));
  EXPECT_EQ(made("doubling", 2).blocks(), (std::vector<Block>{{0, 1}}));
}

TEST(Doubling, NeedsTheSingleChangeDesignInTheRegistry) {
  const Registry alone({&construction("doubling")});
  EXPECT_FALSE(alone.best({6, 4, 2, Kind::circular, 2}));
  EXPECT_TRUE(alone.best({2, 2, 2, Kind::circular, 2}));
}

TEST(FixedElement, HasItsNewElementInEveryBlock) {
  EXPECT_EQ(made("fixed-element", 3).blocks(), (std::vector<Block>{{0, 1, 2}}));
  for (std::uint64_t k = 5; k <= 15; k += 2) {
    EXPECT_EQ(verify(made("fixed-element", k)).fixed,
              (std::vector<Element>{static_cast<Element>(2 * k - 4)}));
  }
}

TEST(ShortLongRuns, MakesThePrintedDesigns) {
  using Labelled = std::vector<std::set<std::string>>;
  const auto labelled = [](std::uint64_t k) {
    const Design design = made("short-long-runs", k);
    Labelled blocks;
    for (const Block& elements : design.blocks()) {
      std::set<std::string>& block = blocks.emplace_back();
      for (const Element x : elements) {
        block.insert(design.label(x));
      }
    }
    return blocks;
  };
  EXPECT_EQ(labelled(5), (Labelled{{"∞_l", "0_l", "0_s", "1_l", "2_s"},
                                   {"1_s", "0_l", "0_s", "1_l", "2_l"},
                                   {"1_s", "0_l", "∞_l", "∞_s", "2_l"},
                                   {"1_s", "0_l", "1_l", "2_s", "2_l"},
                                   {"0_s", "∞_s", "1_l", "2_s", "2_l"}}));
  EXPECT_EQ(labelled(7), (Labelled{{"∞_l", "0_l", "0_s", "1_l", "4_s", "3_l", "2_s"},
                                   {"3_s", "0_l", "0_s", "1_l", "2_l", "3_l", "2_s"},
                                   {"3_s", "0_l", "0_s", "4_l", "2_l", "3_l", "1_s"},
                                   {"3_s", "0_l", "∞_s", "4_l", "2_l", "∞_l", "1_s"},
                                   {"3_s", "0_l", "1_l", "4_l", "2_l", "4_s", "1_s"},
                                   {"2_s", "3_l", "1_l", "4_l", "2_l", "4_s", "1_s"},
                                   {"2_s", "3_l", "1_l", "4_l", "0_s", "4_s", "∞_s"}}));
}

TEST(OneVForEachKFamilies, ExplainThemselves) {
  EXPECT_EQ(explained("mcsorley-circular", 3), "Develop the base block {0,1,2} over Z_5.");
  EXPECT_EQ(explained("mcsorley-circular", 30), "Develop the base block {0,…,29} over Z_59.");
  EXPECT_EQ(explained("doubling", 4),
            "Replace every element x in the blocks of the circular SCCD(3,2) by 2x and 2x+1.");
  EXPECT_EQ(explained("doubling", 2), "The one block {0,1}.");
  EXPECT_EQ(explained("fixed-element", 5),
            "Add the new element 6 to every block of the circular DCCD(6,4).");
}

}  // namespace
}  // namespace changeover::one_v_for_each_k_test
