#include "changeover/io/tables.hpp"

#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "message_of.hpp"
#include "random_designs.hpp"

namespace changeover::write_table_test {
namespace {

std::string table(const Design& design, const TableOptions& options = {}) {
  StringSink sink;
  write_table(design, sink, options);
  return sink.take();
}

std::string latex(const Design& design, const LatexOptions& options = {}) {
  StringSink sink;
  write_latex(design, sink, options);
  return sink.take();
}

// The circular DCCD(6,4,3) of [ChafeeStevens2025, Table 4].
Design doubled() {
  return Design(Parameters{.v = 6, .k = 4, .change = 2, .kind = Kind::circular},
                std::vector<Block>{{0, 1, 2, 3}, {2, 3, 4, 5}, {0, 1, 4, 5}});
}

// The circular DCCD(8,5,5) of [ChafeeStevens2025, Table 5].
Design minimum() {
  Design design(
      Parameters{.v = 8, .k = 5, .change = 2, .kind = Kind::circular},
      std::vector<Block>{
          {0, 2, 5, 3, 7}, {6, 2, 5, 3, 4}, {6, 2, 0, 1, 4}, {6, 2, 3, 7, 4}, {5, 1, 3, 7, 4}});
  design.set_labels({"∞_l", "∞_s", "0_l", "1_l", "2_l", "0_s", "1_s", "2_s"});
  return design;
}

TEST(MarksTest, OfTooManyElementsAreRefused) {
  class Wide final : public BlockSource {
   public:
    const Parameters& parameters() const override { return parameters_; }
    std::span<const Element> read(std::span<Element>) override { return {}; }

   private:
    Parameters parameters_{.v = 70'000, .k = 3};
  };
  Wide source;
  EXPECT_REFUSAL((void)aligned_rows(source, 0, 1), ImpossibleParameters,
                 "v = 70000 exceeds 65535: too many elements to lay out");
}

TEST(MarksTest, ElementsKeepTheirRowsAndAreMarked) {
  const std::vector<AlignedBlock> columns = aligned_rows(doubled());
  const std::vector<AlignedBlock> expected = {
      {{0, false, true}, {1, false, true}, {2, true, false}, {3, true, false}},
      {{4, true, false}, {5, true, false}, {2, false, true}, {3, false, true}},
      {{4, false, true}, {5, false, true}, {0, true, false}, {1, true, false}}};
  EXPECT_EQ(columns, expected);
}

RC_GTEST_PROP(MarksProperty, RowsHoldTheBlocksAndNothingThatStaysMoves, (std::uint32_t seed)) {
  const Design design = random_design(seed);
  const std::vector<AlignedBlock> columns = aligned_rows(design);
  RC_ASSERT(columns.size() == design.block_count());
  DesignSource source(design);
  Transitions steps(source);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    RC_ASSERT(steps.next());
    Block ours;
    Block introduced;
    Block leaving;
    for (const MarkedElement& cell : columns[i]) {
      ours.push_back(cell.element);
      if (cell.introduced) introduced.push_back(cell.element);
      if (cell.leaving) leaving.push_back(cell.element);
    }
    const auto sorted = [](auto block) {
      std::sort(block.begin(), block.end());
      return Block(block.begin(), block.end());
    };
    const auto as_block = [](std::span<const Element> s) { return Block(s.begin(), s.end()); };
    RC_ASSERT(sorted(ours) == sorted(as_block(steps.block())));
    RC_ASSERT(sorted(introduced) == sorted(as_block(steps.introduced())));
    RC_ASSERT(sorted(leaving) == sorted(as_block(steps.leaving())));
    for (std::size_t r = 0; i > 0 && r < ours.size(); ++r) {
      const Element before = columns[i - 1][r].element;
      const bool stays = std::find(ours.begin(), ours.end(), before) != ours.end();
      RC_ASSERT(!stays || ours[r] == before);
    }
  }
}

TEST(MarksTest, WidthsAreThoseOfATerminal) {
  EXPECT_EQ(display_width("abc"), 3U);
  EXPECT_EQ(display_width("∞_s"), 3U);
  EXPECT_EQ(display_width("漢字"), 4U);
  EXPECT_EQ(display_width("e\u0301"), 1U);
  EXPECT_EQ(display_width("\xff\xc3"), 2U);
}

TEST(TableTest, TheExampleIsAsTheHeaderShowsIt) {
  EXPECT_EQ(table(doubled(), {.positions = {1, 2, 3}}),
            "B1  B2  B3\n"
            "0   4*  4\n"
            "1   5*  5\n"
            "2*  2   0*\n"
            "3*  3   1*\n"
            "  ^   ^   ^\n");
}

TEST(TableTest, LeavingElementsAndPositionZeroHaveMarks) {
  EXPECT_EQ(table(doubled(), {.leaving = true, .positions = {0, 2}}),
            "  B1  B2  B3\n"
            "  0.  4*  4.\n"
            "  1.  5*  5.\n"
            "  2*  2.  0*\n"
            "  3*  3.  1*\n"
            "^       ^\n");
}

TEST(TableTest, BandsFitTheWidthAndColumnsAlignUnderWideLabels) {
  EXPECT_EQ(table(minimum(), {.width = 17, .names = {.first = 0}}),
            "B0    B1    B2\n"
            "∞_l*  1_s*  1_s\n"
            "0_l*  0_l   0_l\n"
            "0_s   0_s   ∞_l*\n"
            "1_l   1_l   ∞_s*\n"
            "2_s   2_l*  2_l\n"
            "\n"
            "B3    B4\n"
            "1_s   0_s*\n"
            "0_l   ∞_s*\n"
            "1_l*  1_l\n"
            "2_s*  2_s\n"
            "2_l   2_l\n");
  EXPECT_EQ(table(doubled(), {.width = 1, .introduced = false}).substr(0, 15),
            "B1\n0\n1\n2\n3\n\nB2\n");
}

TEST(TableTest, DevelopedBlocksHaveTwoIndices) {
  const std::string text = table(doubled(), {.names = {.base_blocks = 2}});
  EXPECT_TRUE(text.starts_with("B0,0  B1,0  B0,1\n")) << text;
}

TEST(TableTest, ColoursDoNotChangeTheText) {
  std::string coloured = table(minimum(), {.leaving = true, .colour = true});
  EXPECT_NE(coloured.find("\x1b[32m"), std::string::npos);
  for (std::size_t at; (at = coloured.find('\x1b')) != std::string::npos;) {
    coloured.erase(at, coloured.find('m', at) - at + 1);
  }
  EXPECT_EQ(coloured, table(minimum(), {.leaving = true}));
}

TEST(LatexTest, ThePapersConventions) {
  EXPECT_EQ(latex(doubled(), {.label = "tab:six"}),
            "\\begin{table}[ht!]\n"
            "\\centering\n"
            "\\begin{tabular}{lll}\n"
            "$B_{1}$ & $B_{2}$ & $B_{3}$ \\\\\n"
            "0 & 4$^*$ & 4 \\\\\n"
            "1 & 5$^*$ & 5 \\\\\n"
            "2$^*$ & 2 & 0$^*$ \\\\\n"
            "3$^*$ & 3 & 1$^*$\n"
            "\\end{tabular}\n"
            "\\caption{A circular DCCD(6,4,3)}\n"
            "\\label{tab:six}\n"
            "\\end{table}\n");
  EXPECT_EQ(latex(doubled(),
                  {.columns = 2, .positions = {1}, .names = {.base_blocks = 1}, .caption = ""}),
            "\\begin{table}[ht!]\n"
            "\\centering\n"
            "\\begin{tabular}{c@{}lc@{}lc@{}}\n"
            "& $B_{0,0}$ & & $B_{0,1}$ & \\\\\n"
            "& 0 & & 4$^*$ & \\\\\n"
            "& 1 & & 5$^*$ & \\\\\n"
            "& 2$^*$ & & 2 & \\\\\n"
            "& 3$^*$ & $_{\\land}$ & 3 & \\\\ \\hline\n"
            "& $B_{0,2}$ & \\\\\n"
            "& 4 & \\\\\n"
            "& 5 & \\\\\n"
            "& 0$^*$ & \\\\\n"
            "& 1$^*$ &\n"
            "\\end{tabular}\n"
            "\\end{table}\n");
}

TEST(LatexTest, NamesAreSetAsThePaperSetsThem) {
  EXPECT_EQ(latex_element("∞_l", true, true), "$\\infty_{l*}^{*}$");
  EXPECT_EQ(latex_element("0_l"), "$0_{l}$");
  EXPECT_EQ(latex_element("0_l", false, true), "$0_{l*}$");
  EXPECT_EQ(latex_element("∞", true), "$\\infty^{*}$");
  EXPECT_EQ(latex_element("x∞y"), "$x\\infty y$");
  EXPECT_EQ(latex_element("7", true, true), "7$^*_*$");
  EXPECT_EQ(latex_element("a_b_c"), "a\\_b\\_c");
  EXPECT_EQ(latex_element("_a"), "\\_a");
  EXPECT_EQ(latex_element("long_name"), "$\\mathrm{long}_{\\mathrm{name}}$");
  EXPECT_EQ(latex_element("a%_b&"), "$\\mbox{a\\%}_{\\mbox{\\scriptsize b\\&}}$");
  EXPECT_EQ(latex_element("[1", true), "{[1$^*$}");
  EXPECT_EQ(latex_escaped("\\{}$&#_%~^"),
            "\\textbackslash{}\\{\\}\\$\\&\\#\\_\\%\\textasciitilde{}\\textasciicircum{}");
  EXPECT_EQ(latex_escaped("--,,''``?`!`"), "-{}-,{},'{}'`{}`?{}`!{}`");
}

// The table has balanced braces and dollars, and no row has more cells than there are columns.
void check_latex(const std::string& text) {
  int depth = 0;
  int dollars = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
      continue;
    }
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    dollars += text[i] == '$' ? 1 : 0;
    RC_ASSERT(depth >= 0);
  }
  RC_ASSERT(depth == 0);
  RC_ASSERT(dollars % 2 == 0);
  const std::string environment =
      text.find("\\begin{longtable}{") != std::string::npos ? "longtable" : "tabular";
  const std::string begin = "\\begin{" + environment + "}{";
  RC_ASSERT(text.find(begin) != std::string::npos);
  const std::size_t start = text.find(begin) + begin.size();
  const std::size_t line_end = text.find('\n', start);
  std::string columns = text.substr(start, line_end - start - 1);
  for (std::size_t at; (at = columns.find("@{}")) != std::string::npos;) {
    columns.erase(at, 3);
  }
  std::size_t cells = 1;
  for (std::size_t i = line_end; i < text.find("\\end{" + environment + "}"); ++i) {
    if (text[i] == '\\') {
      cells = text[i + 1] == '\\' ? 1 : cells;
      ++i;
    } else if (text[i] == '&') {
      ++cells;
      RC_ASSERT(cells <= columns.size());
    }
  }
}

RC_GTEST_PROP(LatexProperty, TablesAreBalancedAndTheirRowsFit, (std::uint32_t seed)) {
  const Design design = random_design(seed);
  check_latex(latex(design, {.columns = seed % 7,
                             .leaving = seed % 2 == 0,
                             .positions = seed % 3 == 0 ? std::vector<std::uint64_t>{0, 1, 3}
                                                        : std::vector<std::uint64_t>{}}));
}

}  // namespace
}  // namespace changeover::write_table_test
