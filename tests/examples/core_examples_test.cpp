// The examples of the headers of core/, as they stand there.
#include <iostream>

#include "example_support.hpp"

namespace changeover::test::core_examples_test {
namespace {

TEST(CoreExamples, Block) {
  const Design design = three_blocks();
  DesignSource source(design);
  StandardOutput output;
  std::vector<Element> block(source.parameters().k);
  while (source.next(block)) {
    std::cout << block.front() << '\n';  // or whatever is to be done with a block
  }
  source.rewind();
  for_each_block(source, [](std::span<const Element> each) {  // the same, faster: in batches
    std::cout << each.front() << '\n';
  });
  EXPECT_EQ(output.take(), "0\n4\n4\n0\n4\n4\n");
}

// The multiples of 3, two after two.
class Mine final : public BlockByBlock<Mine> {
 public:
  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  bool make(std::span<Element> block);  // writes the next block; false at the end, and ever after

 private:
  Parameters parameters_{.v = 12, .k = 2};
  Element next_ = 0;
};

bool Mine::make(std::span<Element> block) {
  if (next_ + 3 >= parameters_.v) {
    return false;
  }
  block[0] = next_;
  block[1] = next_ += 3;
  return true;
}

TEST(CoreExamples, BlockByBlock) {
  Mine mine;
  EXPECT_THAT(read_all(mine).elements(), ElementsAre(0U, 3U, 3U, 6U, 6U, 9U));
}

TEST(CoreExamples, Design) {
  Design design(Parameters{.v = 6, .k = 4, .kind = Kind::circular},
                std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  EXPECT_THAT(design.block(1), ElementsAre(4U, 5U, 2U, 3U));
  DesignSource source(design);  // the same as a stream
  const Design again = read_all(source);
  EXPECT_TRUE(std::ranges::equal(again.elements(), design.elements()));
}

TEST(CoreExamples, Recipe) {
  Recipe cyclic{"cyclic-paper", {.v = 7, .k = 3, .kind = Kind::circular}, {{"c", 1}}, {}, {}};
  const Parameters expanded{.v = 15, .k = 3, .kind = Kind::circular};
  Recipe recipe{"expansion", expanded, {{"w", 8}}, {cyclic}, {}};
  EXPECT_TRUE(verify(*Registry::standard().build(recipe)).tight());
}

TEST(CoreExamples, Transitions) {
  const Design design = three_blocks();
  std::vector<Block> drawn;
  const auto draw = [&](std::span<const Element> block, std::span<const Element> introduced,
                        std::span<const Element> leaving) {
    EXPECT_THAT(block, SizeIs(4));
    EXPECT_THAT(leaving, SizeIs(2));
    drawn.emplace_back(introduced.begin(), introduced.end());
  };
  DesignSource source(design);
  for (Transitions steps(source); steps.next();) {
    draw(steps.block(), steps.introduced(), steps.leaving());
  }
  EXPECT_THAT(drawn, ElementsAre(Block{2, 3}, Block{4, 5}, Block{0, 1}));
}

TEST(CoreExamples, Developed) {
  DevelopedSource source({{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}});
  EXPECT_EQ(source.block_count(), 11U);
  EXPECT_TRUE(verify(source).tight());
}

TEST(CoreExamples, Automorphism) {
  const Block block{6, 7, 28};
  const Automorphism pi{.n = 7, .cycles = 4, .fixed = 1};  // (0 … 6)(7 … 13)(14 … 20)(21 … 27)(28)
  EXPECT_EQ(pi.v(), 29U);
  EXPECT_EQ(pi.image(6, 1), 0U);
  EXPECT_THAT(pi.image(block, 3), ElementsAre(2U, 10U, 28U));
}

TEST(CoreExamples, IntervalBaseBlocks) {
  IntervalBaseBlocks base{{.v = 21, .k = 4, .kind = Kind::circular}, 0, 2, {4, 12, 2, 7}};
  IntervalDevelopedSource source(base);  // the 42 blocks
  EXPECT_EQ(source.block_count(), 42U);
  EXPECT_TRUE(verify_differences(base).tight);
  EXPECT_TRUE(verify(source).tight());
}

class CoreExampleFiles : public InAFolder {};

TEST_F(CoreExampleFiles, Error) {
  put("mine.txt", "0 1 2\n0 1 1\n");
  testing::internal::CaptureStderr();
  try {
    Design design = read_design("mine.txt");
  } catch (const BadInput& fault) {     // the file or the number that was given
    std::cerr << fault.what() << '\n';  // one line: what, where, how to mend it
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::StartsWith("mine.txt:2:"));
}

TEST(CoreExamples, Fans) {
  const Block kept{1, 4, 7};
  const Fan fan{kept, 10, 12};
  EXPECT_EQ(fan.block_count(), 3U);
}

TEST(CoreExamples, PairSet) {
  const std::uint64_t v = 10;
  std::vector<std::pair<Element, Element>> printed;
  const auto print = [&](Element x, Element y) { printed.emplace_back(x, y); };
  PairSet covered(v);
  covered.insert(3, 7);
  EXPECT_EQ(covered.missing(), 44U);
  covered.for_each_missing(20, print);
  EXPECT_THAT(printed, SizeIs(20));
  EXPECT_EQ(printed.back(), std::pair(Element{4}, Element{6}));
}

TEST(CoreExamples, Parameters) {
  Parameters p{.v = 61, .k = 4, .change = 2, .kind = Kind::circular};
  check(p);                            // throws when no such list of blocks could be written down
  auto g2 = newly_covered_at_most(p);  // 2k − 3 = 5 pairs a block
  EXPECT_EQ(g2, 5U);
}

TEST(CoreExamples, Sha256) {
  Sha256 hash;
  hash.add("ab");
  hash.add("c");
  EXPECT_EQ(to_hex(hash.finish()),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(CoreExamples, Version) {
  StandardOutput output;
  std::cout << changeover::version << '\n';
  static_assert(CHANGEOVER_VERSION >= 10000);
  EXPECT_THAT(output.take(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace changeover::test::core_examples_test
