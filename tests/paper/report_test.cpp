#include "paper/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "paper/checks/checks.hpp"

namespace changeover::report_test {
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

using Expected = std::vector<std::pair<std::string, std::string>>;

void expect_exactly(PaperStatus status, const Expected& expected) {
  std::vector<PaperItem> items;
  for (const PaperItem& item : whole_report().items) {
    if (item.status == status && item.follows.empty()) {
      items.push_back(item);
    }
  }
  ASSERT_EQ(items.size(), expected.size()) << render_text(whole_report());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(items[i].place, expected[i].first);
    EXPECT_TRUE(items[i].what.starts_with(expected[i].second)) << items[i].what;
    EXPECT_EQ(items[i].findings.empty(),
              status == PaperStatus::not_checkable || status == PaperStatus::vacuous);
  }
}

TEST(PaperReport, differs_exactly_where_the_print_is_not_right) {
  expect_exactly(PaperStatus::differs,
                 {
                     {"Abstract", "the number of designs"},
                     {"Section 2.1", "cited: the number of blocks of the minimum DCCD(v,4,b)"},
                     {"Section 3.1", "cited: expansion sets make a SCCD(v+1,k,b)"},
                     {"Theorem 2", "the proof: the inserted blocks"},
                     {"Table 3", "asterisks"},
                     {"Section 3.1", "a new element of Theorem 2"},
                     {"Section 3.2", "in Z_v every pair"},
                     {"Example 12", "base blocks"},
                     {"Table 11", "asterisks"},
                     {"Proposition 13", "the proof"},
                 });
}

TEST(PaperReport, refutes_exactly_the_statements_that_are_false) {
  expect_exactly(PaperStatus::refuted,
                 {
                     {"Section 2.1", "cited: if 2k-3 is an odd prime power"},
                     {"Section 2.1", "cited: a minimum circular DCCD(v,k,ceil("},
                     {"Theorem 1", "a circular"},
                     {"Corollary 15", "a tight circular DCCD(67,3,489)"},
                     {"Corollary 15", "a tight circular DCCD(161,11,640)"},
                 });
}

// What two or more elements in every block do to other statements is said once, as consequences of
// one item.
TEST(PaperReport, groups_what_has_one_cause) {
  const std::vector<std::pair<std::string, PaperStatus>> expected = {
      {"any economical DCCD is minimum", PaperStatus::refuted},
      {"in a tight DCCD", PaperStatus::refuted},
      {"in an economical DCCD", PaperStatus::refuted},
      {"the proof for odd k", PaperStatus::differs},
      {"the proof: in any DCCD", PaperStatus::refuted},
  };
  std::vector<PaperItem> found;
  for (const PaperItem& item : whole_report().items) {
    if (!item.follows.empty()) {
      found.push_back(item);
    }
  }
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_EQ(whole_report().consequences(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_TRUE(found[i].what.starts_with(expected[i].first)) << found[i].what;
    EXPECT_EQ(found[i].status, expected[i].second);
    EXPECT_EQ(found[i].follows, "Theorem 1");
  }
}

TEST(PaperReport, says_first_where_the_circular_bound_holds) {
  const PaperItem& item = item_at("Theorem 1", "for v >= 2k-3 the circular bound");
  EXPECT_EQ(item.status, PaperStatus::reproduced);
  EXPECT_TRUE(item.comes_first);
  EXPECT_NE(item.notes.at(2).find("494 of the 630"), std::string::npos) << item.notes.at(2);
  EXPECT_NE(item.notes.at(1).find("must occur in at least one block"), std::string::npos);
}

TEST(PaperReport, says_where_fixed_elements_are_right) {
  const PaperItem& item = item_at("Section 2.1", "cited: a minimum circular DCCD(v,k,ceil(");
  ASSERT_EQ(item.findings.size(), 2U);  // below 2k-3 and beyond it
  EXPECT_NE(item.findings[0].truth.find("DCCD(10,7,5)"), std::string::npos);
  EXPECT_NE(
      item.findings[1].truth.find("DCCD(9,5,6) with ceil(g2) = 6 blocks has 1 fixed element,"),
      std::string::npos)
      << item.findings[1].truth;
  EXPECT_TRUE(item.notes.back().starts_with("right where every pair is covered exactly once"));
}

TEST(PaperReport, introductions_change_where_blocks_come_before_the_first) {
  const PaperItem& item = item_at("Theorem 2", "the proof: the inserted blocks");
  ASSERT_EQ(item.findings.size(), 1U);
  EXPECT_NE(item.findings[0].truth.find("block 5 = {0,1,2} introduces {0,1}, as Table 3 has it"),
            std::string::npos)
      << item.findings[0].truth;
}

TEST(PaperReport, checks_the_covering_and_what_is_introduced_in_cyclic_designs) {
  EXPECT_EQ(item_at("Section 1", "the covering design").checked, 13U);
  EXPECT_EQ(item_at("Theorem 10", "the proof: the elements introduced").checked, 167770U);
}

TEST(PaperReport, says_of_what_is_not_checkable_why) {
  expect_exactly(PaperStatus::not_checkable,
                 {
                     {"Section 1", "history and motive"},
                     {"Section 2.1", "cited: minimum SCCDs are constructed for four classes"},
                     {"Section 2.1", "cited: recursions for DCCD(v,4,b)"},
                     {"Section 4", "asked: a recursion"},
                 });
  for (const PaperItem& item : whole_report().items) {
    if (item.status == PaperStatus::not_checkable) {
      EXPECT_FALSE(item.notes.empty()) << item.what;
    } else {
      EXPECT_GT(item.checked, 0U) << item.place << ' ' << item.what;
      EXPECT_EQ(item.findings.empty(),
                item.status == PaperStatus::reproduced || item.status == PaperStatus::vacuous);
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
  const auto slip = [](std::string_view what) { return item_at("Corollary 15", what).notes.at(0); };
  EXPECT_TRUE(slip("a tight circular DCCD(67,3,489)").ends_with("if k is 4 there"));
  EXPECT_TRUE(slip("a tight circular DCCD(161,11,640)")
                  .ends_with("expanded with 7 of the 17 members of its expansion set"));
}

TEST(PaperReport, finds_the_circular_design_below_the_bound) {
  const PaperFinding& finding = item_at("Theorem 1", "a circular").findings.at(0);
  EXPECT_EQ(finding.printed, "a circular DCCD(8,6,b) has b >= ceil(g2) = 4");
  EXPECT_EQ(finding.truth, "{0,1,2,3,6,7}, {2,3,4,5,6,7}, {4,5,0,1,6,7} is one with 3 blocks");
}

// 15 elements, every pair in a block, 5 blocks = g2(15,12), and yet 21 pairs are covered twice.
TEST(PaperReport, refutes_what_is_said_of_tight_designs_by_a_design) {
  const PaperFinding& finding = item_at("Section 2.2", "in a tight DCCD").findings.at(0);
  EXPECT_TRUE(finding.truth.starts_with("circular DCCD(15,12,5): {")) << finding.truth;
  EXPECT_NE(finding.truth.find("the DCCD(8,5,5) with 7 elements added"), std::string::npos);
  EXPECT_NE(finding.truth.find("counted 21 times too often, 21 never"), std::string::npos);
}

// The least v and k for which it fails, with a design whose blocks are all different.
TEST(PaperReport, an_economical_design_that_is_not_minimum) {
  const PaperFinding& finding = item_at("Section 2.2", "any economical").findings.at(0);
  EXPECT_EQ(finding.printed, "a circular DCCD(8,6) with 4 blocks is minimum");
  EXPECT_NE(finding.truth.find("{1,2,3,5,6,7} is one, and {0,1,2,3,4,5}"), std::string::npos)
      << finding.truth;
}

TEST(PaperReport, a_minimum_design_where_none_should_be) {
  const PaperFinding& finding = item_at("Section 2.1", "cited: if 2k-3").findings.at(0);
  EXPECT_EQ(finding.printed, "no minimum linear DCCD(22,10,14), for 22 < 25 and 2k-3 = 17");
  EXPECT_NE(finding.why.find("b >= 14"), std::string::npos) << finding.why;
}

TEST(PaperReport, does_not_claim_that_the_designs_of_3k_5_exist) {
  const PaperItem& item = item_at("Section 2.1", "cited: linear DCCD(3k-5,k,2k-4)");
  EXPECT_EQ(item.status, PaperStatus::vacuous);
  EXPECT_NE(item.notes.at(0).find("for 37 of 37 k there is none"), std::string::npos);
  EXPECT_EQ(whole_report().count(PaperStatus::vacuous), 1U);
}

TEST(PaperReport, finds_each_block_of_tables_1_and_2_anew) {
  EXPECT_EQ(item_at("Table 1", "A minimum DCCD(9,3,12)").checked, 36U);
  EXPECT_EQ(item_at("Table 2", "A tight linear (circular) DCCD(7,3,7)").checked, 21U);
}

TEST(PaperReport, is_the_same_every_time) {
  const PaperReport again = run_paper_report(Registry::standard());
  EXPECT_EQ(again.items, whole_report().items);
  EXPECT_EQ(render_text(again), render_text(whole_report()));
}

TEST(PaperReport, is_not_checkable_where_constructions_are_missing) {
  const Registry empty({});
  const PaperReport report = run_paper_report(empty, {.largest_k = 12});
  EXPECT_EQ(report.items.size(), whole_report().items.size());
  const auto lacks = [](const PaperItem& item) {
    return std::any_of(item.notes.begin(), item.notes.end(), [](const std::string& note) {
      return note.find("not in this registry") != std::string::npos;
    });
  };
  EXPECT_GE(std::count_if(report.items.begin(), report.items.end(), lacks), 20);
  for (std::size_t i = 0; i < report.items.size(); ++i) {
    const PaperItem& item = report.items[i];
    EXPECT_FALSE(lacks(item) && item.status != PaperStatus::not_checkable) << item.place;
    const PaperStatus whole = whole_report().items[i].status;
    if (item.status == PaperStatus::differs || item.status == PaperStatus::refuted) {
      EXPECT_EQ(item.status, whole)
          << item.place << ' ' << item.what;  // nothing is blamed for the lack
    }
  }
}

TEST(PaperReport, text_has_a_line_an_item_and_counts) {
  const std::string text = render_text(whole_report());
  EXPECT_NE(text.find("109 items: 89 reproduced, 10 differ, 5 refuted, 1 vacuous, 4 not checkable; "
                      "5 consequences\n"),
            std::string::npos);
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
  std::size_t at = 0;
  for (const char* next :
       {"\n## What to know first\n", "### Theorem 1: for v >= 2k-3", "\n## One cause\n",
        "### Theorem 1: a circular", "\n## What follows from it\n",
        "### Theorem 3: the proof: in any", "\n## Other statements that are not true as printed\n",
        "### Corollary 15", "\n## Where the print differs\n", "### Table 11: asterisks",
        "\n## True of no design\n", "DCCD(3k-5,k,2k-4)", "\n## Every item\n"}) {
    const std::size_t found = text.find(next, at);
    ASSERT_NE(found, std::string::npos) << next;
    at = found;
  }
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
      R"({"format":"changeover-paper/3","reproduced":0,"differs":1,"refuted":0,"vacuous":0,"not_checkable":0,"consequences":0,)"
      R"("items":[{"place":"Table \"0\"","what":"a\\b","status":"differs","checked":2,)"
      R"("unit":"cells","follows":null,"findings":[{"printed":"x","truth":"y","why":"∞"}],"notes":["n"]}]})");
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
}  // namespace changeover::report_test
