// Tables for terminals.
#include "plan/sheet/layout.hpp"

#include <gtest/gtest.h>

#include "changeover/io/tables.hpp"

namespace changeover {
namespace {

TEST(Layout, WideCharactersTakeTwoColumnsAndAccentsNone) {
  EXPECT_EQ(laid_out({{"part"}, {"n", true}},
                     {{{"ポンプ"}, {"1"}}, {{"e\u0301cran"}, {"22"}}, {{"Motor"}, {"3"}}}, 80),
            "part     n\n"
            "ポンプ   1\n"
            "e\u0301cran   22\n"
            "Motor    3\n");
}

TEST(Layout, WideNamesAreBrokenWhereTheLineEnds) {
  const std::string text =
      laid_out({{"set-up"}, {"n", true}}, {{{"モーター", "ポンプ", "ファン"}, {"1"}}}, 22);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    EXPECT_LE(display_width(text.substr(at, end - at)), 22U) << text;
    at = end + 1;
  }
}

}  // namespace
}  // namespace changeover
