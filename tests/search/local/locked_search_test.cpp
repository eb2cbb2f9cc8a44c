// Local search with locked cells.
#include "changeover/search/local_search.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/core/error.hpp"
#include "naive_verdict.hpp"
#include "search/local/known_as_wanted.hpp"
#include "search/local/locked_draft.hpp"
#include "search/local/random_list.hpp"
#include "search/local/segment_pairs.hpp"

namespace changeover::test::locked_search_test {
namespace {

LockedResult searched(const Parameters& p, const Wanted& wanted, std::uint64_t blocks,
                      std::uint64_t moves = 200'000'000) {
  RunControl control({.threads = 1, .seed = 3});
  return search_locked(p, wanted, {.blocks = blocks, .moves = moves, .from_known = false}, control);
}

// The parts by the definition, from the blocks alone.
void expect_as_wanted(const LockedResult& found, const Wanted& wanted) {
  ASSERT_TRUE(found.design);
  const Design& design = found.design->design();
  EXPECT_TRUE(naive_verdict(design).valid);
  const std::vector<Block> blocks = design.blocks();
  const auto in = [](const Block& block, Element x) {
    return std::find(block.begin(), block.end(), x) != block.end();
  };
  std::set<Element> others;
  for (Element x = 0; x < design.v(); ++x) {
    others.insert(x);
  }
  for (const Element x : wanted.first) {
    EXPECT_TRUE(in(blocks.front(), x));
    others.erase(x);
  }
  for (const Element x : wanted.last) {
    EXPECT_TRUE(in(blocks.back(), x));
    others.erase(x);
  }
  if (wanted.expansion_set) {
    for (const UnchangedSubset& part : found.parts) {
      EXPECT_EQ(part.elements.size(), design.k() - design.parameters().change);
      for (const Element x : part.elements) {
        EXPECT_TRUE(in(blocks.at(part.position - 1), x));
        EXPECT_TRUE(in(blocks[part.position % blocks.size()], x));
        EXPECT_EQ(others.erase(x), 1U);
      }
    }
    EXPECT_TRUE(others.empty());
  }
}

TEST(LockedSearch, FindsDesignsToConcatenate) {
  const Wanted four{.first = {0, 1, 2, 3}, .expansion_set = true};
  const Wanted three{.first = {0, 1, 2}, .expansion_set = true};
  expect_as_wanted(searched({12, 4, 1, Kind::linear, 2}, three, 21), three);
  expect_as_wanted(searched({16, 5, 1, Kind::linear, 2}, four, 30), four);
}

TEST(LockedSearch, FindsEveryKind) {
  const Wanted set{.expansion_set = true};
  expect_as_wanted(searched({12, 4, 2, Kind::circular, 2}, set, 16), set);
  expect_as_wanted(searched({12, 4, 2, Kind::linear, 2}, set, 16), set);
  const Wanted ends{.first = {3, 5}, .last = {0, 1}, .expansion_set = true};
  expect_as_wanted(searched({14, 4, 2, Kind::linear, 2}, ends, 21), ends);
  const Wanted last{.last = {4, 2, 0}};
  expect_as_wanted(searched({10, 4, 1, Kind::linear, 2}, last, 16), last);
}

// Every second step or so has a part.
TEST(LockedSearch, FindsPartsThatStandClose) {
  const Wanted all{.expansion_set = true};
  expect_as_wanted(searched({12, 4, 2, Kind::circular, 2}, all, 14), all);
  expect_as_wanted(searched({8, 4, 2, Kind::circular, 2}, all, 8), all);
  const Wanted but_two{.last = {0, 1}, .expansion_set = true};
  expect_as_wanted(searched({12, 4, 2, Kind::linear, 2}, but_two, 15), but_two);
}

// Parts at steps that follow each other share a block: 2(k−m) ≤ k elements.
TEST(LockedSearch, FindsPartsAtNeighbouringSteps) {
  const Wanted all{.expansion_set = true};
  expect_as_wanted(searched({9, 6, 3, Kind::circular, 2}, all, 3, 100'000), all);
  expect_as_wanted(searched({10, 6, 4, Kind::circular, 2}, all, 5, 1'000'000), all);
  expect_as_wanted(searched({12, 6, 3, Kind::linear, 2}, all, 6, 20'000'000), all);
  const Wanted but_three{.first = {0, 1, 2}, .expansion_set = true};
  expect_as_wanted(searched({9, 6, 3, Kind::linear, 2}, but_three, 3, 100'000), but_three);
}

// Drafts take every step and have what is required, whatever is drawn.
TEST(LockedSearch, EveryDraftHasWhatIsWanted) {
  Random random(5);
  std::size_t drawn = 0;
  for (std::uint64_t k = 3; k <= 6; ++k) {
    for (std::uint64_t change = 1; change < k; ++change) {
      for (std::uint64_t v = k + change; v <= 2 * k + 6; ++v) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          const Parameters p{v, k, change, kind, 2};
          const bool linear = kind == Kind::linear;
          for (const Wanted& wanted :
               {Wanted{.expansion_set = true}, Wanted{.first = linear ? Block{1, 0} : Block{},
                                               .last = linear ? Block{2, 1} : Block{},
                                               .expansion_set = true}}) {
            if (!wanted_defect(p, wanted).empty()) {
              continue;
            }
            const std::uint64_t least = wanted_bound(p, wanted).blocks;
            for (std::uint64_t b = least; b < least + 6; ++b) {
              SCOPED_TRACE(fmt::format("{}, {} blocks", name(p), b));
              const auto draft = draw_draft(p, wanted, static_cast<std::size_t>(b), random);
              if (!draft) {
                continue;
              }
              ++drawn;
              EXPECT_EQ(naive_verdict(draft->list).bad_steps, 0U);
              std::vector<std::size_t> positions;
              for (const LockedPart& part : draft->parts) {
                positions.push_back(part.block + 1);
              }
              EXPECT_TRUE(parts_as_wanted(draft->list, wanted, positions));
            }
          }
        }
      }
    }
  }
  EXPECT_GT(drawn, 300U);
}

// A partition takes a step for each part.
TEST(LockedSearch, KnowsHowManyBlocksAPartitionTakes) {
  const Wanted all{.expansion_set = true};
  EXPECT_EQ(wanted_bound({9, 6, 3, Kind::linear, 2}, all).blocks, 4U);
  EXPECT_EQ(wanted_bound({9, 6, 3, Kind::circular, 2}, all).blocks, 3U);
  EXPECT_EQ(wanted_bound({12, 4, 1, Kind::linear, 2}, all),
            lower_bound({12, 4, 1, Kind::linear, 2}));
  const LockedResult found = searched({9, 6, 3, Kind::linear, 2}, all, 4, 1'000'000);
  EXPECT_EQ(found.lower_bound, 4U);
  expect_as_wanted(found, all);
}

LockedResult from_known(const Parameters& p, const Wanted& wanted, std::uint64_t blocks) {
  RunControl control({.threads = 1});
  return search_locked(p, wanted, {.blocks = blocks, .moves = 1'000'000}, control);
}

// Known designs are renumbered, and reversed where the last block has what the first must have.
TEST(LockedSearch, BeginsWithADesignThatIsKnown) {
  const Wanted four{.first = {7, 3, 19, 11}, .expansion_set = true};
  const Wanted all{.expansion_set = true};
  const Wanted ends{.first = {7, 9, 11}, .last = {9, 3}};
  for (const auto& [p, wanted, blocks] :
       {std::tuple(Parameters{20, 5, 1, Kind::linear, 2}, four, 46),
        {Parameters{20, 5, 1, Kind::linear, 2}, Wanted{.last = four.first, .expansion_set = true},
         46},
        {Parameters{15, 5, 2, Kind::circular, 2}, all, 15},
        {Parameters{12, 4, 1, Kind::linear, 2}, ends, 21}}) {
    SCOPED_TRACE(name(p));
    const LockedResult found = from_known(p, wanted, static_cast<std::uint64_t>(blocks));
    EXPECT_TRUE(found.known);
    EXPECT_EQ(found.moves, 0U);
    EXPECT_EQ(found.design->block_count(), static_cast<std::size_t>(blocks));
    expect_as_wanted(found, wanted);
  }
  // More blocks than are enough, or no blocks to be kept.
  EXPECT_FALSE(from_known({20, 5, 1, Kind::linear, 2}, four, 45).design);
  EXPECT_FALSE(
      from_known({11, 4, 2, Kind::linear, 2}, {.contained = {{0, 1, 2, 3}, {0, 1, 4, 5}}}, 40)
          .known);
}

// Blocks that are given may be in a circular list more than once.
TEST(LockedSearch, GivenBlocksBoundTheirDifferentOnes) {
  const Wanted round{.contained = {{0, 1, 2, 3}, {2, 3, 4, 5}, {0, 1, 4, 5}, {0, 1, 2, 3}}};
  EXPECT_EQ(wanted_bound({6, 4, 2, Kind::circular, 2}, round).blocks, 3U);
  EXPECT_EQ(wanted_bound({6, 4, 2, Kind::linear, 2}, round).blocks, 4U);
}

// In circular designs the parts are an expansion set, which another search looks for.
TEST(LockedSearch, AKnownDesignIsAsWantedIfItHasAnExpansionSet) {
  std::size_t with = 0;
  std::size_t without = 0;
  for (std::uint64_t k = 3; k <= 6; ++k) {
    for (std::uint64_t change = 1; change <= 3 && change < k; ++change) {
      for (std::uint64_t v = k + change; v <= 16; ++v) {
        const auto known = best_known_design({v, k, change, Kind::circular, 2});
        ASSERT_TRUE(known);
        SCOPED_TRACE(name(known->parameters()));
        const ExpansionSearch sets = find_expansion_sets(*known);
        const auto found = as_wanted(*known, {.expansion_set = true});
        ASSERT_EQ(found.has_value(), !sets.sets.empty());
        ++(found ? with : without);
        if (found) {
          EXPECT_TRUE(naive_verdict(found->design).valid);
          EXPECT_TRUE(parts_as_wanted(found->design, {.expansion_set = true}, found->positions));
        }
      }
    }
  }
  EXPECT_GT(with, 20U);
  EXPECT_GT(without, 20U);
}

// The only part is in the block with the first set, or in that with the last one.
TEST(LockedSearch, FindsPartsInTheBlocksAtTheEnds) {
  const Wanted ends{.first = {0, 1}, .last = {4, 5}, .expansion_set = true};
  expect_as_wanted(searched({6, 4, 2, Kind::linear, 2}, ends, 3), ends);
  const Wanted single{.first = {0, 1, 2}, .last = {2, 3, 4}, .expansion_set = true};
  expect_as_wanted(searched({8, 4, 1, Kind::linear, 2}, single, 9), single);
}

// Too few blocks for all the parts, or places that do not fit: nothing is found, and nothing is
// lost.
TEST(LockedSearch, NeverLosesWhatIsWanted) {
  for (std::uint64_t v = 6; v <= 14; ++v) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (const std::uint64_t change : {1U, 2U}) {
        const Parameters p{v, 4, change, kind, 2};
        for (const Wanted& wanted :
             {Wanted{.expansion_set = true}, Wanted{.first = {0, 1}, .expansion_set = true},
              Wanted{.first = {0, 1}, .last = {2, 3}, .expansion_set = true}}) {
          if (!wanted_defect(p, wanted).empty()) {
            continue;
          }
          SCOPED_TRACE(name(p));
          const LockedResult found = searched(p, wanted, lower_bound(p).blocks, 100'000);
          if (found.design) {
            expect_as_wanted(found, wanted);
          }
        }
      }
    }
  }
}

TEST(LockedSearch, KeepsTheBlocksGiven) {
  const Wanted wanted{.contained = {{0, 1, 2, 3}, {0, 1, 4, 5}, {4, 5, 6, 7}}};
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const LockedResult found = searched({11, 4, 2, kind, 2}, wanted, 15);
    ASSERT_TRUE(found.design);
    const Design& design = found.design->design();
    EXPECT_TRUE(naive_verdict(design).valid);
    EXPECT_TRUE(parts_as_wanted(design, wanted, {}));
    std::vector<Block> blocks = design.blocks();
    for (Block& block : blocks) {
      std::sort(block.begin(), block.end());
    }
    EXPECT_NE(
        std::search(blocks.begin(), blocks.end(), wanted.contained.begin(), wanted.contained.end()),
        blocks.end());
  }
}

TEST(LockedSearch, TheSameSeedGivesTheSameDesign) {
  const Wanted wanted{.first = {0, 1, 2}, .expansion_set = true};
  const LockedResult once = searched({12, 4, 1, Kind::linear, 2}, wanted, 22);
  const LockedResult again = searched({12, 4, 1, Kind::linear, 2}, wanted, 22);
  ASSERT_TRUE(once.design && again.design);
  EXPECT_EQ(once.design->design().blocks(), again.design->design().blocks());
  EXPECT_EQ(once.moves, again.moves);
}

TEST(LockedSearch, EndsWithItsMoves) {
  const LockedResult none =
      searched({20, 5, 1, Kind::linear, 2}, {.expansion_set = true}, 45, 300'000);
  EXPECT_FALSE(none.design);
  EXPECT_LE(none.moves, 300'000U);
  EXPECT_EQ(none.why_stopped, WhyStopped::step_limit);
}

TEST(LockedSearch, RefusesWhatNoDesignHas) {
  const Parameters linear{12, 4, 1, Kind::linear, 2};
  const Parameters circular{12, 4, 1, Kind::circular, 2};
  EXPECT_EQ(wanted_defect(linear, {.first = {0, 1, 2}, .expansion_set = true}), "");
  EXPECT_NE(wanted_defect(circular, {.first = {0}}), "");
  EXPECT_NE(wanted_defect(linear, {.first = {0, 1, 2, 3, 4}}), "");
  EXPECT_NE(wanted_defect(linear, {.last = {1, 1}}), "");
  EXPECT_NE(wanted_defect(linear, {.last = {12}}), "");
  EXPECT_EQ(
      wanted_defect({13, 4, 1, Kind::linear, 2}, {.expansion_set = true}),
      "13 elements cannot be divided into unchanged subsets of 3; name others in the first or "
      "last block");
  EXPECT_EQ(wanted_defect(linear, {.contained = {{0, 1, 2}}}),
            "a block has 4 elements, not 3; give whole blocks");
  EXPECT_NE(wanted_defect(linear, {.contained = {{0, 1, 2, 3}, {0, 1, 4, 5}}}), "");
  RunControl control({.threads = 1});
  EXPECT_THROW((void)search_locked(circular, {.first = {0}}, {}, control), BadInput);
  EXPECT_THROW((void)search_locked({9, 4, 1, Kind::linear, 3}, {.first = {0}}, {}, control),
               BadInput);
  EXPECT_THROW((void)search_locked({5, 4, 2, Kind::linear, 2}, {}, {}, control),
               ImpossibleParameters);
}

TEST(LockedSearch, ADesignThatLostSomethingIsNotAsWanted) {
  const Wanted wanted{.first = {0, 1, 2}, .expansion_set = true};
  const LockedResult found = searched({12, 4, 1, Kind::linear, 2}, wanted, 22);
  ASSERT_TRUE(found.design);
  std::vector<std::size_t> positions;
  for (const UnchangedSubset& part : found.parts) {
    positions.push_back(part.position);
  }
  const Design& design = found.design->design();
  EXPECT_TRUE(parts_as_wanted(design, wanted, positions));
  Wanted other = wanted;
  other.first = {0, 1, 11};
  EXPECT_FALSE(parts_as_wanted(design, other, positions));
  for (std::size_t& position : positions) {
    const std::size_t there = std::exchange(position, 0);
    EXPECT_FALSE(parts_as_wanted(design, wanted, positions));
    position = positions[0] == 0 ? positions[1] : positions[0];
    EXPECT_FALSE(parts_as_wanted(design, wanted, positions));
    position = there;
  }
  positions.pop_back();
  EXPECT_FALSE(parts_as_wanted(design, wanted, positions));
}

TEST(SegmentPairs, LockedCellsStay) {
  const Parameters p{20, 5, 1, Kind::circular, 2};
  Random random(5);
  const Design start = *random_list(p, 40, random);
  std::vector<LockedCell> locked;
  for (std::uint32_t i = 0; i < 40; i += 7) {
    for (const Element x : start.block(i).first(3)) {
      locked.push_back({i, x});
    }
  }
  SegmentPairs<std::uint8_t> state(start, 0, {.cells = locked, .parts = {}});
  std::size_t made = 0;
  for (int i = 0; i < 20'000; ++i) {
    const SegmentSwap move = state.propose(random);
    made += move.length > 0 && state.attempt(move, [](std::int32_t) { return true; }) ? 1U : 0U;
  }
  EXPECT_GT(made, 5'000U);
  for (const LockedCell& cell : locked) {
    EXPECT_TRUE(state.contains(cell.block, cell.element));
  }
}

}  // namespace
}  // namespace changeover::test::locked_search_test
