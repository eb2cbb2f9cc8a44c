#include "construct/tools/cyclic.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "changeover/verify/difference.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"

namespace changeover::cyclic_test {
namespace {

using namespace test;
using Numbers = std::vector<std::uint64_t>;

constexpr std::uint64_t largest_v = 0xffff'ffff;

Parameters parameters(std::uint64_t c, std::uint64_t k) {
  return {c * (4 * k - 6) + 1, k, 2, Kind::circular, 2};
}

Offer cyclic_offer(std::uint64_t c, std::uint64_t k) {
  return *offer_of("cyclic", parameters(c, k));
}

IntervalBaseBlocks cyclic_base_blocks(std::uint64_t c, std::uint64_t k) {
  return *construction("cyclic").interval_base_blocks(cyclic_offer(c, k).recipe);
}

struct Pairing {
  std::vector<PositionPair> ordinary;
  PositionPair special;
};

Pairing pairing_of(std::uint64_t c) {
  Pairing pairing{{}, special_pair(c)};
  for (std::uint64_t i = 0; i + 1 < c; ++i) {
    pairing.ordinary.push_back(ordinary_pair(c, i));
  }
  return pairing;
}

// The proposition's condition, word by word.
bool is_as_required(const Pairing& pairing, std::uint64_t c) {
  std::vector<bool> position(2 * c + 1, false);
  std::vector<bool> difference(c, false);
  const auto mark = [](std::vector<bool>& seen, std::uint64_t x) {
    if (x < 1 || x >= seen.size() || seen[x]) {
      return false;
    }
    seen[x] = true;
    return true;
  };
  for (const PositionPair& pair : pairing.ordinary) {
    if (pair.first >= pair.second || !mark(difference, pair.second - pair.first) ||
        !mark(position, pair.first) || !mark(position, pair.second)) {
      return false;
    }
  }
  const PositionPair& special = pairing.special;
  const std::uint64_t sum = special.first + special.second;
  return pairing.ordinary.size() == c - 1 && mark(position, special.first) &&
         mark(position, special.second) && (sum == 3 * c - 1 || sum == 3 * c) &&
         (special.second != c || special.first == c);
}

TEST(CyclicPairs, TileThePositionsAndTheDifferencesForEveryNumberOfBaseBlocks) {
  for (std::uint64_t c = 1; c <= 3000; ++c) {
    ASSERT_TRUE(is_as_required(pairing_of(c), c)) << c;
  }
  for (const std::uint64_t c : Numbers{100'000, 100'001, 100'002, 100'003, 999'999, 1'000'000}) {
    ASSERT_TRUE(is_as_required(pairing_of(c), c)) << c;
  }
}

TEST(CyclicPairs, AreThoseOfTheTable) {
  using Pairs = std::vector<PositionPair>;
  EXPECT_EQ(special_pair(1), (PositionPair{1, 2}));
  EXPECT_EQ(pairing_of(2).ordinary, (Pairs{{2, 3}}));
  EXPECT_EQ(special_pair(2), (PositionPair{1, 4}));
  EXPECT_EQ(pairing_of(3).ordinary, (Pairs{{1, 2}, {4, 6}}));
  EXPECT_EQ(special_pair(3), (PositionPair{3, 5}));
  EXPECT_EQ(pairing_of(4).ordinary, (Pairs{{1, 4}, {2, 3}, {6, 8}}));
  EXPECT_EQ(special_pair(4), (PositionPair{5, 7}));
  EXPECT_EQ(pairing_of(5).ordinary, (Pairs{{1, 3}, {2, 6}, {4, 7}, {8, 9}}));
  EXPECT_EQ(special_pair(5), (PositionPair{5, 10}));
  EXPECT_EQ(pairing_of(6).ordinary, (Pairs{{1, 2}, {3, 6}, {4, 9}, {7, 11}, {8, 10}}));
  EXPECT_EQ(special_pair(6), (PositionPair{5, 12}));
  EXPECT_EQ(pairing_of(8).ordinary,
            (Pairs{{1, 8}, {2, 7}, {3, 6}, {4, 5}, {9, 15}, {11, 13}, {12, 16}}));
  EXPECT_EQ(special_pair(8), (PositionPair{10, 14}));
}

TEST(CyclicPairs, FailTheConditionWheneverOnePositionIsChanged) {
  for (const std::uint64_t c : Numbers{4, 5, 6, 7, 12, 13, 14, 15}) {
    const Pairing right = pairing_of(c);
    for (std::uint64_t i = 0; i < c; ++i) {
      for (const bool second : {false, true}) {
        for (std::uint64_t z = 0; z <= 2 * c + 1; ++z) {
          Pairing wrong = right;
          PositionPair& pair = i + 1 < c ? wrong.ordinary[i] : wrong.special;
          std::uint64_t& position = second ? pair.second : pair.first;
          if (position != z) {
            position = z;
            EXPECT_FALSE(is_as_required(wrong, c)) << c << " " << i << " " << z;
          }
        }
      }
    }
  }
}

TEST(CyclicPairs, GiveBaseBlocksThatFailIfTwoPairsExchangePartners) {
  // {p,q}, {r,s} → {p,s}, {r,q}: the same points and intervals, two differences of new points
  // missing.
  for (const std::uint64_t c : Numbers{7, 8, 9, 10}) {
    for (const std::uint64_t k : Numbers{4, 9}) {
      const IntervalBaseBlocks right = cyclic_base_blocks(c, k);
      for (std::size_t i = 0; i < c; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          IntervalBaseBlocks wrong = right;
          std::swap(wrong.points[2 * i + 1], wrong.points[2 * j + 1]);
          const DifferenceVerdict verdict = verify_differences(wrong);
          EXPECT_GT(verdict.uncovered, 0U) << c << " " << k << " " << i << " " << j;
        }
      }
    }
  }
}

TEST(Cyclic, IsTightForEveryBlockSizeAndNumberOfBaseBlocks) {
  for (std::uint64_t c = 1; c <= 40; ++c) {
    for (const std::uint64_t k : Numbers{3, 4, 5, 6, 7, 9, 12, 15}) {
      if (c * k > 240) {
        continue;
      }
      const auto offer = offer_of("cyclic", parameters(c, k));
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, c * c * (4 * k - 6) + c);
      EXPECT_EQ(offer->recipe.arguments.at("c"), static_cast<std::int64_t>(c));
      EXPECT_TRUE(offer->tight && offer->economical);
      EXPECT_EQ(offer->expansion_set, (2 * c + 1) % (k - 2) == 0);
      expect_as_promised(*offer);
    }
  }
}

TEST(Cyclic, IsTightForLargeBlocks) {
  for (std::uint64_t c = 1; c <= 4; ++c) {
    for (const std::uint64_t k : Numbers{30, 61}) {
      expect_as_promised(cyclic_offer(c, k));
    }
  }
}

TEST(CyclicSlow, IsTightForManyBaseBlocksOfManySizes) {
  for (std::uint64_t c = 1; c <= 120; ++c) {
    for (std::uint64_t k = 3; k * c <= (c <= 40 ? 480 : 600); ++k) {
      expect_as_promised(cyclic_offer(c, k));
    }
  }
}

void expect_certified(std::uint64_t c, std::uint64_t k) {
  const Offer offer = cyclic_offer(c, k);
  const auto base = construction("cyclic").interval_base_blocks(offer.recipe);
  ASSERT_TRUE(base);
  ASSERT_EQ(base->base_block_count(), c);
  const DifferenceVerdict verdict = verify_differences(*base);
  ASSERT_TRUE(verdict.valid() && verdict.tight) << "c = " << c << ", k = " << k;
  ASSERT_EQ(verdict.b, offer.b);
}

TEST(Cyclic, HasTheSameVerdictFromIntervalsAsFromAllDifferences) {
  for (std::uint64_t c = 1; c <= 40; ++c) {
    for (const std::uint64_t k : Numbers{3, 4, 5, 8, 13, 50, 499}) {
      const Recipe recipe = cyclic_offer(c, k).recipe;
      const auto intervals = construction("cyclic").interval_base_blocks(recipe);
      const auto blocks = construction("cyclic").base_blocks(recipe);
      ASSERT_TRUE(intervals && blocks);
      EXPECT_EQ(intervals->written_out(), *blocks);
      EXPECT_TRUE(verify_differences(*blocks).tight);
      expect_certified(c, k);
    }
  }
}

TEST(Cyclic, HasACertificateForThousandsOfBaseBlocks) {
  for (std::uint64_t c = 41; c <= 5000; c += c < 500 ? 1 : 37) {
    expect_certified(c, 3 + c % 61);
  }
  for (const std::uint64_t c : Numbers{4996, 4997, 4998, 4999, 5000}) {
    for (const std::uint64_t k : Numbers{3, 4, 1000}) {
      expect_certified(c, k);
    }
  }
}

TEST(CyclicSlow, HasACertificateForEveryNumberOfBaseBlocksUpToFiveThousand) {
  for (std::uint64_t c = 1; c <= 5000; ++c) {
    expect_certified(c, 3 + c % 61);
    expect_certified(c, 3 + c % 7);
  }
}

TEST(CyclicSlow, HasACertificateForAMillionBaseBlocks) {
  const auto start = std::chrono::steady_clock::now();
  const IntervalBaseBlocks base = cyclic_base_blocks(1'000'000, 1000);
  const auto made = std::chrono::steady_clock::now();
  const DifferenceVerdict verdict = verify_differences(base);
  const auto end = std::chrono::steady_clock::now();
  EXPECT_TRUE(verdict.valid() && verdict.tight);
  EXPECT_EQ(base.parameters.v, 3'994'000'001U);
  EXPECT_EQ(verdict.b, 3'994'000'001'000'000U);
  const auto ms = [](auto span) {
    return static_cast<long long>(
        std::chrono::duration_cast<std::chrono::milliseconds>(span).count());
  };
  std::printf("c = 10^6, k = 1000: base blocks %lld ms, certificate %lld ms\n", ms(made - start),
              ms(end - made));
}

TEST(Cyclic, StreamsAMillionBaseBlocksWithoutHoldingThem) {
  const Offer offer = cyclic_offer(1'000'000, 1000);
  EXPECT_FALSE(construction("cyclic").base_blocks(offer.recipe));  // 10⁹ elements
  const auto source = standard().build(offer.recipe);
  EXPECT_EQ(source->block_count(), offer.b);
  const IntervalBaseBlocks base = cyclic_base_blocks(1'000'000, 1000);
  Block block(1000);
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_TRUE(source->next(block));
    ASSERT_EQ(block.front(), 0U);
    ASSERT_EQ(block[997], 997U);
    ASSERT_EQ(block[998], base.points[2 * i]);
    ASSERT_EQ(block[999], base.points[2 * i + 1]);
  }
}

TEST(Cyclic, ServesTheLargestParametersWithoutWrapping) {
  // v = 6c + 1 with as many base blocks as there are, and c = 1 with as large a block as there is.
  const std::uint64_t most = (largest_v - 1) / 6;
  for (const auto& [c, k] :
       {std::pair{most, std::uint64_t{3}}, std::pair{std::uint64_t{1}, (largest_v + 5) / 4},
        std::pair{std::uint64_t{65'535}, std::uint64_t{16'384}}}) {
    const auto offer = offer_of("cyclic", parameters(c, k));
    ASSERT_TRUE(offer) << c << " " << k;
    EXPECT_EQ(offer->b, c * offer->recipe.parameters.v);
    EXPECT_FALSE(offer->expansion_set);
    EXPECT_FALSE(construction("cyclic").expansion_set(offer->recipe, standard()));
    if (k == 3) {
      EXPECT_FALSE(construction("cyclic").interval_base_blocks(offer->recipe));
      EXPECT_FALSE(construction("cyclic").base_blocks(offer->recipe));
      const auto source = standard().build(offer->recipe);
      Block block(3);
      ASSERT_TRUE(source->next(block));
      EXPECT_TRUE(block[0] == 0 && block[1] > 0 && block[2] > block[1]);
    } else {
      expect_certified(c, k);
    }
    EXPECT_FALSE(construction("cyclic").explain(offer->recipe).empty());
  }
  EXPECT_FALSE(offer_of("cyclic", parameters(most + 1, 3)));
}

TEST(Cyclic, CoversAllPairsButBreaksTheChangeIfTheLinkBlockIsElsewhere) {
  for (std::uint64_t c = 2; c <= 14; ++c) {
    for (const std::uint64_t k : Numbers{4, 5, 8}) {
      const IntervalBaseBlocks right = cyclic_base_blocks(c, k);
      const auto last = right.points_of(c - 1);
      ASSERT_TRUE(last[0] == k - 2 || last[1] == k - 2);
      expect_link_block_is_last(right);
    }
  }
}

TEST(Cyclic, HasTheParametersOfThePaperWhereBothServe) {
  for (std::uint64_t c = 1; c <= 6; ++c) {
    for (std::uint64_t k = 3; k <= 40; ++k) {
      const Offer ours = cyclic_offer(c, k);
      const auto printed = c <= 5 ? offer_of("cyclic-paper", parameters(c, k))
                                  : offer_of("cyclic-61-4", parameters(c, k));
      ASSERT_EQ(printed.has_value(), c <= 5 || k == 4);
      if (printed) {
        EXPECT_EQ(ours.recipe.parameters, printed->recipe.parameters);
        EXPECT_EQ(ours.b, printed->b);
        EXPECT_EQ(ours.expansion_set, printed->expansion_set);
        EXPECT_TRUE(ours.tight && printed->tight);
      }
    }
  }
  const auto blocks = [](std::uint64_t c, std::uint64_t k) {
    return construction("cyclic").base_blocks(cyclic_offer(c, k).recipe)->blocks;
  };
  EXPECT_EQ(blocks(1, 4), (std::vector<Block>{{0, 1, 2, 5}}));  // as printed
  EXPECT_EQ(blocks(2, 4), (std::vector<Block>{{0, 1, 10, 18}, {0, 1, 2, 7}}));
}

TEST(Cyclic, ServesNothingElse) {
  EXPECT_FALSE(offer_of("cyclic", {1, 3, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic", {5, 2, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic", {11, 4, 2, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("cyclic", {11, 4, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic", {11, 4, 2, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("cyclic", {12, 4, 2, Kind::circular, 2}));
}

TEST(Cyclic, RefusesSpoiltRecipes) {
  for (const auto& [c, k] :
       {std::pair{1, 3}, std::pair{6, 4}, std::pair{7, 9}, std::pair{100, 5}}) {
    expect_spoilt_recipes_refused(
        cyclic_offer(static_cast<std::uint64_t>(c), static_cast<std::uint64_t>(k)).recipe);
  }
}

TEST(Cyclic, HasAnExpansionSetAtTheSamePositionsAsThePrintedFamily) {
  const auto set = construction("cyclic").expansion_set(cyclic_offer(2, 7).recipe, standard());
  ASSERT_EQ(set->size(), 9U);
  EXPECT_EQ(set->front(), (UnchangedSubset{10, {5, 6, 7, 8, 9}}));
  EXPECT_EQ(set->back(), (UnchangedSubset{90, {0, 1, 2, 3, 4}}));
  const auto paper =
      construction("cyclic-paper")
          .expansion_set(offer_of("cyclic-paper", parameters(2, 7))->recipe, standard());
  EXPECT_EQ(set, paper);
}

TEST(Cyclic, FeedsTheRecursionBeyondThePrintedFamily) {
  // 2c+1 = 13: k = 15. v = 6·54+1 = 325, ℓ = 25, and 25·26/2 more blocks.
  const Offer offer = cyclic_offer(6, 15);
  ASSERT_TRUE(offer.expansion_set);
  const auto larger = offer_of("expansion", {325 + 26, 15, 2, Kind::circular, 2});
  ASSERT_TRUE(larger);
  EXPECT_EQ(larger->recipe.inputs.front(), offer.recipe);
  EXPECT_EQ(larger->b, offer.b + 25 * 13);
  EXPECT_TRUE(larger->tight);
  expect_as_promised(*larger);
}

TEST(Cyclic, ExplainsItself) {
  EXPECT_EQ(construction("cyclic").explain(cyclic_offer(1, 4).recipe),
            "Develop the base block {0,1,2,5} over Z_11.");
  EXPECT_EQ(construction("cyclic").explain(cyclic_offer(2, 20).recipe),
            "Develop the base blocks {0,…,17,74,130}, {0,…,17,18,55} over Z_149.");
  EXPECT_EQ(construction("cyclic").explain(cyclic_offer(1'000'000, 3).recipe),
            "Develop the 1000000 base blocks {0,750001,3750000}, {0,3000008,5999999}, "
            "{0,3000011,5999996}, …, {0,1,3000005} over Z_6000001.");
}

RC_GTEST_PROP(Cyclic, HasAnExpansionSetExactlyIfItDividesEvenly, ()) {
  const auto c = *rc::gen::inRange<std::uint64_t>(1, 12);
  const auto k = *rc::gen::inRange<std::uint64_t>(3, 28);
  const Offer offer = cyclic_offer(c, k);
  const auto set = construction("cyclic").expansion_set(offer.recipe, standard());
  RC_ASSERT(set.has_value() == (offer.recipe.parameters.v % (k - 2) == 0));
  if (set) {
    RC_ASSERT(!expansion_set_defect(standard().build_design(offer.recipe), *set));
  }
}

}  // namespace
}  // namespace changeover::cyclic_test
