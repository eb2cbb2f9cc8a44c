#include "core/lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace changeover::lines_test {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> found;
  for (Lines lines(text); lines.next();) {
    found.emplace_back(lines.line());
    EXPECT_EQ(lines.number(), found.size());
  }
  return found;
}

TEST(Lines, EndAtLineFeedsOrWithTheText) {
  EXPECT_TRUE(lines_of("").empty());
  EXPECT_EQ(lines_of("a"), std::vector<std::string>{"a"});
  EXPECT_EQ(lines_of("a\n"), std::vector<std::string>{"a"});
  EXPECT_EQ(lines_of("\n\na\r\nb"), (std::vector<std::string>{"", "", "a\r", "b"}));
}

}  // namespace
}  // namespace changeover::lines_test
