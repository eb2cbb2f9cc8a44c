#include "changeover/plan/job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "changeover/core/error.hpp"

namespace changeover::amount_test {
namespace {

TEST(Amount, IsReadExactlyAndWrittenLikeMoney) {
  const std::vector<std::pair<std::string, std::string>> cases{{"0", "0"},
                                                               {"3", "3"},
                                                               {"12.5", "12.50"},
                                                               {"12.50", "12.50"},
                                                               {".5", "0.50"},
                                                               {"5.", "5"},
                                                               {"0.125", "0.125"},
                                                               {"007", "7"},
                                                               {"1.000", "1"},
                                                               {"0.000001", "0.000001"},
                                                               {"9000000000000", "9000000000000"}};
  for (const auto& [given, written] : cases) {
    EXPECT_EQ(to_string(parse_amount(given)), written) << given;
  }
  EXPECT_EQ(to_string(parse_amount("3"), 2), "3.00");
  EXPECT_EQ(to_string(parse_amount("0.1") + parse_amount("0.2")), "0.30");
  EXPECT_EQ(to_string(parse_amount("0.01") * 12), "0.12");
}

TEST(Amount, RefusesWhatIsNoCost) {
  for (const char* given : {"", ".", "-1", "-0", "+1", "1,50", "1e3", "abc", "1.2.3", " 1", "1 ",
                            "0.0000001", "$5", "nan"}) {
    EXPECT_THROW((void)parse_amount(given), BadInput) << given;
  }
}

TEST(Amount, RefusesToOverflow) {
  EXPECT_THROW((void)parse_amount("9300000000000"), ImpossibleParameters);
  EXPECT_THROW((void)parse_amount("99999999999999999999999"), ImpossibleParameters);
  const Amount large = parse_amount("9000000000000");
  EXPECT_THROW((void)(large + large), ImpossibleParameters);
  EXPECT_THROW((void)(large * 2), ImpossibleParameters);
  try {
    (void)(parse_amount("1") - parse_amount("2"));
    ADD_FAILURE() << "an amount became negative";
  } catch (const BadOption& fault) {
    EXPECT_STREQ(fault.what(),
                 "a larger amount cannot be subtracted from a smaller one; compare them first");
  }
}

RC_GTEST_PROP(Amount, SurvivesWritingAndReading, (std::uint32_t whole, std::uint32_t part)) {
  const Amount amount{std::uint64_t{whole} * 1'000'000 + part % 1'000'000};
  RC_ASSERT(parse_amount(to_string(amount)) == amount);
  RC_ASSERT(parse_amount(to_string(amount, 6)) == amount);
}

TEST(Amount, SaysThatACostIsTooLargeAndWhatToDo) {
  for (const std::string& given :
       {std::string("9223372036854775807"), std::string("18446744073709551615"),
        "1" + std::string(400, '0'), std::string(100'000, '9'),
        std::string("9223372036854.775808")}) {
    try {
      (void)parse_amount(given);
      ADD_FAILURE() << given;
    } catch (const ImpossibleParameters& fault) {
      EXPECT_THAT(fault.what(), testing::HasSubstr("use a larger unit"));
      EXPECT_LT(std::string(fault.what()).size(), 200U);
    }
  }
  EXPECT_EQ(to_string(parse_amount("9223372036854.775807")), "9223372036854.775807");
}

}  // namespace
}  // namespace changeover::amount_test
