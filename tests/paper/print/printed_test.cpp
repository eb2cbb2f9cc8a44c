#include "paper/print/printed.hpp"

#include <gtest/gtest.h>

#include <map>

#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "message_of.hpp"

namespace changeover::printed_test {
namespace {

PrintedTable small_table(std::string layout) {
  return {.place = "Table X",
          .caption = "two blocks",
          .parameters = {.v = 4, .k = 2, .change = 1, .kind = Kind::linear},
          .b = 2,
          .kinds = {Kind::linear},
          .layout = std::move(layout)};
}

TEST(PrintedTable, reads_every_mark) {
  const ParsedTable parsed = parse(small_table(R"(
B0  B1,0
0*  1_s_
a*_ 3!
--
B'2
7:12
2^
)"));
  ASSERT_EQ(parsed.blocks.size(), 3U);
  EXPECT_EQ(parsed.blocks[1].name, "B1,0");
  EXPECT_EQ(parsed.blocks[2].name, "B'2");
  EXPECT_TRUE(parsed.blocks[0].cells[0].introduced);
  EXPECT_FALSE(parsed.blocks[0].cells[0].leaving);
  EXPECT_EQ(parsed.blocks[1].cells[0].element, "1_s");
  EXPECT_TRUE(parsed.blocks[1].cells[0].leaving);
  EXPECT_FALSE(parsed.blocks[1].cells[0].introduced);
  EXPECT_TRUE(parsed.blocks[0].cells[1].introduced && parsed.blocks[0].cells[1].leaving);
  EXPECT_EQ(parsed.blocks[0].cells[1].element, "a");
  EXPECT_TRUE(parsed.blocks[1].cells[1].highlighted);
  EXPECT_EQ(parsed.blocks[2].cells[0].colour, 12U);
  EXPECT_EQ(parsed.carets, (std::vector<std::size_t>{3}));
}

TEST(PrintedTable, reads_a_row_of_unchanged_subsets) {
  const ParsedTable parsed = parse(small_table("0 1\n1 2\nU ^{0} {1,2} .\n"));
  ASSERT_EQ(parsed.unchanged.size(), 3U);
  EXPECT_TRUE(parsed.unchanged[0].caret);
  EXPECT_EQ(parsed.unchanged[1].elements, (std::vector<std::string>{"1", "2"}));
  EXPECT_TRUE(parsed.unchanged[2].elements.empty());
  EXPECT_EQ(parsed.carets, (std::vector<std::size_t>{0}));
}

TEST(PrintedTable, refuses_what_it_cannot_read) {
  EXPECT_REFUSAL((void)parse(small_table("0 1\n2\n")), BadInput,
                 "Table X: \"2\" has 1 column, the line before 2");
  EXPECT_REFUSAL((void)blocks_in("0 1\nx 2\n"), BadInput, "\"x\" in \"x 2\" is not an element");
  EXPECT_REFUSAL((void)parse(small_table("0:x 1\n2 3\n")), BadInput,
                 "\"0:x\": a colour is a number from 1");
  EXPECT_REFUSAL((void)parse(small_table("0 1\n2 3\nU 5\n")), BadInput,
                 "\"5\" is not an unchanged subset; write {2,3}");
  EXPECT_REFUSAL((void)printed_design(small_table("0 1\n9 2\n"), Kind::linear), BadInput,
                 "Table X: \"9\" is none of its elements");
  EXPECT_THROW((void)printed_design(small_table("0 1\n0 2\n"), Kind::linear), BadInput);
}

TEST(PrintedTable, every_table_has_the_shape_of_its_caption) {
  for (const PrintedTable& table : printed_paper().tables) {
    const ParsedTable parsed = parse(table);
    EXPECT_EQ(parsed.blocks.size(), table.b) << table.place;
    for (const PrintedBlock& block : parsed.blocks) {
      EXPECT_EQ(block.cells.size(), table.parameters.k) << table.place << ' ' << block.name;
    }
    const Design design = printed_design(table, table.parameters.kind);
    EXPECT_EQ(design.block_count(), table.b) << table.place;
    EXPECT_NE(table.caption.find(std::to_string(table.parameters.v)), std::string::npos);
  }
}

// Counts taken from the typeset paper: cells with an asterisk above, below, and highlighted ones.
TEST(PrintedTable, asterisks_are_as_many_as_in_print) {
  struct Count {
    std::size_t introduced, leaving, highlighted;
  };
  const std::map<std::string, Count> expected = {
      {"Table 1", {25, 0, 0}},       {"Table 2", {14, 0, 0}},        {"Table 3", {14, 0, 0}},
      {"Table 4 (left)", {3, 0, 0}}, {"Table 4 (right)", {6, 0, 0}}, {"Table 5", {10, 10, 0}},
      {"Table 6", {14, 14, 0}},      {"Table 7", {18, 0, 0}},        {"Table 8", {22, 0, 0}},
      {"Table 10", {84, 0, 20}},     {"Table 11", {45, 0, 0}},
  };
  EXPECT_EQ(expected.size(), printed_paper().tables.size());
  for (const PrintedTable& table : printed_paper().tables) {
    Count count{};
    for (const PrintedBlock& block : parse(table).blocks) {
      for (const PrintedCell& cell : block.cells) {
        count.introduced += cell.introduced ? 1U : 0U;
        count.leaving += cell.leaving ? 1U : 0U;
        count.highlighted += cell.highlighted ? 1U : 0U;
      }
    }
    EXPECT_EQ(count.introduced, expected.at(table.place).introduced) << table.place;
    EXPECT_EQ(count.leaving, expected.at(table.place).leaving) << table.place;
    EXPECT_EQ(count.highlighted, expected.at(table.place).highlighted) << table.place;
  }
}

TEST(PrintedTable, elements_have_their_printed_names) {
  const PrintedTable& table = table_at(printed_paper(), "Table 5");
  EXPECT_EQ(element_name(table, 0), "∞_s");
  EXPECT_EQ(element_name(table_at(printed_paper(), "Table 8"), 10), "10");
  EXPECT_EQ(printed_design(table, Kind::circular).label(4), "∞_l");
  EXPECT_REFUSAL((void)table_at(printed_paper(), "Table 9"), BadInput,
                 "the paper has no table of blocks \"Table 9\"");
}

TEST(PrintedPaper, numbers_its_statements_with_one_counter) {
  const auto& statements = printed_paper().statements;
  ASSERT_EQ(statements.size(), 16U);
  for (std::size_t i = 0; i < statements.size(); ++i) {
    EXPECT_TRUE(statements[i].place.ends_with(' ' + std::to_string(i + 1))) << statements[i].place;
  }
  EXPECT_NO_THROW((void)claim_at(printed_paper(), "Theorem 10"));
  EXPECT_REFUSAL((void)claim_at(printed_paper(), "Theorem 9"), BadInput,
                 "the paper has no statement \"Theorem 9\"");
}

TEST(PrintedPaper, base_blocks_are_read_for_any_k) {
  const PrintedBaseBlocks row{"Table 9", 2, {"2(k-2),5(k-2)+2", "k-2,3(k-2)+1"}};
  EXPECT_EQ(base_blocks(row, 4), (std::vector<Block>{{0, 1, 4, 12}, {0, 1, 2, 7}}));
  EXPECT_EQ(base_blocks(row, 3), (std::vector<Block>{{0, 2, 7}, {0, 1, 4}}));
  EXPECT_EQ(base_blocks({"Table 12", 6, {"4,19"}}, 4), (std::vector<Block>{{0, 1, 4, 19}}));
  EXPECT_REFUSAL((void)base_blocks({"x", 1, {"3(l-1)"}}, 4), BadInput,
                 "formula \"3(l-1)\", character 3: no value is known for this");
  EXPECT_REFUSAL((void)base_blocks({"x", 1, {"k-7"}}, 4), BadInput, "x: cannot read \"k-7\"");
  EXPECT_REFUSAL((void)base_blocks({"x", 1, {"k/3"}}, 4), BadInput, "x: cannot read \"k/3\"");
}

// A claim is for people; what is evaluated is the formula. They must say the same.
TEST(PrintedPaper, claims_show_the_formulas_that_are_evaluated) {
  const Paper& paper = printed_paper();
  std::vector<PrintedDesign> designs{paper.cyclic_family};
  for (const PrintedFamily& family : paper.families) {
    designs.push_back(family.design);
  }
  for (const PrintedDesign& design : designs) {
    const std::string& claim = claim_at(paper, design.place);
    EXPECT_NE(claim.find("DCCD(" + design.v + ",k," + design.b + ")"), std::string::npos) << claim;
  }
  const auto without_blanks = [](std::string text) {
    std::erase(text, ' ');
    return text;
  };
  EXPECT_NE(without_blanks(claim_at(paper, "Corollary 14"))
                .find(without_blanks("DCCD(" + paper.expanded.v + ",k," + paper.expanded.b + ")")),
            std::string::npos);
}

TEST(PrintedPaper, places_that_are_not_there_are_refused) {
  const Paper& paper = printed_paper();
  EXPECT_EQ(family_at(paper, "Theorem 8").design.v, "2k-3");
  EXPECT_EQ(formulas_at(paper.recursion, "Theorem 2").v, "v+\\frac{v}{k-2}+1");
  EXPECT_REFUSAL((void)family_at(paper, "Theorem 5"), BadInput,
                 "the paper has no family \"Theorem 5\"");
  EXPECT_REFUSAL((void)formulas_at(paper.recursion, "Theorem 5"), BadInput,
                 "the paper has no formulas at \"Theorem 5\"");
}

TEST(PrintedPaper, figures_are_read_by_names) {
  const OneFactorization k8 = parse(printed_paper().factorizations.at(1));
  EXPECT_EQ(k8.order, 8U);
  EXPECT_EQ(k8.factors.at(0).at(3), (Edge{4, 7}));  // 12-15
  PrintedFactorization wrong = printed_paper().factorizations.at(0);
  wrong.factors = "a-g";
  EXPECT_REFUSAL((void)parse(wrong), BadInput, "Figure 1: \"g\" is none of its elements");
  wrong.factors = "ab";
  EXPECT_REFUSAL((void)parse(wrong), BadInput, "Figure 1: \"ab\" is not an edge");
}

}  // namespace
}  // namespace changeover::printed_test
