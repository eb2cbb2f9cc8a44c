#include "changeover/core/design.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::transitions_test {
namespace {

Block copy(std::span<const Element> elements) { return {elements.begin(), elements.end()}; }

const std::vector<Block> blocks{{0, 1, 2}, {0, 4, 5}, {2, 4, 3}};

TEST(Transitions, MarkTheEndsOfALinearDesign) {
  const Design design({.v = 6, .k = 3}, blocks);
  DesignSource source(design);
  Transitions steps(source);
  ASSERT_TRUE(steps.next());
  EXPECT_EQ(copy(steps.introduced()), (Block{0, 1, 2}));
  EXPECT_EQ(copy(steps.leaving()), (Block{1, 2}));
  ASSERT_TRUE(steps.next());
  EXPECT_EQ(steps.index(), 1U);
  EXPECT_EQ(copy(steps.introduced()), (Block{4, 5}));
  EXPECT_EQ(copy(steps.leaving()), (Block{0, 5}));
  ASSERT_TRUE(steps.next());
  EXPECT_EQ(copy(steps.introduced()), (Block{2, 3}));
  EXPECT_EQ(copy(steps.leaving()), (Block{2, 4, 3}));
  EXPECT_FALSE(steps.next());
  EXPECT_FALSE(steps.next());
}

TEST(Transitions, OfACircleNeedItsBlocksTwice) {
  class Once final : public BlockSource {
   public:
    const Parameters& parameters() const override { return parameters_; }
    std::span<const Element> read(std::span<Element>) override { return {}; }

   private:
    Parameters parameters_{.v = 4, .k = 3, .change = 1, .kind = Kind::circular};
  };
  Once source;
  EXPECT_REFUSAL(Transitions{source}, BadInput,
                 "the marks of a circular design need its blocks twice: read it into memory first");
}

TEST(Transitions, CloseTheCircle) {
  const Design design({.v = 6, .k = 3, .kind = Kind::circular}, blocks);
  DesignSource source(design);
  Transitions steps(source);
  ASSERT_TRUE(steps.next());
  EXPECT_EQ(copy(steps.introduced()), (Block{0, 1}));
  ASSERT_TRUE(steps.next());
  ASSERT_TRUE(steps.next());
  EXPECT_EQ(copy(steps.leaving()), (Block{4, 3}));
}

TEST(Transitions, TakeASingleBlockAsItsOwnBeginningAndEnd) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const Design design({.v = 3, .k = 3, .kind = kind}, std::vector<Block>{{0, 1, 2}});
    DesignSource source(design);
    Transitions steps(source);
    ASSERT_TRUE(steps.next());
    EXPECT_EQ(steps.introduced().size(), 3U);
    EXPECT_EQ(steps.leaving().size(), 3U);
    EXPECT_FALSE(steps.next());
    EXPECT_TRUE(unchanged_subsets(design).empty());
  }
}

TEST(Transitions, OfAnEmptyStreamAreNone) {
  const Design design({.v = 3, .k = 3});
  DesignSource source(design);
  EXPECT_FALSE(Transitions(source).next());
}

TEST(UnchangedSubsets, StandBetweenBlocks) {
  Design design({.v = 6, .k = 3}, blocks);
  const std::vector<UnchangedSubset> linear{{1, {0}}, {2, {4}}};
  EXPECT_EQ(unchanged_subsets(design), linear);
  design.set_kind(Kind::circular);
  const std::vector<UnchangedSubset> circular{{1, {0}}, {2, {4}}, {3, {2}}};
  EXPECT_EQ(unchanged_subsets(design), circular);
}

}  // namespace
}  // namespace changeover::transitions_test
