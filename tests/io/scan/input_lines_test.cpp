#include "io/scan/input_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace changeover::input_lines_test {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> lines_of(const std::string& text, std::size_t longest = 100) {
  const auto input = input_from_text(text, "f");
  InputLines lines(*input, longest);
  std::vector<std::string> all;
  auto next = lines.next();
  for (; next == InputLines::Next::line; next = lines.next()) {
    all.emplace_back(lines.line());
    EXPECT_EQ(lines.number(), all.size());
  }
  if (next == InputLines::Next::too_long) {
    all.emplace_back("too long");
  } else {
    EXPECT_EQ(lines.bytes(), text.size());
    EXPECT_EQ(lines.next(), InputLines::Next::end);
  }
  return all;
}

TEST(InputLines, HaveNoEndsAndNoByteOrderMark) {
  EXPECT_THAT(lines_of(""), ElementsAre());
  EXPECT_THAT(lines_of("\n"), ElementsAre(""));
  EXPECT_THAT(lines_of("a\r\n\nb"), ElementsAre("a", "", "b"));
  EXPECT_THAT(lines_of("a\r\n\nb\n"), ElementsAre("a", "", "b"));
  EXPECT_THAT(lines_of("\xEF\xBB\xBF"
                       "a\n\xEF\xBB\xBF"
                       "b"),
              ElementsAre("a",
                          "\xEF\xBB\xBF"
                          "b"));
}

TEST(InputLines, MayBeLongerThanAPieceAndEndAnywhereInOne) {
  for (const std::size_t length : {262'142U, 262'143U, 262'144U, 262'145U, 600'000U}) {
    const std::string line(length, 'x');
    std::string text = line;
    text.append("\nb\n").append(line);
    EXPECT_THAT(lines_of(text, 1'000'000), ElementsAre(line, "b", line));
  }
}

TEST(InputLines, AreRefusedAboveALength) {
  const std::string longest(100, 'x');
  EXPECT_THAT(lines_of(longest + "\nb"), ElementsAre(longest, "b"));
  EXPECT_THAT(lines_of("a\nx" + longest + "\nb"), ElementsAre("a", "too long"));
  EXPECT_THAT(lines_of(std::string(1'000'000, 'x')), ElementsAre("too long"));
}

}  // namespace
}  // namespace changeover::input_lines_test
