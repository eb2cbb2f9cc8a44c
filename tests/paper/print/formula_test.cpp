#include "paper/print/formula.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::formula_test {
namespace {

Fraction at(std::string_view formula, const Values& values = {}) {
  return value_of(formula, values);
}

TEST(Formula, evaluates_as_it_is_read) {
  EXPECT_EQ(at("2+3"), (Fraction{5, 1}));
  EXPECT_EQ(at("7-2-1"), (Fraction{4, 1}));
  EXPECT_EQ(at("-3+1"), (Fraction{-2, 1}));
  EXPECT_EQ(at("2(3+4)"), (Fraction{14, 1}));
  EXPECT_EQ(at("v(v-1)/2", {{'v', 6}}), (Fraction{15, 1}));
  EXPECT_EQ(at("2c^2 (k - 1) + c", {{'c', 3}, {'k', 4}}), (Fraction{57, 1}));
  EXPECT_EQ(at("(l^2+l)/2", {{'l', 5}}), (Fraction{15, 1}));
  EXPECT_EQ(at("(2v-2)/3", {{'v', 6}}), (Fraction{10, 3}));
  EXPECT_EQ(at(R"(\frac{1}{2}\frac{v}{k-2}(\frac{v}{k-2}+1))", {{'v', 7}, {'k', 3}}),
            (Fraction{28, 1}));
  EXPECT_EQ(at(R"(\frac{\binom{v}{2}-\binom{k}{2}}{2k-3}+1)", {{'v', 8}, {'k', 6}}),
            (Fraction{22, 9}));
  EXPECT_EQ(at(R"(\ceiling{(v^2-v-12)/10}+1)", {{'v', 7}}), (Fraction{4, 1}));
  EXPECT_EQ(at(R"(\ceiling{-3/2})"), (Fraction{-1, 1}));
}

TEST(Formula, says_what_a_fraction_is) {
  EXPECT_EQ((Fraction{28, 9}).to_string(), "28/9");
  EXPECT_EQ((Fraction{-4, 1}).to_string(), "-4");
  EXPECT_EQ((Fraction{28, 9}).ceiling(), 4);
  EXPECT_EQ((Fraction{27, 9}).ceiling(), 3);
  EXPECT_FALSE((Fraction{28, 9}).count());
  EXPECT_FALSE((Fraction{-1, 1}).count());
  EXPECT_EQ((Fraction{3, 1}).count(), 3U);
}

TEST(Formula, refuses_what_it_cannot_read) {
  for (const auto& [wrong, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "formula \"\", character 1: it ends here"},
           {"v", "formula \"v\", character 1: no value is known for this"},
           {"2+", "formula \"2+\", character 3: it ends here"},
           {"(2", ""},
           {"2)", "formula \"2)\", character 2: nothing is expected here"},
           {R"(\frac{1})", ""},
           {R"(\frac{1}{0})", "a division by zero"},
           {"1/0", "formula \"1/0\", character 4: a division by zero"},
           {R"(\binom{1/2}{2})", "a binomial coefficient takes whole numbers"},
           {R"(\sqrt{2})", "no value is known for this"},
           {"2;3", "formula \"2;3\", character 2: nothing is expected here"},
           {"2^(1/2)", "formula \"2^(1/2)\", character 8: an exponent is a small whole number"},
           {"2^99", "formula \"2^99\", character 5: an exponent is a small whole number"},
           {"1_2", ""}}) {
    EXPECT_REFUSAL((void)at(wrong), BadInput, words) << wrong;
  }
  EXPECT_REFUSAL((void)at(std::string(1000, '(')), BadInput, "nested too deeply");
  EXPECT_THROW((void)at("99999999999999999999"), ImpossibleParameters);
  EXPECT_THROW((void)at("v^9", {{'v', 1U << 31}}), ImpossibleParameters);
}

}  // namespace
}  // namespace changeover::formula_test
