#include "io/scan/base64.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace changeover::base64_test {
namespace {

// The test vectors of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  const std::string word = "foobar";
  const std::vector<std::string> texts{"",         "Zg==",     "Zm8=",    "Zm9v",
                                       "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t size = 0; size <= word.size(); ++size) {
    EXPECT_EQ(base64_of(word.substr(0, size)), texts[size]);
    EXPECT_EQ(from_base64(texts[size]), word.substr(0, size));
    EXPECT_EQ(from_base64(texts[size].substr(0, texts[size].find('='))), word.substr(0, size));
  }
}

TEST(Base64, RefusesWhatNoBytesAre) {
  for (const char* text : {"Z", "Zg=", "Zh==", "Zm9=", "Zm9v=", "====", "Zg==Zg==", "Zm 9v",
                           "Zm9v\n", "Zm-v", "=Zg="}) {
    EXPECT_EQ(from_base64(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(Base64, IsReadBack, (const std::string& bytes)) {
  RC_ASSERT(from_base64(base64_of(bytes)) == bytes);
}

}  // namespace
}  // namespace changeover::base64_test
