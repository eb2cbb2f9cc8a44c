#include "core/small_letters.hpp"

#include <gtest/gtest.h>

namespace changeover::small_letters_test {
namespace {

TEST(InSmallLetters, FoldsTheCapitalsOfThreeAlphabets) {
  EXPECT_EQ(in_small_letters("Lab ÄÖÜ ÇŸĀŁŽ ΑΩ АЯЁ Ａ"), U"lab äöü çÿāłž αω аяё ａ");
  EXPECT_EQ(in_small_letters("lab äß×÷ ı 漢"), U"lab äß×÷ ı 漢");
  EXPECT_EQ(in_small_letters("A\xff"), std::u32string(U"a\0", 2));
  EXPECT_EQ(in_small_letters(""), U"");
}

}  // namespace
}  // namespace changeover::small_letters_test
