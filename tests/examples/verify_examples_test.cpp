// The examples of the headers of verify/, as they stand there.
#include "example_support.hpp"

namespace changeover::test::verify_examples_test {
namespace {

TEST(VerifyExamples, Difference) {
  DifferenceVerdict verdict = verify_differences({{.v = 11, .k = 4}, {{0, 1, 2, 5}}});
  EXPECT_TRUE(verdict.valid() && verdict.tight);
  EXPECT_EQ(verdict.b, 11U);
}

TEST(VerifyExamples, IntervalDifference) {
  IntervalBaseBlocks base{{.v = 21, .k = 4, .kind = Kind::circular}, 0, 2, {4, 12, 2, 7}};
  DifferenceVerdict verdict = verify_differences(base);
  EXPECT_TRUE(verdict.valid() && verdict.tight);
  EXPECT_EQ(verdict.b, 42U);
}

TEST(VerifyExamples, Fans) {
  const Registry& registry = Registry::standard();
  const auto offer = registry.best({.v = 1'000'000, .k = 5, .change = 1});
  const FanVerdict verdict = verify_fans(*registry.fans(offer->recipe));
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.b, 124999874999U);
}

TEST(VerifyExamples, Verdict) {
  const Design design(Parameters{.v = 6, .k = 4},
                      std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 2, 0}});
  DesignSource source(design);
  Verdict verdict = verify(source);
  EXPECT_FALSE(verdict.valid());
  if (!verdict.valid()) {
    EXPECT_EQ(verdict.bad_steps, 1U);
    EXPECT_EQ(verdict.bad_step_examples.front().from, 2U);
    EXPECT_EQ(verdict.uncovered, 2U);
    EXPECT_THAT(verdict.uncovered_examples, ElementsAre(Block{1, 4}, Block{1, 5}));
  }
}

TEST(VerifyExamples, RunningVerdict) {
  const Design design = three_blocks();
  DesignSource source(design);
  const Parameters& parameters = source.parameters();
  std::vector<Element> written;
  const auto write = [&](std::span<const Element> blocks) {
    written.insert(written.end(), blocks.begin(), blocks.end());
  };
  RunningVerdict running(parameters);
  for_each_batch(source, [&](std::span<const Element> blocks) {
    running.add(blocks);
    write(blocks);
  });
  Verdict verdict = running.finish();
  EXPECT_TRUE(verdict.valid());
  EXPECT_THAT(written, SizeIs(12));
}

TEST(VerifyExamples, VerifiedDesign) {
  Design design = three_blocks();
  bool seen = false;
  if (const auto found = verified(std::move(design))) {
    EXPECT_EQ(found->block_count(), 3U);
    EXPECT_TRUE(found->verdict().tight());
    const Design& blocks = *found;  // to read; a copy can be changed, and is no longer verified
    seen = blocks.block_count() == 3;
  }
  EXPECT_TRUE(seen);
  EXPECT_FALSE(verified(Design(Parameters{.v = 6, .k = 4}, std::vector<Block>{{0, 1, 2, 3}})));
}

}  // namespace
}  // namespace changeover::test::verify_examples_test
