#include "paper/report.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::figures_test {
namespace {

TEST(PaperFigures, draws_all_five_in_both_formats) {
  const std::vector<std::string> files = {
      "figure-1.svg", "figure-1.tex",  "figure-2.svg",  "figure-2.tex",  "figure-3.svg",
      "figure-3.tex", "figure-4a.svg", "figure-4a.tex", "figure-4b.svg", "figure-4b.tex"};
  const std::vector<PaperFigure> figures = paper_figures();
  ASSERT_EQ(figures.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(figures[i].file, files[i]);
    const std::string begin = i % 2 == 0 ? "<svg" : "\\begin{tikzpicture}";
    EXPECT_NE(figures[i].content.find(begin), std::string::npos) << files[i];
  }
  EXPECT_EQ(figures, paper_figures());
}

TEST(PaperFigures, refuses_a_picture_of_blocks_that_are_in_no_table) {
  Paper paper = printed_paper();
  paper.circles[0].first = "0 1 2 6";
  EXPECT_REFUSAL((void)paper_figures(paper), BadInput,
                 "Figure 3: its first block is not in the table");
  paper = printed_paper();
  paper.circles[0].v = 12;
  EXPECT_REFUSAL((void)paper_figures(paper), BadInput,
                 "Figure 3: its first block is not in the table");
  paper.circles[0].v = 999;
  EXPECT_REFUSAL((void)paper_figures(paper), BadInput, "Figure 3: no table over Z_999");
}

}  // namespace
}  // namespace changeover::figures_test
