// The example of changeover.hpp, as it stands there.
#include <iostream>

#include "example_support.hpp"

namespace changeover::test::changeover_examples_test {
namespace {

TEST(ChangeoverExamples, TheWholeDoor) {
  StandardOutput output;
  check(Parameters{.v = 61, .k = 4});
  std::cout << version << '\n';
  EXPECT_EQ(output.take(), std::string(version) + "\n");
}

}  // namespace
}  // namespace changeover::test::changeover_examples_test
