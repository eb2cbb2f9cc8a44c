// The tables of the print falsified at one place: the item there must differ.
#include <gtest/gtest.h>

#include "falsified.hpp"

namespace changeover::falsified_tables_test {
namespace {

using namespace test;

// A table's layout from its cells.
std::string layout_of(const ParsedTable& parsed) {
  std::string layout;
  for (std::size_t row = 0; row < parsed.blocks.front().cells.size(); ++row) {
    for (const PrintedBlock& block : parsed.blocks) {
      const PrintedCell& cell = block.cells[row];
      layout += cell.element + (cell.introduced ? "*" : "") + (cell.leaving ? "_" : "") +
                (cell.caret ? "^" : "") + (cell.highlighted ? "!" : "") +
                (cell.colour > 0 ? ":" + std::to_string(cell.colour) : "") + ' ';
    }
    layout += '\n';
  }
  if (!parsed.unchanged.empty()) {
    layout += "U ";
    for (const PrintedUnchanged& unchanged : parsed.unchanged) {
      layout += unchanged.elements.empty() ? "." : (unchanged.caret ? "^{" : "{");
      for (std::size_t i = 0; i < unchanged.elements.size(); ++i) {
        layout += (i > 0 ? "," : "") + unchanged.elements[i];
      }
      layout += unchanged.elements.empty() ? " " : "} ";
    }
    layout += '\n';
  }
  return layout;
}

TEST(FalsifiedTable, every_flipped_asterisk_is_found) {
  for (const PrintedTable& table : printed_paper().tables) {
    const ParsedTable parsed = parse(table);
    PrintedTable copy = table;
    copy.layout = layout_of(parsed);
    const PaperItem original = check_marks(copy);
    for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
      for (std::size_t row = 0; row < parsed.blocks[i].cells.size(); ++row) {
        if (parsed.blocks[i].cells[row].colour > 0) {
          continue;  // a colour marks it
        }
        ParsedTable flipped = parsed;
        flipped.blocks[i].cells[row].introduced = !flipped.blocks[i].cells[row].introduced;
        copy.layout = layout_of(flipped);
        const PaperItem item = check_marks(copy);
        ASSERT_NE(item.findings.size(), original.findings.size())
            << table.place << " block " << i << " row " << row;
      }
    }
  }
}

TEST(FalsifiedTable, every_flipped_leaving_mark_highlight_and_colour_is_found) {
  for (const PrintedTable& table : printed_paper().tables) {
    const ParsedTable parsed = parse(table);
    const bool highlighted = table.layout.find('!') != std::string::npos;
    const bool coloured = table.layout.find(':') != std::string::npos;
    const std::size_t original = check_marks(table).findings.size();
    for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
      for (std::size_t row = 0; row < parsed.blocks[i].cells.size(); ++row) {
        ParsedTable flipped = parsed;
        PrintedCell& cell = flipped.blocks[i].cells[row];
        if (table.leaving) {
          cell.leaving = !cell.leaving;
        } else if (highlighted) {
          cell.highlighted = !cell.highlighted;
        } else if (coloured && cell.colour > 0) {
          cell.colour = 0;
        } else {
          continue;
        }
        PrintedTable copy = table;
        copy.layout = layout_of(flipped);
        ASSERT_GT(check_marks(copy).findings.size(), original)
            << table.place << " block " << i << " row " << row;
      }
    }
  }
}

TEST(FalsifiedTable, every_changed_cell_is_found) {
  for (const PrintedTable& table : printed_paper().tables) {
    const ParsedTable parsed = parse(table);
    const Design rebuilt = printed_design(table, table.parameters.kind);
    ASSERT_EQ(check_blocks(table, rebuilt, "").status, PaperStatus::reproduced) << table.place;
    for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
      for (std::size_t row = 0; row < parsed.blocks[i].cells.size(); ++row) {
        ParsedTable changed = parsed;
        auto& cells = changed.blocks[i].cells;
        const auto absent = [&](const std::string& name) {
          return std::none_of(cells.begin(), cells.end(),
                              [&](const PrintedCell& cell) { return cell.element == name; });
        };
        Element x = 0;
        while (!absent(element_name(table, x))) {
          ++x;
        }
        cells[row].element = element_name(table, x);
        PrintedTable copy = table;
        copy.layout = layout_of(changed);
        ASSERT_EQ(check_blocks(copy, rebuilt, "").status, PaperStatus::differs)
            << table.place << " block " << i << " row " << row;
      }
    }
  }
}

TEST(FalsifiedTable, exchanged_dropped_and_malformed_blocks_are_found) {
  for (const PrintedTable& table : printed_paper().tables) {
    const Design rebuilt = printed_design(table, table.parameters.kind);
    ParsedTable parsed = parse(table);
    PrintedTable copy = table;
    std::swap(parsed.blocks[0], parsed.blocks[1]);
    copy.layout = layout_of(parsed);
    EXPECT_EQ(check_blocks(copy, rebuilt, "").status, PaperStatus::differs) << table.place;
    parsed = parse(table);
    parsed.blocks.pop_back();
    copy.layout = layout_of(parsed);
    EXPECT_EQ(check_blocks(copy, rebuilt, "").status, PaperStatus::differs) << table.place;
    parsed = parse(table);
    parsed.blocks[0].cells[1].element = parsed.blocks[0].cells[0].element;
    copy.layout = layout_of(parsed);
    EXPECT_EQ(check_blocks(copy, rebuilt, "").status, PaperStatus::differs) << table.place;
    EXPECT_EQ(check_marks(copy).status, PaperStatus::differs) << table.place;
  }
}

TEST(FalsifiedTable, a_wrong_caption_is_found) {
  for (const PrintedTable& table : printed_paper().tables) {
    const Design rebuilt = printed_design(table, table.parameters.kind);
    PrintedTable copy = table;
    ++copy.b;
    EXPECT_EQ(check_blocks(copy, rebuilt, "").status, PaperStatus::differs) << table.place;
    copy = table;
    copy.parameters.change = 3 - copy.parameters.change;
    EXPECT_EQ(check_blocks(copy, rebuilt, "").status, PaperStatus::differs) << table.place;
  }
  PrintedTable copy = table_at(printed_paper(), "Table 5");
  copy.tight = true;  // minimum, but not tight
  EXPECT_EQ(check_blocks(copy, printed_design(copy, Kind::circular), "").status,
            PaperStatus::differs);
  copy = table_at(printed_paper(), "Table 3");
  copy.kinds.push_back(Kind::circular);
  EXPECT_EQ(check_blocks(copy, printed_design(copy, Kind::linear), "").status,
            PaperStatus::differs);
}

TEST(FalsifiedTable, carets_must_mark_an_expansion_set) {
  PrintedTable copy = table_at(printed_paper(), "Table 4 (right)");
  replace(copy.layout, "3*^ 3^", "3*^ 3");
  EXPECT_EQ(check_marks(copy).status, PaperStatus::differs);
  copy = table_at(printed_paper(), "Table 2");
  replace(copy.layout, "^{2}", "^{1}");
  EXPECT_EQ(check_marks(copy).status, PaperStatus::differs);
  copy = table_at(printed_paper(), "Table 2");
  replace(copy.layout, "^{6}", "{6}");
  EXPECT_EQ(check_marks(copy).status, PaperStatus::differs);
}

TEST(CorrectedTable, corrections_are_accepted) {
  PrintedTable copy = table_at(printed_paper(), "Table 11");
  replace(copy.layout, "0*   11*  1*   12*  2*   0    3    1     4     2     5     3     6",
          "0* 11* 1* 12* 2* 0* 3* 1* 4* 2* 5* 3* 6*");
  replace(copy.layout, "10*   10*   11*   11    12*   12", "10* 10 11* 11 12* 12");
  EXPECT_EQ(check_marks(copy).status, PaperStatus::reproduced);
  copy = table_at(printed_paper(), "Table 3");
  replace(copy.layout, "2   2    2 ", "2*  2    2 ");
  EXPECT_EQ(check_marks(copy).status, PaperStatus::reproduced);
}

// Each cell of Tables 1 and 2, recomputed from the blocks that were left as they are.
TEST(FalsifiedTable, every_changed_cell_is_found_from_the_other_blocks) {
  for (const char* place : {"Table 1", "Table 2"}) {
    const PrintedTable& table = table_at(printed_paper(), place);
    ASSERT_EQ(check_each_block(table).status, PaperStatus::reproduced);
    const ParsedTable parsed = parse(table);
    for (std::size_t i = 0; i < parsed.blocks.size(); ++i) {
      for (std::size_t row = 0; row < 3; ++row) {
        ParsedTable changed = parsed;
        auto& cells = changed.blocks[i].cells;
        Element x = 0;
        while (std::any_of(cells.begin(), cells.end(), [&](const PrintedCell& cell) {
          return cell.element == element_name(table, x);
        })) {
          ++x;
        }
        cells[row].element = element_name(table, x);
        PrintedTable copy = table;
        copy.layout = layout_of(changed);
        const PaperItem item = check_each_block(copy);
        ASSERT_EQ(item.status, PaperStatus::differs) << place << " block " << i << " row " << row;
        // The caption, and the block itself with what it should be.
        ASSERT_EQ(item.findings.size(), 2U) << place << " block " << i << " row " << row;
        for (const PrintedCell& cell : parsed.blocks[i].cells) {
          EXPECT_NE(item.findings[1].truth.find(cell.element), std::string::npos);
        }
      }
    }
  }
}

TEST(FalsifiedTable, a_kind_is_held_to_what_the_blocks_are) {
  PrintedTable copy = table_at(printed_paper(), "Table 1");
  EXPECT_EQ(check_kind(copy).status, PaperStatus::reproduced);
  copy.kinds = {Kind::linear};  // called linear, it would be circular all the same
  EXPECT_EQ(check_kind(copy).status, PaperStatus::differs);
  copy.kinds = {};
  replace(copy.layout, "1* 1  1 ", "1* 2  1 ");
  EXPECT_EQ(check_kind(copy).status, PaperStatus::differs);
  copy = table_at(printed_paper(), "Table 3");
  copy.kinds = {Kind::linear, Kind::circular};
  EXPECT_EQ(check_kind(copy).status, PaperStatus::differs);
}

TEST(FalsifiedTable, a_minimum_must_be_one) {
  PrintedTable copy = table_at(printed_paper(), "Table 3");
  copy.layout += "--\n0\n1\n2\n";  // one block more than it takes
  copy.b = 36;
  const std::size_t before =
      check_blocks(copy, printed_design(copy, Kind::linear), "").findings.size();
  copy.minimum = true;
  EXPECT_EQ(before, 0U);
  EXPECT_EQ(check_blocks(copy, printed_design(copy, Kind::linear), "").status,
            PaperStatus::differs);
}

}  // namespace
}  // namespace changeover::falsified_tables_test
