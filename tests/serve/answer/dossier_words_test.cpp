// Sentences as dossiers write and set them.
#include <gtest/gtest.h>

#include "answer/dossier/dossier_math.hpp"
#include "answer/dossier/dossier_setting.hpp"
#include "answer/dossier/dossier_words.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover::dossier_words_test {
namespace {

using namespace cli;

TEST(DossierWords, TheoremsOfTheProgramAreCitedInAnyBrackets) {
  EXPECT_EQ(for_paper("so few (docs/theorems.md, Theorem 5)"),
            "so few [ChangeoverTheorems, Theorem 5]");
  EXPECT_EQ(for_paper("[docs/theorems.md, Theorem 15]"), "[ChangeoverTheorems, Theorem 15]");
  EXPECT_EQ(for_paper("[McSorley1999, docs/theorems.md, Theorem 6]"),
            "[McSorley1999] [ChangeoverTheorems, Theorem 6]");
  EXPECT_EQ(for_paper("see docs/theorems.md."), "see [ChangeoverTheorems].");
}

TEST(DossierWords, CommandsStandBetweenBackticks) {
  EXPECT_EQ(for_paper("changeover search 9 5 --exact --proof DIR"),
            "`changeover search 9 5 --exact --proof DIR`");
  EXPECT_EQ(for_paper("Found with changeover design 61 4, later."),
            "Found with `changeover design 61 4`, later.");
  EXPECT_EQ(for_paper("the changeover of parts"), "the changeover of parts");
  const std::vector<std::pair<std::string, bool>> pieces{{"a ", false}, {"b", true}, {" c", false}};
  EXPECT_EQ(pieces_of("a `b` c"), pieces);
}

TEST(DossierWords, ATheoremIsQuotedOnceAndWithoutLinks) {
  const auto quoted = cited_theorems(
      {"[ChangeoverTheorems, Theorem 39]", "x [ChangeoverTheorems, Theorem 39] y", "nothing"});
  ASSERT_EQ(quoted.size(), 1U);
  EXPECT_EQ(quoted[0].number, "39");
  EXPECT_NE(quoted[0].statement.find("2⌈m/(k−m)⌉ + 1"), std::string::npos);
  EXPECT_EQ(quoted[0].statement.find("]("), std::string::npos);
}

TEST(DossierWords, FormulasAreNotBroken) {
  EXPECT_EQ(unbroken("b ≥ ⌈(40 − 6) / 2⌉"), "b\u00a0≥\u00a0⌈(40\u00a0−\u00a06)\u00a0/\u00a02⌉");
  EXPECT_EQ(unbroken("2x and 2026-11-21"), "2<i>x</i> and <span>2026-11-21</span>");
  EXPECT_EQ(unbroken("(words in brackets)"), "(words in brackets)");
  EXPECT_EQ(unbroken_code("search --base-blocks 5"), "search <span>--base-blocks</span> 5");
  EXPECT_EQ(with_letters_set("an element x, and 2x"), "an element $x$, and $2x$");
}

TEST(DossierWords, BinomialsAndSumsAreSet) {
  const auto set = [](std::string_view words) { return with_mathml(unbroken(html_prose(words))); };
  EXPECT_EQ(set("at most C(43,2) = 903"),
            "at most <math><mrow><mo maxsize=\"1.8em\">(</mo><mfrac linethickness=\"0\">"
            "<mrow><mn>43</mn></mrow><mrow><mn>2</mn></mrow></mfrac>"
            "<mo maxsize=\"1.8em\">)</mo></mrow></math>\u00a0=\u00a0903");
  EXPECT_NE(set("C(c_x + 1, 2)").find("<msub><mi>c</mi><mrow><mi>x</mi></mrow></msub><mo>+</mo>"),
            std::string::npos);
  EXPECT_NE(set("Σ_x i_x").find("<munder>"), std::string::npos);
  for (const std::string_view plain : {"a (b) C", "C(v", "C(v)", "DCCD(43,6)", "b ≥ ⌈903 / 9⌉"}) {
    EXPECT_EQ(set(plain).find("<math>"), std::string::npos) << plain;
  }
}

}  // namespace
}  // namespace changeover::dossier_words_test
