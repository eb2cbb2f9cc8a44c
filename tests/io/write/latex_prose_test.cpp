#include "io/write/latex_prose.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace changeover::latex_prose_test {
namespace {

// On pages signs are signs, and a text is nothing but text.
TEST(LatexProse, IsHtmlAndMarkdownToo) {
  EXPECT_EQ(html_prose("b >= n_j & <x>"), "<i>b</i> ≥ <i>n</i><sub><i>j</i></sub> &amp; &lt;x&gt;");
  EXPECT_EQ(html_prose("b >= ceil((15 - 6) / 5) + 1 = 3"), "<i>b</i> ≥ ⌈(15 − 6) / 5⌉ + 1 = 3");
  EXPECT_EQ(html_prose("over Z_{15} by x ↦ x + 1"),
            "over <i>Z</i><sub>15</sub> by <i>x</i> ↦ <i>x</i> + 1");
  EXPECT_EQ(html_prose("x is where j, i.e. a block(s), took 2 s (y)"),
            "<i>x</i> is where <i>j</i>, i.e. a block(s), took 2 s (<i>y</i>)");
  EXPECT_EQ(html_prose("(modulo gcd(k-1,m) = 2)"), "(modulo gcd(<i>k</i> − 1, <i>m</i>) = 2)");
  EXPECT_EQ(html_prose("2026-11-21, --time 2s"), "2026-11-21, --time 2s");
  EXPECT_EQ(markdown_prose("ab_c * [x]"), "ab\\_c \\* \\[x\\]");
  EXPECT_EQ(markdown_prose("i_x <= 3"), "i<sub>x</sub> ≤ 3");
}

TEST(LatexProse, MakesMathematicsOfSignsAndIndices) {
  EXPECT_EQ(latex_prose("b >= 3"), "$b \\geq 3$");
  EXPECT_EQ(latex_prose("i_x(k-1)"), "$i_{x}(k - 1)$");
  EXPECT_EQ(latex_prose("over Z_15, K_{22}"), "over $Z_{15}$, $K_{22}$");
  EXPECT_EQ(latex_prose("put ∞_s and i_l"), "put $\\infty_{s}$ and $i_{l}$");
  EXPECT_EQ(latex_prose("k²"), "$k^{2}$");
  EXPECT_EQ(latex_prose("U₁ ∪ {x}"), "U${}_{1}$ $\\cup$ \\{x\\}");
  EXPECT_EQ(latex_prose("ceil((8-5)/2) = 2 (so)"), "$\\lceil (8 - 5) / 2\\rceil = 2$ (so)");
  EXPECT_EQ(latex_prose("ceil(a + ceil(b)) + c)"), "$\\lceil a + \\lceil b\\rceil\\rceil + c$)");
}

TEST(LatexProse, MakesMathematicsOfWholeFormulas) {
  EXPECT_EQ(latex_prose("at most 5 of C(12,2) = 66 pairs: b >= ⌈66 / 5⌉ = 14 (so)"),
            "at most 5 of $C(12, 2) = 66$ pairs: $b \\geq \\lceil 66 / 5\\rceil = 14$ (so)");
  EXPECT_EQ(latex_prose("2*n1 + n2 <= 3k = 12 where n_j elements"),
            "$2 \\cdot n_{1} + n_{2} \\leq 3k = 12$ where $n_{j}$ elements");
  EXPECT_EQ(latex_prose("so k + m(b-1) ≥ 3v - 3k = 24: all"),
            "so $k + m(b - 1) \\geq 3v - 3k = 24$: all");
  EXPECT_EQ(latex_prose("modulo gcd(k-1,m) = 2"), "modulo $\\gcd(k - 1, m) = 2$");
  EXPECT_EQ(latex_prose("the gcd of k and m"), "the gcd of k and m");
  EXPECT_EQ(latex_prose("v = 7, k = 3.5."), "$v = 7$, $k = 3.5$.");
  EXPECT_EQ(latex_prose("x + (y"), "x + (y");
}

TEST(LatexProse, TakesNoWordsForFormulas) {
  for (const std::string same :
       {"a DCCD(12,4) with 14 blocks", "2026-11-21", "1/2 of it", "a k-set", "and/or", "e-mail",
        "the 12th", "1-factorization", "a 2-(7,3,1) design", "v1.2.3-4", "docs/theorems.md",
        "block(s)", "12.4.2.circular", "a block a step", "3-change"}) {
    EXPECT_EQ(latex_prose(same), same);
  }
  EXPECT_EQ(latex_prose("search --change 2"), "search -{}-change 2");
}

TEST(LatexProse, LinesMayEndWithinSets) {
  EXPECT_EQ(latex_prose("the base block {0,1,12} of (12,4)"),
            "the base block \\{0,\\allowbreak 1,\\allowbreak 12\\} of (12,4)");
}

TEST(LatexProse, LeavesWordsAsTheyAre) {
  EXPECT_EQ(latex_prose("50 % of a_file & #1"), "50 \\% of a\\_file \\& \\#1");
  EXPECT_EQ(latex_prose("file_name, x_"), "file\\_name, x\\_");
  EXPECT_EQ(latex_prose("x_{a b}"), "x\\_\\{a b\\}");
  EXPECT_EQ(latex_prose("Füredi …"), "Füredi …");
  EXPECT_EQ(latex_prose(""), "");
}

TEST(LatexProse, CitesWhatThereIsAKeyFor) {
  const std::vector<std::string> keys{"Ab2025", "Ab20"};
  EXPECT_EQ(latex_prose("[Ab2025, Theorem 2]", keys), "\\cite[{Theorem 2}]{Ab2025}");
  EXPECT_EQ(latex_prose("by [Ab20].", keys), "by \\cite{Ab20}.");
  EXPECT_EQ(latex_prose("[Ab2025, Theorem 2]"), "[Ab2025, Theorem 2]");
  EXPECT_EQ(latex_prose("[Ab2025", keys), "[Ab2025");
  EXPECT_EQ(latex_prose("[Other, 1]", keys), "[Other, 1]");
}

// Dollars come in pairs and braces close, whatever is written; so nothing runs into the text behind
// it.
RC_GTEST_PROP(LatexProseProperty, ClosesWhatItOpens, ()) {
  const std::vector<std::string> pieces{
      "b",  ">=", "_", "x", "{", "}",  "(",      ")", "ceil(", "[K", "]", ", ", "∞",  "²", "$",
      "\\", "12", "Σ", " ", "%", "a_", "_{1,2}", "+", "-",     "=",  "⌈", "⌉",  "C(", "a"};
  const auto chosen = *rc::gen::container<std::vector<std::size_t>>(
      rc::gen::inRange<std::size_t>(0, pieces.size()));
  std::string text;
  for (const std::size_t i : chosen) {
    text += pieces[i];
  }
  const std::string latex = latex_prose(text, {"K"});
  int open = 0;
  bool in_math = false;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    if (latex[i] == '\\') {
      ++i;  // A command, or an escaped sign.
    } else if (latex[i] == '$') {
      in_math = !in_math;
    } else if (latex[i] == '{' || latex[i] == '}') {
      open += latex[i] == '{' ? 1 : -1;
      RC_ASSERT(open >= 0);
    } else {
      RC_ASSERT(latex[i] != '%');
    }
  }
  RC_ASSERT(open == 0);
  RC_ASSERT(!in_math);
}

}  // namespace
}  // namespace changeover::latex_prose_test
