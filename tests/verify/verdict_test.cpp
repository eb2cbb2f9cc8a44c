#include "changeover/verify/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "all_blocks.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "naive_verdict.hpp"

namespace changeover::verdict_test {
namespace {

using test::all_blocks;
using test::naive_verdict;
using test::NaiveVerdict;

void expect_agreement(const Design& design) {
  const NaiveVerdict naive = naive_verdict(design);
  const Verdict verdict = verify(design, {.examples = 5, .unchanged = true});
  ASSERT_EQ(verdict.b, design.block_count());
  ASSERT_EQ(verdict.valid(), naive.valid);
  ASSERT_EQ(verdict.bad_steps, naive.bad_steps);
  ASSERT_EQ(verdict.uncovered, naive.uncovered);
  ASSERT_EQ(verdict.covered, naive.covered);
  ASSERT_EQ(verdict.never_newly_covered, naive.never_newly_covered);
  ASSERT_EQ(verdict.excess, naive.excess);
  ASSERT_EQ(verdict.uncovered_examples.size(), std::min<std::uint64_t>(5, naive.uncovered));
  ASSERT_EQ(verdict.bad_step_examples.size(), std::min<std::uint64_t>(5, naive.bad_steps));
  ASSERT_EQ(verdict.unchanged_subsets, naive.unchanged.size());
  for (std::size_t x = 0; x < verdict.elements.size(); ++x) {
    ASSERT_EQ(verdict.elements[x].introductions, naive.introductions[x]) << "element " << x;
    ASSERT_EQ(verdict.elements[x].blocks, naive.blocks[x]) << "element " << x;
    if (design.parameters().strength == 2) {
      ASSERT_EQ(verdict.elements[x].excess, naive.element_excess[x]) << "element " << x;
    }
    const auto element = static_cast<Element>(x);
    ASSERT_EQ(std::count(verdict.fixed.begin(), verdict.fixed.end(), element) == 1,
              naive.blocks[x] == design.block_count());
    const bool unchanged = std::any_of(naive.unchanged.begin(), naive.unchanged.end(),
                                       [&](const auto& set) { return set.count(element) != 0; });
    ASSERT_EQ(
        std::count(verdict.never_unchanged.begin(), verdict.never_unchanged.end(), element) == 1,
        !unchanged);
  }
  if (naive.valid && design.parameters().strength == 2) {
    ASSERT_TRUE(verdict.degree_identity);
  }
}

Design mcsorley(std::uint32_t k) {
  Block base(k);
  std::iota(base.begin(), base.end(), 0U);
  DevelopedSource source({{.v = 2 * k - 1, .k = k, .change = 1, .kind = Kind::circular}, {base}});
  return read_all(source);
}

Design dccd_6_4() {
  return Design({.v = 6, .k = 4, .kind = Kind::circular},
                std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
}

Design dccd_11_4() {
  DevelopedSource source({{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}});
  return read_all(source);
}

TEST(Verdict, AgreesWithTheDefinitionOnEveryListOfBlocksOfSmallParameters) {
  std::uint64_t lists = 0;
  std::uint64_t valid = 0;
  for (const auto& [v, k, most_blocks] : std::vector<std::array<std::uint32_t, 3>>{
           {2, 2, 3}, {3, 2, 4}, {4, 2, 3}, {4, 3, 5}, {5, 4, 4}}) {
    const std::vector<Block> blocks = all_blocks(v, k);
    for (std::uint32_t b = 1; b <= most_blocks; ++b) {
      std::vector<std::size_t> index(b, 0);
      for (bool more = true; more;) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          for (std::uint32_t m = 1; m <= std::min(2U, k); ++m) {
            Design design({.v = v, .k = k, .change = m, .kind = kind});
            for (const std::size_t i : index) {
              design.append(blocks[i]);
            }
            expect_agreement(design);
            if (HasFatalFailure()) {
              return;
            }
            ++lists;
            valid += verify(design).valid() ? 1U : 0U;
          }
        }
        std::size_t place = 0;
        while (place < b && ++index[place] == blocks.size()) {
          index[place++] = 0;
        }
        more = place < b;
      }
    }
  }
  EXPECT_GT(lists, 10'000U);
  EXPECT_GT(valid, 50U);
}

TEST(Verdict, AgreesWithTheDefinitionOnRandomListsOfEveryStrength) {
  std::mt19937 random(20261121);
  for (int round = 0; round < 1500; ++round) {
    const std::uint32_t v = 4 + static_cast<std::uint32_t>(random() % 6);
    const std::uint32_t k = 2 + static_cast<std::uint32_t>(random() % (v - 1));
    const std::uint32_t m = 1 + static_cast<std::uint32_t>(random() % k);
    const std::uint32_t t = std::min(k, 2 + static_cast<std::uint32_t>(random() % 3));
    Design design({.v = v,
                   .k = k,
                   .change = m,
                   .kind = random() % 2 == 0 ? Kind::linear : Kind::circular,
                   .strength = t});
    Block block(v);
    std::iota(block.begin(), block.end(), 0U);
    const std::uint32_t b = 1 + static_cast<std::uint32_t>(random() % 12);
    std::shuffle(block.begin(), block.end(), random);
    for (std::uint32_t i = 0; i < b; ++i) {
      // Mostly proper steps, so that the interesting cases are reached.
      const std::uint32_t changes =
          random() % 8 == 0 ? static_cast<std::uint32_t>(random() % (k + 1)) : m;
      for (std::uint32_t j = 0; j < std::min(changes, v - k); ++j) {
        std::swap(block[(i + j) % k], block[k + j % (v - k)]);
      }
      design.append(std::span<const Element>(block).first(k));
    }
    expect_agreement(design);
    ASSERT_FALSE(HasFatalFailure()) << "v=" << v << " k=" << k << " m=" << m << " t=" << t;
  }
}

TEST(Verdict, AgreesWithTheDefinitionWhereManyElementsAreIntroducedAtOnce) {
  std::mt19937 random(7);
  for (int round = 0; round < 30; ++round) {
    const std::uint32_t strength = 2 + static_cast<std::uint32_t>(round % 3);
    Parameters p{.v = 17 + random() % (strength == 2 ? 60 : 6), .strength = strength};
    p.k = 16 + random() % (p.v - 15);
    p.change = 1 + random() % p.k;
    p.kind = round % 2 == 0 ? Kind::linear : Kind::circular;
    Block all(p.v);
    std::iota(all.begin(), all.end(), Element{0});
    Design design(p);
    for (std::uint64_t b = 1 + random() % 4; b > 0; --b) {
      std::shuffle(all.begin(), all.end(), random);
      design.append(std::span(all).first(p.k));
    }
    expect_agreement(design);
  }
}

TEST(Verdict, OneBlockOfAllElementsThatThereCanBeIsJudgedInNoTime) {
  const Parameters p{.v = 65'535, .k = 65'535};
  Block all(p.v);
  std::iota(all.begin(), all.end(), Element{0});
  const Verdict verdict = verify(Design(p, std::vector<Block>{all}));
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.excess, 0U);
  EXPECT_EQ(verdict.covered, binomial(65'535, 2));
}

TEST(Verdict, FindsKnownDesignsTight) {
  for (std::uint32_t k = 2; k <= 30; ++k) {
    const Verdict verdict = verify(mcsorley(k));
    EXPECT_TRUE(verdict.tight());
    EXPECT_TRUE(verdict.economical());
    EXPECT_EQ(verdict.counting_bound, 2 * k - 1);
  }
  EXPECT_TRUE(verify(dccd_6_4()).tight());
  EXPECT_TRUE(verify(dccd_11_4()).tight());
}

TEST(Verdict, RejectsEveryMutationOfATightDesignAtMarginOne) {
  for (const Design& design : {dccd_6_4(), dccd_11_4(), mcsorley(5)}) {
    const Parameters& p = design.parameters();
    const std::size_t b = design.block_count();
    const std::vector<Block> blocks = design.blocks();
    for (std::size_t i = 0; i < b; ++i) {
      auto fewer = blocks;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_FALSE(verify(Design(p, fewer)).valid()) << "dropped block " << i;
      for (std::size_t j = i + 1; j < b && b > 3; ++j) {
        auto swapped = blocks;
        std::swap(swapped[i], swapped[j]);
        const Verdict verdict = verify(Design(p, swapped));
        EXPECT_EQ(verdict.valid(), naive_verdict(Design(p, swapped)).valid);
        EXPECT_FALSE(verdict.tight()) << "swapped " << i << " and " << j;
      }
      for (std::size_t place = 0; place < p.k; ++place) {
        for (Element x = 0; x < p.v; ++x) {
          auto changed = blocks;
          if (std::count(changed[i].begin(), changed[i].end(), x) == 0) {
            changed[i][place] = x;
            EXPECT_FALSE(verify(Design(p, changed)).valid()) << "block " << i << " place " << place;
          }
        }
      }
    }
  }
}

TEST(Verdict, SeesABrokenLinkOnlyInACircularDesign) {
  // Blocks that are a linear DCCD but whose ends share no two elements.
  Design design({.v = 6, .k = 3, .kind = Kind::linear},
                std::vector<Block>{{0, 1, 2}, {0, 3, 4}, {3, 1, 5}, {1, 2, 4}});
  const Verdict linear = verify(design);
  EXPECT_EQ(linear.bad_steps, 0U);
  design.set_kind(Kind::circular);
  const Verdict circular = verify(design);
  ASSERT_EQ(circular.bad_steps, 1U);
  EXPECT_EQ(circular.bad_step_examples.front(), (BadStep{4, 1, 1}));
}

TEST(Verdict, CountsPairsThatLieInEveryBlockApart) {
  // A circular DCCD(8,6) with fewer blocks than ⌈g₂⌉ = 4: pairs of fixed elements are never newly
  // covered.
  const Design design(
      {.v = 8, .k = 6, .kind = Kind::circular},
      std::vector<Block>{{2, 3, 4, 5, 6, 7}, {0, 1, 4, 5, 6, 7}, {0, 1, 2, 3, 6, 7}});
  const Verdict verdict = verify(design);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.counting_bound, 4U);
  EXPECT_EQ(verdict.b, 3U);
  EXPECT_EQ(verdict.fixed, (std::vector<Element>{6, 7}));
  EXPECT_EQ(verdict.never_newly_covered, 1U);
  EXPECT_FALSE(verdict.tight());
  EXPECT_FALSE(verdict.economical());
  EXPECT_TRUE(verdict.degree_identity);
}

TEST(Verdict, AcceptsASingleBlockInBothKinds) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const Design design({.v = 3, .k = 3, .kind = kind}, std::vector<Block>{{0, 1, 2}});
    const Verdict verdict = verify(design);
    EXPECT_TRUE(verdict.valid());
    EXPECT_TRUE(verdict.tight());
    EXPECT_EQ(verdict.counting_bound, 1U);
  }
}

TEST(Verdict, RejectsAnEmptyList) {
  EXPECT_FALSE(verify(Design({.v = 3, .k = 3})).valid());
  EXPECT_FALSE(verify(Design({.v = 5, .k = 3, .kind = Kind::circular})).valid());
}

class FixedBlocks final : public BlockByBlock<FixedBlocks> {
 public:
  FixedBlocks(Parameters p, std::vector<Block> blocks) : p_(p), blocks_(std::move(blocks)) {}
  [[nodiscard]] const Parameters& parameters() const override { return p_; }
  bool make(std::span<Element> block) {
    if (next_ == blocks_.size()) {
      return false;
    }
    std::copy(blocks_[next_].begin(), blocks_[next_].end(), block.begin());
    ++next_;
    return true;
  }

 private:
  Parameters p_;
  std::vector<Block> blocks_;
  std::size_t next_ = 0;
};

TEST(Verdict, TrustsNoStream) {
  FixedBlocks repeated({.v = 5, .k = 3}, {{0, 1, 2}, {3, 4, 3}});
  EXPECT_THROW((void)verify(repeated), BadInput);
  FixedBlocks outside({.v = 5, .k = 3}, {{0, 1, 5}});
  EXPECT_THROW((void)verify(outside), BadInput);
  FixedBlocks huge({.v = 70'000, .k = 3}, {});
  EXPECT_THROW((void)verify(huge), MissingResource);
  FixedBlocks triples({.v = 60'000, .k = 3, .strength = 3}, {});
  EXPECT_THROW((void)verify(triples), MissingResource);
}

TEST(Verdict, ListsMissingPairsAndTriples) {
  const Design pairs({.v = 4, .k = 3, .change = 1}, std::vector<Block>{{0, 1, 2}, {1, 2, 3}});
  EXPECT_EQ(verify(pairs).uncovered_examples, (std::vector<Block>{{0, 3}}));
  const Design triples({.v = 4, .k = 3, .change = 1, .strength = 3},
                       std::vector<Block>{{0, 1, 2}, {1, 2, 3}, {0, 2, 3}});
  const Verdict verdict = verify(triples);
  EXPECT_EQ(verdict.uncovered_examples, (std::vector<Block>{{0, 1, 3}}));
  EXPECT_EQ(verdict.subsets, 4U);
}

}  // namespace
}  // namespace changeover::verdict_test
