#include "changeover/search/local_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "run/random.hpp"
#include "search/local/random_list.hpp"
#include "search/repair/repair_other_block.hpp"

namespace changeover::repair_test {
namespace {

RepairResult mend(const Design& list, const RepairOptions& options = {}) {
  RunControl control({.seed = 3});
  return repair(list, options, control);
}

Design known(const Parameters& p) { return best_known_design(p).value(); }

TEST(Repair, LeavesADesignAlone) {
  const Design design = known({.v = 13, .k = 4, .kind = Kind::circular});
  const RepairResult result = mend(design);
  EXPECT_EQ(result.design->blocks(), design.blocks());
  EXPECT_EQ(result.kept, design.block_count());
  EXPECT_EQ(result.moves, 0U);
  EXPECT_EQ(result.why_stopped, WhyStopped::found);
}

TEST(Repair, MendsOneWrongElement) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const std::uint64_t m : {1U, 2U}) {
      const Design design = known({.v = 20, .k = 5, .change = m, .kind = kind});
      Random random(m);
      for (int run = 0; run < 5; ++run) {
        std::vector<Block> blocks = design.blocks();
        Block& victim = blocks[random.below(static_cast<std::uint32_t>(blocks.size()))];
        Element other = random.below(20);
        while (std::find(victim.begin(), victim.end(), other) != victim.end()) {
          other = random.below(20);
        }
        victim[random.below(5)] = other;
        const Design list(design.parameters(), blocks);
        const RepairResult result = mend(list);
        EXPECT_TRUE(test::naive_verdict(*result.design).valid);
        EXPECT_EQ(result.given, blocks.size());
        EXPECT_GE(result.kept + 12, blocks.size());
      }
    }
  }
}

// A design with one slip is repaired by one change: at most one block is not kept.
TEST(Repair, OneSlipCostsOneBlockAtMost) {
  Random random(4);
  std::size_t slips = 0;
  for (const Parameters& p : std::vector<Parameters>{
           {.v = 9, .k = 4, .change = 1, .kind = Kind::linear},
           {.v = 8, .k = 4, .change = 1, .kind = Kind::circular},
           {.v = 13, .k = 4, .change = 2, .kind = Kind::circular},
           {.v = 12, .k = 5, .change = 2, .kind = Kind::linear},
           {.v = 6, .k = 4, .change = 1, .kind = Kind::circular, .strength = 3}}) {
    const Design design = known(p);
    const auto b = static_cast<std::uint32_t>(design.block_count());
    for (int run = 0; run < 40; ++run) {
      std::vector<Block> blocks = design.blocks();
      const std::uint32_t i = random.below(b);
      const std::uint32_t j = random.below(b);
      const int slip = run % 4;
      if (slip == 0) {
        std::swap(blocks[i], blocks[j]);
      } else if (slip == 1) {  // one elsewhere
        const Block block = blocks[i];
        blocks.erase(blocks.begin() + i);
        blocks.insert(blocks.begin() + j, block);
      } else if (slip == 2) {
        const auto x = random.below(static_cast<std::uint32_t>(p.v));
        if (std::ranges::find(blocks[i], x) != blocks[i].end()) {
          continue;
        }
        blocks[i][random.below(static_cast<std::uint32_t>(p.k))] = x;
      } else {
        blocks.insert(blocks.begin() + j, blocks[i]);
      }
      const Design list(p, blocks);
      if (test::naive_verdict(list).valid) {
        continue;
      }
      ++slips;
      const RepairResult result = mend(list);
      ASSERT_TRUE(test::naive_verdict(*result.design).valid) << name(p) << ' ' << slip;
      EXPECT_EQ(result.moves, 0U) << name(p) << ' ' << slip;
      EXPECT_GE(result.kept + (slip < 2 ? 0U : 1U), blocks.size()) << name(p) << ' ' << slip;
    }
  }
  EXPECT_GT(slips, 100U);
}

// All blocks of k of v elements, by counting in binary.
std::vector<Block> all_blocks(std::uint64_t v, std::uint64_t k) {
  std::vector<Block> blocks;
  for (std::uint32_t set = 0; set < 1U << v; ++set) {
    if (static_cast<std::uint64_t>(std::popcount(set)) == k) {
      Block block;
      for (Element x = 0; x < v; ++x) {
        if ((set >> x & 1U) != 0) {
          block.push_back(x);
        }
      }
      blocks.push_back(block);
    }
  }
  return blocks;
}

std::size_t in_common(const Block& one, const Block& other) {
  return static_cast<std::size_t>(
      std::ranges::count_if(one, [&](Element x) { return std::ranges::count(other, x) > 0; }));
}

// Every block in every place is tried: what is found keeps the most elements, and nothing is found
// only where no block fits.
TEST(Repair, AnotherBlockIsTheBestOfAll) {
  Random random(7);
  std::size_t found = 0;
  std::size_t none = 0;
  for (const Parameters& p : std::vector<Parameters>{
           {.v = 7, .k = 3, .change = 1, .kind = Kind::linear},
           {.v = 7, .k = 4, .change = 2, .kind = Kind::linear},
           {.v = 7, .k = 4, .change = 2, .kind = Kind::circular},
           {.v = 8, .k = 4, .change = 1, .kind = Kind::circular},
           {.v = 8, .k = 5, .change = 3, .kind = Kind::linear},
           {.v = 6, .k = 4, .change = 1, .kind = Kind::circular, .strength = 3}}) {
    const std::vector<Block> all = all_blocks(p.v, p.k);
    for (int run = 0; run < 30; ++run) {
      std::vector<Block> blocks = known(p).blocks();
      const auto b = static_cast<std::uint32_t>(blocks.size());
      for (int times = 0; times <= run % 3; ++times) {
        const std::size_t at = run % 5 == 0 ? (run % 2 == 0 ? 0 : b - 1) : random.below(b);
        blocks[at] = all[random.below(static_cast<std::uint32_t>(all.size()))];
      }
      std::optional<std::size_t> most;
      for (std::size_t i = 0; i < b; ++i) {
        for (const Block& block : all) {
          std::vector<Block> other = blocks;
          other[i] = block;
          if (test::naive_verdict(Design(p, other)).valid) {
            most = std::max(most.value_or(0), in_common(block, blocks[i]));
          }
        }
      }
      const auto design = with_another_block(Design(p, blocks));
      ASSERT_EQ(design.has_value(), most.has_value()) << name(p);
      (design ? found : none)++;
      if (design) {
        ASSERT_TRUE(test::naive_verdict(*design).valid) << name(p);
        std::size_t kept = p.k;
        for (std::size_t i = 0; i < b; ++i) {
          kept = std::min(kept, in_common(design->blocks()[i], blocks[i]));
        }
        EXPECT_EQ(kept, *most) << name(p);
      }
    }
  }
  EXPECT_GT(found, 50U);
  EXPECT_GT(none, 20U);
}

// A whole block that is wrong costs this block only.
TEST(Repair, AWrongBlockCostsOneBlock) {
  const Design design = known({.v = 20, .k = 5, .change = 1, .kind = Kind::linear});
  for (std::size_t i = 0; i < design.block_count(); i += 5) {
    std::vector<Block> blocks = design.blocks();
    blocks[i] = {0, 4, 8, 12, 16};
    const RepairResult result = mend(Design(design.parameters(), blocks));
    EXPECT_TRUE(test::naive_verdict(*result.design).valid);
    EXPECT_EQ(result.design->block_count(), blocks.size());
    EXPECT_GE(result.kept + 1, blocks.size());
  }
}

TEST(Repair, ConnectsWhatIsFarApart) {
  const Parameters p{.v = 12, .k = 4, .kind = Kind::circular};
  const Design design = known(p);
  std::vector<Block> blocks = design.blocks();
  std::rotate(blocks.begin(), blocks.begin() + 3, blocks.begin() + 7);
  blocks.insert(blocks.begin() + 5, blocks[4]);  // a repeated block
  const RepairResult result = mend(Design(p, blocks));
  EXPECT_GT(result.bad_steps, 0U);
  EXPECT_TRUE(test::naive_verdict(*result.design).valid);
}

TEST(Repair, MakesADesignOfAnyList) {
  Random random(9);
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const auto& [v, k, m, t] : std::vector<std::array<std::uint64_t, 4>>{
             {5, 3, 2, 2}, {6, 4, 1, 2}, {8, 4, 2, 3}, {7, 2, 1, 2}, {9, 6, 3, 2}, {4, 4, 2, 2}}) {
      const Parameters p{
          .v = v, .k = k, .change = m, .kind = kind, .strength = static_cast<std::uint32_t>(t)};
      for (std::size_t b = 1; b < 8; b += 2) {
        Design list(p);
        for (std::size_t i = 0; i < b; ++i) {
          list.append(random_block(p, random));
        }
        const RepairResult result = mend(list, {.moves = 50'000});
        EXPECT_TRUE(test::naive_verdict(*result.design).valid) << name(p) << ' ' << b;
      }
    }
  }
}

TEST(Repair, KeepsLabels) {
  const Parameters p{.v = 6, .k = 4, .kind = Kind::circular};
  Design list(p, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 2}});
  list.set_labels({"a", "b", "c", "d", "e", "f"});
  const RepairResult result = mend(list);
  EXPECT_EQ(result.design->labels(), list.labels());
  EXPECT_TRUE(verify(*result.design).valid());
}

TEST(Repair, RefusesWhatCannotBe) {
  EXPECT_REFUSAL(mend(Design({.v = 6, .k = 4})), BadInput,
                 "the list has no block; give at least one, or search from scratch");
  const Design list({.v = 4, .k = 2}, std::vector<Block>{{0, 1}});
  EXPECT_THROW(mend(list), ImpossibleParameters);
}

TEST(Extend, KeepsTheBeginning) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const std::uint64_t m : {1U, 2U}) {
      const Parameters p{.v = 14, .k = 4, .change = m, .kind = kind};
      const Design whole = known(p);
      for (const std::size_t kept : {std::size_t{1}, std::size_t{5}, whole.block_count() - 2}) {
        Design beginning(p);
        for (std::size_t i = 0; i < kept; ++i) {
          beginning.append(whole.block(i));
        }
        RunControl control({.seed = 4});
        const ExtendResult result = extend(beginning, {.moves = 150'000}, control);
        EXPECT_TRUE(test::naive_verdict(*result.design).valid);
        EXPECT_GE(result.design->block_count(), result.lower_bound);
        for (std::size_t i = 0; i < kept; ++i) {
          const auto was = beginning.block(i);
          const auto is = result.design->block(i);
          EXPECT_TRUE(std::equal(was.begin(), was.end(), is.begin(), is.end()));
        }
      }
    }
  }
}

TEST(Extend, FindsBackWhatWasTakenAway) {
  const Parameters p{.v = 12, .k = 4, .change = 2};
  const Design whole = known(p);
  Design beginning(p);
  for (std::size_t i = 0; i + 4 < whole.block_count(); ++i) {
    beginning.append(whole.block(i));
  }
  RunControl control({.seed = 5});
  const ExtendResult result =
      extend(beginning, {.blocks = whole.block_count(), .moves = 20'000'000}, control);
  EXPECT_LE(result.design->block_count(), whole.block_count());
  EXPECT_EQ(result.why_stopped, WhyStopped::found);
}

TEST(Extend, RefusesAWrongStep) {
  const Parameters p{.v = 8, .k = 4, .change = 2};
  RunControl control({});
  const Design wrong(p, std::vector<Block>{{0, 1, 2, 3}, {0, 1, 2, 4}});
  try {
    static_cast<void>(extend(wrong, {}, control));
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_STREQ(fault.what(),
                 "the step from block 1 to block 2 changes 1 element, not 2; repair the list "
                 "first");
  }
  EXPECT_REFUSAL(static_cast<void>(extend(Design(p), {}, control)), BadInput,
                 "there is no block to begin with; give at least one, or search from scratch");
}

}  // namespace
}  // namespace changeover::repair_test
