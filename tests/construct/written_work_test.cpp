#include <gtest/gtest.h>

#include "construct/references.hpp"

namespace changeover::written_work_test {
namespace {

TEST(WrittenWork, IsALineOfAListOfReferences) {
  EXPECT_EQ(written_work("ChafeeStevens2025"),
            "A. L. Chafee and B. Stevens. Recursive and Cyclic Constructions for "
            "Double-Change Covering Designs. Journal of Combinatorial Designs, 2025");
  EXPECT_EQ(written_work("McSorley1999"),
            "J. P. McSorley. Single-Change Circular Covering Designs. Discrete Mathematics "
            "197/198, 1999");
  EXPECT_TRUE(
      written_work("PreeceEtAl1995").ends_with("Utilitas Mathematica 47, 1995, pages 55–84"))
      << written_work("PreeceEtAl1995");
  EXPECT_TRUE(written_work("Phillips1999").starts_with("N. C. K. Phillips et al. "));
  EXPECT_EQ(written_work("Nobody1900"), "");
}

// A DOI stays, preprints and pages may move.
TEST(WrittenWork, IsReadAtItsDoiElseItsPreprintElseItsPage) {
  EXPECT_EQ(address_of_work("ChafeeStevens2025"), "https://doi.org/10.1002/jcd.70000");
  EXPECT_EQ(address_of_work("ChafeeStevens2023"), "https://arxiv.org/abs/2209.11010");
  EXPECT_EQ(address_of_work("PreeceEtAl1995"), "https://opensiuc.lib.siu.edu/math_articles/134");
  EXPECT_EQ(address_of_work("McSorley1999"), "");
}

}  // namespace
}  // namespace changeover::written_work_test
