#include "core/words.hpp"

#include <gtest/gtest.h>

namespace changeover::words_test {
namespace {

TEST(Words, SeveralMessagesAreOneLine) {
  EXPECT_EQ(leading_defect({"no file; name one"}), "no file; name one");
  EXPECT_EQ(leading_defect({"no file; name one", "b", "c"}),
            "no file (and 2 more like this); name one");
  EXPECT_EQ(leading_defect({"no file", "no file"}), "no file (and 1 more like this)");
  // A name may have what sets the remedy off.
  EXPECT_EQ(leading_defect({"'a; b' is twice; leave one out", "c"}),
            "'a; b' is twice (and 1 more like this); leave one out");
}

}  // namespace
}  // namespace changeover::words_test
