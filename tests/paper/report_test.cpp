#include "paper/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "paper/checks.hpp"

namespace changeover {
namespace {

const PaperReport& whole_report() {
  static const PaperReport report = run_paper_report(Registry::standard());
  return report;
}

// Items by place and the beginning of what they say.
const PaperItem& item_at(std::string_view place, std::string_view what) {
  for (const PaperItem& item : whole_report().items) {
    if (item.place == place && item.what.starts_with(what)) {
      return item;
    }
  }
  static const PaperItem none;
  ADD_FAILURE() << "no item at " << place << ": " << what;
  return none;
}

TEST(PaperReport, differs_exactly_where_the_print_is_not_right) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"Abstract", "the number of designs"},
      {"Table 1", "the kind"},
      {"Section 2.1", "cited: linear DCCD(3k-5,k,2k-4)"},
      {"Section 2.1", "cited: the number of blocks of the minimum DCCD(v,4,b)"},
      {"Section 2.1", "cited: a minimum circular DCCD(v,k,ceil("},
      {"Theorem 1", "a circular"},
      {"Table 3", "asterisks"},
      {"Section 3.1", "a new element of Theorem 2"},
      {"Example 12", "base blocks"},
      {"Table 11", "asterisks"},
      {"Proposition 13", "the proof"},
      {"Corollary 15", "a tight circular DCCD(67,3,489)"},
      {"Corollary 15", "a tight circular DCCD(161,11,640)"},
  };
  std::vector<PaperItem> differing;
  for (const PaperItem& item : whole_report().items) {
    if (item.status == PaperStatus::differs) {
      differing.push_back(item);
    }
  }
  ASSERT_EQ(differing.size(), expected.size()) << render_text(whole_report());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(differing[i].place, expected[i].first);
    EXPECT_TRUE(differing[i].what.starts_with(expected[i].second)) << differing[i].what;
    EXPECT_FALSE(differing[i].findings.empty());
  }
}

TEST(PaperReport, reproduces_everything_else_that_is_in_scope) {
  EXPECT_EQ(whole_report().count(PaperStatus::out_of_scope), 7U);
  EXPECT_EQ(whole_report().count(PaperStatus::reproduced), whole_report().items.size() - 7 - 13);
  for (const PaperItem& item : whole_report().items) {
    if (item.status == PaperStatus::out_of_scope) {
      EXPECT_TRUE(item.what.starts_with("cited") || item.what.starts_with("open questions"))
          << item.what;
      EXPECT_FALSE(item.notes.empty());
    } else {
      EXPECT_GT(item.checked, 0U) << item.place << ' ' << item.what;
      EXPECT_EQ(item.findings.empty(), item.status == PaperStatus::reproduced);
    }
  }
}

TEST(PaperReport, has_blocks_and_marks_of_every_table) {
  for (const PrintedTable& table : printed_paper().tables) {
    EXPECT_EQ(item_at(table.place, table.caption).checked, table.b * table.parameters.k);
    EXPECT_GE(item_at(table.place, "asterisks").checked, table.b * table.parameters.k);
  }
}

TEST(PaperReport, names_the_wrong_asterisks_of_table_11_cell_by_cell) {
  const std::vector<std::string> cells = {
      "B_{0,9}: 0 has no",  "B_{1,9}: 3 has no",  "B_{0,10}: 1 has no",
      "B_{1,10}: 10 has a", "B_{1,10}: 4 has no", "B_{0,11}: 2 has no",
      "B_{1,11}: 5 has no", "B_{0,12}: 3 has no", "B_{1,12}: 6 has no"};
  const PaperItem& item = item_at("Table 11", "asterisks");
  ASSERT_EQ(item.findings.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_TRUE(item.findings[i].printed.starts_with(cells[i])) << item.findings[i].printed;
  }
}

TEST(PaperReport, says_what_the_impossible_designs_should_be) {
  const std::string& first =
      item_at("Corollary 15", "a tight circular DCCD(67,3,489)").findings.at(0).truth;
  EXPECT_NE(first.find("at least 737 blocks"), std::string::npos) << first;
  EXPECT_NE(first.find("DCCD(51,3,425), built and verified tight"), std::string::npos) << first;
  const std::string& second =
      item_at("Corollary 15", "a tight circular DCCD(161,11,640)").findings.at(0).truth;
  EXPECT_NE(second.find("at least 678 blocks"), std::string::npos) << second;
  EXPECT_NE(second.find("DCCD(171,11,765), built and verified tight"), std::string::npos) << second;
}

TEST(PaperReport, finds_the_circular_design_below_the_bound) {
  const PaperFinding& finding = item_at("Theorem 1", "a circular").findings.at(0);
  EXPECT_EQ(finding.printed, "a circular DCCD(8,6,b) has b >= ceil(g2) = 4");
  EXPECT_EQ(finding.truth, "{0,1,2,3,6,7}, {2,3,4,5,6,7}, {4,5,0,1,6,7} is one with 3 blocks");
}

TEST(PaperReport, states_the_minima_that_exhaustion_gives) {
  const PaperItem& item = item_at("Section 2.1", "cited: linear DCCD(3k-5,k,2k-4)");
  ASSERT_EQ(item.findings.size(), 2U);
  EXPECT_EQ(item.findings[0].truth, "no linear DCCD(7,4,4) exists; the minimum is 5 blocks");
  EXPECT_EQ(item.findings[1].truth, "no linear DCCD(10,5,6) exists; the minimum is 7 blocks");
}

TEST(PaperReport, is_the_same_every_time) {
  const PaperReport again = run_paper_report(Registry::standard());
  EXPECT_EQ(again.items, whole_report().items);
  EXPECT_EQ(render_text(again), render_text(whole_report()));
}

TEST(PaperReport, is_out_of_scope_where_constructions_are_missing) {
  const Registry empty({});
  const PaperReport report = run_paper_report(empty, {.largest_k = 12});
  EXPECT_EQ(report.items.size(), whole_report().items.size());
  for (const PaperItem& item : report.items) {
    if (item.status == PaperStatus::differs) {
      EXPECT_EQ(item.what.find("rebuilt"), std::string::npos) << item.place << ' ' << item.what;
    }
  }
  const auto lacks = [](const PaperItem& item) {
    return std::any_of(item.notes.begin(), item.notes.end(), [](const std::string& note) {
      return note.find("not in this registry") != std::string::npos;
    });
  };
  EXPECT_GE(std::count_if(report.items.begin(), report.items.end(), lacks), 20);
  for (const PaperItem& item : report.items) {
    EXPECT_EQ(lacks(item) && item.status != PaperStatus::out_of_scope, false) << item.place;
  }
}

TEST(PaperReport, text_has_a_line_an_item_and_counts) {
  const std::string text = render_text(whole_report());
  EXPECT_NE(text.find("86 items: 66 reproduced, 13 differ, 7 out of scope\n"), std::string::npos);
  EXPECT_EQ(text.find('\t'), std::string::npos);
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const std::string line = text.substr(begin, end - begin);
    const auto characters =
        std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
    EXPECT_LE(characters, 100) << line;
    EXPECT_FALSE(line.ends_with(' ')) << line;
    begin = end + 1;
  }
}

TEST(PaperReport, markdown_tells_each_item_once_in_its_table) {
  const std::string text = render_markdown(whole_report());
  std::size_t rows = 0;
  for (std::size_t at = text.find("\n| "); at != std::string::npos;
       at = text.find("\n| ", at + 1)) {
    ++rows;
  }
  EXPECT_EQ(rows, whole_report().items.size() + 1);
  EXPECT_NE(text.find("### Table 11: asterisks"), std::string::npos);
}

TEST(PaperReport, json_escapes_and_counts) {
  PaperReport report;
  report.items.push_back({.place = "Table \"0\"",
                          .what = "a\\b",
                          .status = PaperStatus::differs,
                          .checked = 2,
                          .unit = "cells",
                          .findings = {{"x", "y", "∞"}},
                          .notes = {"n"}});
  EXPECT_EQ(
      render_json(report),
      R"({"format":"changeover-paper/1","reproduced":0,"differs":1,"out_of_scope":0,)"
      R"("items":[{"place":"Table \"0\"","what":"a\\b","status":"differs","checked":2,)"
      R"("unit":"cells","findings":[{"printed":"x","truth":"y","why":"∞"}],"notes":["n"]}]})");
}

TEST(PaperReport, counts_findings_beyond_the_listed_ones) {
  PrintedTable table = table_at(printed_paper(), "Table 10");
  std::erase(table.layout, '*');
  const PaperItem item = check_marks(table);
  EXPECT_EQ(item.findings.size(), 40U);
  EXPECT_TRUE(std::find(item.notes.begin(), item.notes.end(), "and 44 more of the kind") !=
              item.notes.end());
}

}  // namespace
}  // namespace changeover
