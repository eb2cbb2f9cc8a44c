// changeover dossier: one design for a paper; LaTeX of tables and bounds; what stands beside
// proofs.
#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "cases.hpp"

namespace changeover::test::dossier_test {
namespace {

using testing::HasSubstr;

TEST(Dossier, SaysWhatAPaperNeeds) {
  const TemporaryFolder folder;
  expect(
      {{"$changeover dossier 8 5", 0, "# A circular DCCD(8,5) with 5 blocks"},
       {"$changeover dossier 8 5 --linear", 0, "No linear DCCD(8,5) has fewer than"},
       {"$changeover dossier 20 5", 0,
        "has exactly 2 elements that are not in the block before it; the first block follows the "
        "last."},
       {"$changeover dossier 20 5", 0,
        "Here i<sub>x</sub> is the number of blocks that introduce x"},
       {"$changeover dossier 20 5 --change 1", 0, "exactly 1 element that is not in the block"},
       {"$changeover dossier 13 13 --linear", 0, "are together in some block.\n\n| | |\n"},
       {"$changeover dossier 40 6 --circular", 0, "| quality | 1 block over the lower bound |"},
       {"$changeover dossier 40 6 --circular", 0, "| excess | 12 |"},
       {"$changeover dossier 61 4", 0, "| order of its group | 61 |"},
       {"$changeover dossier 40 6 --circular", 0, "\n> **Theorem 15**"},
       {"$changeover dossier 40 6 --circular", 0, "Constructed as above"},
       {"$changeover dossier 40 6 --format latex", 0, "\\cite[{Theorem 15}]{ChangeoverTheorems}"},
       {"$changeover dossier 40 6 --format latex", 0, "@misc{ChangeoverTheorems,"},
       {"$changeover dossier 40 6 --format latex", 0, "by $2x$ and $2x + 1$"},
       {"$changeover dossier 40 6 --format latex", 0, "\\texttt{changeover search 28 6"},
       {"$changeover dossier 40 6 --format html", 0, "⌈(40\u00a0−\u00a06)\u00a0/\u00a02⌉"},
       {"$changeover dossier 40 6 --format html", 0, "{0,3,7,12,15,21}"},
       {"$changeover dossier 40 6 --format html", 0, "<a href=\"#theorem-15\">Theorem 15"},
       {"$changeover dossier 40 6 --format html", 0, "<h3>Theorem 15: "},
       {"$changeover dossier 40 6 --format html", 0, "<b>25</b> <b>26</b>"},
       {"$changeover dossier 20 5 | grep -c elementary", 1, "0"},
       {"$changeover dossier 8.5.2.circular", 0, "grep -v \"^#\" design.txt | sha256sum"},
       {"$changeover dossier 26.4.2.circular.65 --format html", 0, "<figcaption>"},
       {"$changeover dossier 9 3 --change 1 --format html", 0,
        "[<a href=\"#ChafeeStevens2023\">Chafee and Stevens 2023</a>]"},
       {"$changeover dossier 9 3 --change 1 --format html", 0,
        "<li id=\"ChafeeStevens2023\">A. L. Chafee"},
       {"$changeover dossier 9 3 --change 1 --format html", 0, "elements have <i>j</i> stays"},
       {"$changeover dossier 26 6 --change 1 --linear", 0, "63 reported \\[Bean2026\\]"},
       {"$changeover dossier 9 5 --linear", 0, "drat-trim"},
       {"$changeover dossier 8 5 -o d.tex && grep -c '.begin{document}' d.tex", 0, "1"},
       {"$changeover dossier 200 101 --circular", 0, "checkdesign design.txt"},
       {"$changeover dossier 253 13", 0, "The 1386 blocks are too many for a page."},
       {"$changeover dossier 8 5 --json", 0, "\"format\":\"changeover-dossier/1\""}},
      folder);
}

TEST(Dossier, RefusesWhatIsNoDesign) {
  const TemporaryFolder folder;
  expect({{"$changeover dossier", 2, "LABEL"},
          {"$changeover dossier x", 4, "the catalog has no design x"},
          {"$changeover catalog show 8.5.2.circular -t 3", 2, "--strength is for V K"},
          {"$changeover catalog show 8", 2, "8 is a number V, and K is missing"},
          {"$changeover draw 8.5.2.circular --linear", 2, "--linear is for V K"},
          {"$changeover dossier 4 2", 4, "No circular DCCD(4,2) exists"},
          {"$changeover dossier 200 5 --change 5 --circular", 4, "No construction serves"},
          {"$changeover dossier 8 5 -o d.pdf", 2, "d.pdf"},
          {"$changeover dossier 8 5 -o /dev/null/d.tex", 4, "/dev/null/d.tex"}},
         folder);
}

// The commands that it prints make what it is about, whichever way the design was found.
TEST(Dossier, ItsCommandsMakeItsDesign) {
  const TemporaryFolder folder;
  for (const std::string what :
       {"8 5", "26.4.2.circular.65", "77 12 --change 8 --circular", "114 12 --change 10 --linear",
        "15 12 --circular --strength 3", "13 13 --linear --strength 4", "253 13"}) {
    const auto page =
        run("$changeover dossier " + what +
                " -o d.md && "
                "sed -n '/^changeover \\(design\\|catalog\\|draw\\)/p' d.md | sort -u | "
                "sed 's/^changeover /\"$changeover\" /' > commands && "
                "export changeover && sh -e ./commands && "
                "grep -v '^#' design.txt | sha256sum | cut -d' ' -f1 > made && "
                "grep -F -f made d.md",
            folder.path());
    EXPECT_EQ(page.code, 0) << what << page.out.substr(0, 500) << page.err;
  }
}

// What is printed for a file saved from the page, and its excess.
TEST(Dossier, ItsBlocksAreChecked) {
  const TemporaryFolder folder;
  for (const std::string what :
       {"40 6", "9 4 --change 1 --linear", "8 5 --linear", "13 6 --change 3"}) {
    const auto page =
        run("$changeover dossier " + what +
                " --format html -o d.html && "
                "sed -n '/class=\"blocks\"/,/<.pre>/p' d.html | sed 's/<[^>]*>//g' | grep . > "
                "design.txt && \"$checkdesign\" $(grep -o 'checkdesign -v[^<]*design.txt' d.html | "
                "cut -d ' ' -f 2-) > said && "
                "sed -n '/following first/,/<.pre>/p' d.html | sed 's/<[^>]*>//g' | sed 1d | "
                "grep -v -x -f said | grep . ; "
                "$changeover dossier " +
                what + " | sed -n 's/^| excess | \\(.*\\) |$/excess \\1/p' | grep -x -f - said",
            folder.path());
    EXPECT_TRUE(page.out.starts_with("excess ")) << what << page.out << page.err;
  }
}

// Names of environments that are open at the end of a text, and of those that close another than
// the last one opened.
std::vector<std::string> unbalanced(const std::string& latex) {
  static const std::regex mark(R"(\\(begin|end)\{([a-z*]+)\})");
  std::vector<std::string> open;
  for (std::sregex_iterator at(latex.begin(), latex.end(), mark); at != std::sregex_iterator();
       ++at) {
    const std::string name = (*at)[2];
    if ((*at)[1] == "begin") {
      open.push_back(name);
    } else if (!open.empty() && open.back() == name) {
      open.pop_back();
    } else {
      open.push_back("end of " + name);
    }
  }
  return open;
}

TEST(Dossier, ItsLatexClosesWhatItOpens) {
  const TemporaryFolder folder;
  for (const std::string command :
       {"dossier 8 5", "dossier 9 5 --linear", "dossier 26.4.2.circular.65", "dossier 253 13",
        "dossier 45 7", "bounds 8 5", "bounds 26 6 --change 1", "explain 253 13", "minima --v 8",
        "table --k 3..5 --v 5..60"}) {
    const auto outcome = run("$changeover " + command + " --format latex", folder.path());
    EXPECT_EQ(outcome.code, 0) << command << outcome.err;
    EXPECT_THAT(unbalanced(outcome.out), testing::IsEmpty()) << command;
  }
}

// Catalogs come from strangers, too: what they say of themselves stays text.
TEST(Dossier, CreditsAndNotesAreText) {
  const TemporaryFolder folder;
  const auto added =
      run("$changeover design 9 4 --change 1 --linear --construction hold-and-stream --format text "
          "-o d.txt && "
          "$changeover catalog add d.txt --catalog u.db --who 'A \\input{x} % & $y$ {' "
          "--note '} \\end{filecontents*} # a_b' --json | "
          "grep -o '\"label\":\"[^\"]*\"' | head -n 1 | cut -d '\"' -f 4 > label && grep . label",
          folder.path());
  ASSERT_EQ(added.code, 0) << added.err;
  const std::string dossier = "$changeover dossier $(cat label) --catalog u.db ";
  const auto cited = run("$changeover catalog cite $(cat label) --catalog u.db", folder.path());
  EXPECT_THAT(cited.out, HasSubstr("{{A \\textbackslash{}input\\textbraceleft{}x"));
  EXPECT_THAT(cited.out, HasSubstr("\\textbraceright{} \\textbackslash{}end"));
  EXPECT_EQ(std::ranges::count(cited.out, '{'), std::ranges::count(cited.out, '}'));
  const auto latex = run(dossier + "--format latex", folder.path());
  EXPECT_EQ(latex.code, 0) << latex.err;
  EXPECT_THAT(unbalanced(latex.out), testing::IsEmpty());
  EXPECT_EQ(latex.out.find("\\input"), std::string::npos);
  if (run("command -v pdflatex && command -v bibtex && kpsewhich tikz.sty booktabs.sty",
          folder.path())
          .code != 0) {
    GTEST_SKIP() << "no LaTeX";
  }
  const auto made = run(dossier +
                            "-o d.tex && pdflatex -halt-on-error d.tex >log && bibtex d >log && "
                            "pdflatex -halt-on-error d.tex >log && pdflatex -halt-on-error d.tex",
                        folder.path());
  EXPECT_EQ(made.code, 0) << made.out << made.err;
}

// What LaTeX itself says of it, where there is one.
TEST(Dossier, LatexCompilesIt) {
  const TemporaryFolder folder;
  if (run("command -v pdflatex && command -v bibtex", folder.path()).code != 0) {
    GTEST_SKIP() << "no pdflatex";
  }
  if (run("kpsewhich tikz.sty booktabs.sty", folder.path()).code != 0) {
    GTEST_SKIP() << "no TikZ for LaTeX";
  }
  for (const std::string what : {"8 5", "9 5 --linear"}) {
    const auto outcome =
        run("$changeover dossier " + what +
                " -o d.tex && pdflatex -halt-on-error d.tex >log && bibtex d >log && "
                "pdflatex -halt-on-error d.tex >log && pdflatex -halt-on-error d.tex",
            folder.path());
    EXPECT_EQ(outcome.code, 0) << what << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.find("undefined references"), std::string::npos) << what;
  }
}

TEST(Latex, OfATableHasBoundsAndCitations) {
  const TemporaryFolder folder;
  expect({{"$changeover table --k 5..6 --v 16..17 --linear --format latex", 0,
           "17 & $20^{b}_{\\geq 19}$ & $16^{a}_{\\geq 15}$ \\\\"},
          {"$changeover table --k 4 --v 15 --circular --format latex", 0, "\\toprule"},
          {"$changeover table --k 5 --v 15 --circular --format latex", 0,
           "a: cyclic \\cite[{Theorem 10"},
          {"$changeover table --k 5 --v 15 --circular --format latex", 0,
           "% changeover catalog cite ChafeeStevens2025"},
          {"$changeover catalog cite ChafeeStevens2025", 0, "@article{ChafeeStevens2025,"},
          {"$changeover minima --v 7 --format latex", 0, "\\section*{Minima}"}},
         folder);
}

TEST(Proofs, StandBesideAReadme) {
  const TemporaryFolder folder;
  const std::string readme = folder.file("proofs/linear-m2-v9-k5-README.md");
  EXPECT_EQ(run("$changeover search 9 5 --linear --exact --proof proofs --quiet --threads 1",
                folder.path())
                .code,
            10);
  const std::string text = slurp(readme);
  EXPECT_THAT(text, HasSubstr("## No linear DCCD(9,5) with 5 blocks"));
  EXPECT_THAT(text, HasSubstr("| linear-m2-v9-k5-b5.cnf |"));
  EXPECT_THAT(text, HasSubstr("s VERIFIED"));
  // One about one number of blocks does not take its place.
  EXPECT_EQ(
      run("$changeover search 9 5 --blocks 5 --linear --exact --proof proofs --quiet --threads 1",
          folder.path())
          .code,
      20);
  EXPECT_EQ(slurp(readme), text);
  EXPECT_THAT(slurp(folder.file("proofs/linear-m2-v9-k5-b5-README.md")),
              HasSubstr("## No linear DCCD(9,5) with 5 blocks"));
  // Parts are counted as people do.
  run("$changeover search 9 5 --blocks 5 --linear --exact --proof parts --quiet --threads 2",
      folder.path());
  const std::string parts = slurp(folder.file("parts/linear-m2-v9-k5-b5-README.md"));
  EXPECT_LT(parts.find("-part2of"), parts.find("-part10of")) << parts;
  EXPECT_NE(parts.find("-part10of"), std::string::npos) << parts;
  // A find without a proof leaves none.
  EXPECT_EQ(
      run("$changeover search 8 5 --blocks 9 --exact --proof other --quiet", folder.path()).code,
      10);
  EXPECT_EQ(run("ls other/*README.md", folder.path()).out, "");
}

}  // namespace
}  // namespace changeover::test::dossier_test
