// The examples of the headers of bounds/, as they stand there.
#include <iostream>

#include "example_support.hpp"

namespace changeover::test::bounds_examples_test {
namespace {

TEST(BoundsExamples, LowerBound) {
  StandardOutput output;
  for (const Bound& bound : lower_bounds({.v = 8, .k = 5, .kind = Kind::circular})) {
    std::cout << bound.blocks << "  " << bound.reason << '\n';  // plain mathematics, one line each
  }
  const std::string lines = output.take();
  const Bound largest = lower_bound({.v = 8, .k = 5, .kind = Kind::circular});
  EXPECT_EQ(lower_bound({.v = 8, .k = 5, .kind = Kind::circular}).blocks, largest.blocks);
  EXPECT_THAT(lines, testing::StartsWith(std::to_string(largest.blocks) + "  " + largest.reason));
  EXPECT_GE(std::ranges::count(lines, '\n'), 2);
}

}  // namespace
}  // namespace changeover::test::bounds_examples_test
