// No check that cannot fail: the print is falsified at one place, and the item there must differ.
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "falsified.hpp"
#include "message_of.hpp"

namespace changeover::falsified_test {
namespace {

using namespace test;

// The parameters that a place writes once more, each of its formulas falsified.
void expect_again(Section section, const std::string& place, std::size_t count) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < printed_paper().again.size(); ++i) {
    if (printed_paper().again[i].design.place != place) {
      continue;
    }
    ++seen;
    expect_found(
        section, [=](Paper& p) { p.again[i].design.v += "-1"; }, place, "v and b");
    expect_found(
        section, [=](Paper& p) { p.again[i].design.b = "2" + p.again[i].design.b; }, place,
        "v and b");
  }
  EXPECT_EQ(seen, count);
}

TEST(FalsifiedPaper, introduction) {
  const Section section = check_introduction;
  expect_found(
      section, [](Paper& p) { p.count_in_abstract = 13; }, "Abstract", "number");
  for (std::size_t i = 0; i < 3; ++i) {
    expect_found(
        section, [=](Paper& p) { replace(p.recursion[i].v, "k-2", "k-1"); }, "Abstract", "v*");
    expect_found(
        section, [=](Paper& p) { p.recursion[i].v += "+1"; }, "Abstract", "v*");
    expect_found(
        section, [=](Paper& p) { replace(p.recursion[i].b, "\\frac{v}{k-2}", "\\frac{v}{k-1}"); },
        "Abstract", "v*");
    expect_found(
        section, [=](Paper& p) { p.recursion[i].b = "2" + p.recursion[i].b; }, "Abstract", "v*");
  }
  expect_again(section, "Abstract", 3);
  expect_found(
      section, [](Paper& p) { p.covered.covered = {"B6"}; }, "Section 1", "covered");
  expect_found(
      section, [](Paper& p) { p.covered.not_covered = {"B7"}; }, "Section 1", "covered");
  expect_found(
      section, [](Paper& p) { p.covered.y = "2"; }, "Section 1", "covered");
  for (std::size_t i = 0; i < 2; ++i) {
    expect_found(
        section, [=](Paper& p) { ++p.costs[i].covering; }, "Section 1", "costs");
    expect_found(
        section, [=](Paper& p) { ++p.costs[i].single; }, "Section 1", "costs");
    expect_found(
        section, [=](Paper& p) { ++p.costs[i].twice; }, "Section 1", "costs");
    expect_found(
        section, [=](Paper& p) { ++p.costs[i].change; }, "Section 1", "costs");
  }
  expect_found(
      section, [](Paper& p) { replace(p.covering, "2 4 9", "2 4 8"); }, "Section 1", "covering");
  expect_found(
      section, [](Paper& p) { p.covering += "1 2 4\n"; }, "Section 1", "covering");
  Paper right = printed_paper();
  right.count_in_abstract = 11;
  EXPECT_TRUE(differing(section, right).empty()) << places(differing(section, right));
}

TEST(FalsifiedPaper, history) {
  expect_found(
      check_history, [](Paper& p) { replace(table_in(p, "Table 1").layout, "2* 4*", "2  4*"); },
      "Table 1", "asterisks");
  for (const std::uint64_t b : {11U, 13U}) {
    expect_found(
        check_history, [=](Paper& p) { table_in(p, "Table 1").b = b; }, "Table 1", "the least");
    expect_found(
        check_history, [=](Paper& p) { table_in(p, "Table 1").b = b; }, "Table 1", "A minimum");
  }
}

TEST(FalsifiedPaper, cited) {
  const Section section = check_cited;
  const auto cited = [](std::string PrintedCited::*formula, const std::string& wrong) {
    return [=](Paper& p) { p.cited.*formula = wrong; };
  };
  expect_found(section, cited(&PrintedCited::k4_b, "\\ceiling{(v^2-v-12)/10}+2"), "Section 2.1",
               "DCCD(v,4,b)");
  expect_found(section, cited(&PrintedCited::pairs_b, "v(v+1)/2"), "Section 2.1",
               "DCCD(v,2,v(v-1)/2)");
  expect_found(section, cited(&PrintedCited::minimum_b, "2k-3"), "Section 2.1", "are minimum");
  expect_found(section, cited(&PrintedCited::minimum_v, "3k-4"), "Section 2.1", "are minimum");
  expect_found(section, cited(&PrintedCited::linear_b, "\\ceiling{\\frac{v(v-1)}{4(k-2)+2}}+1"),
               "Section 2.1", "no fixed elements");
  expect_found(section, cited(&PrintedCited::no_fixed_from, "k+2"), "Section 2.1",
               "no fixed elements");
  expect_found(section, cited(&PrintedCited::prime_power_b, "2v-9"), "Section 2.1",
               "odd prime power");
  expect_found(section, cited(&PrintedCited::fixed_at, "2k-4"), "Section 2.1", "if and only if");
  expect_found(section, cited(&PrintedCited::room_v, "k+m+1"), "Section 2.1", "b > 1");
  expect_found(
      section, [](Paper& p) { p.cited.single_k.push_back(6); }, "Section 2.1", "minimum SCCDs");
  expect_found(
      section, [](Paper& p) { p.cited.k4_to = 20; }, "Section 2.1", "are constructed for v");
  Paper right = printed_paper();
  right.cited.k4_b += "+1";
  EXPECT_EQ(differing(section, right).size(), differing(section).size() - 1);
}

TEST(FalsifiedPaper, tightness) {
  // With a smaller formula designs of (15,12) and the like are no longer economical: other items,
  // or none.
  Paper other = printed_paper();
  other.circular_bound = "\\frac{\\binom{v}{2}}{2k-3}-1";
  EXPECT_NE(differing(check_tightness, other), differing(check_tightness));
  // The statement is right where no two elements are in every block: the counterexamples all have
  // such.
  for (const PaperItem& item : differing(check_tightness)) {
    EXPECT_EQ(item.status, PaperStatus::refuted);
    EXPECT_EQ(item.follows, "Theorem 1");
  }
}

TEST(FalsifiedPaper, preliminaries) {
  const Section section = check_preliminaries;
  const auto in_table_2 = [](const std::string& from, const std::string& to) {
    return [=](Paper& p) { replace(table_in(p, "Table 2").layout, from, to); };
  };
  expect_found(section, in_table_2("3*   3    4*", "3*   3    5*"), "Table 2", "A tight");
  expect_found(section, in_table_2("3*   3    4*", "3*   3    5*"), "Table 2", "STS(7)");
  expect_found(
      section, [](Paper& p) { replace(p.linear_bound, "2k-3", "2k-2"); }, "Theorem 1",
      "as printed");
  expect_found(
      section, [](Paper& p) { p.circular_bound += "+1"; }, "Theorem 1", "as printed");
  expect_found(
      section, [](Paper& p) { replace(p.linear_bound, "+1", ""); }, "Section 2.2", "g1 = g2");
  expect_found(
      section, [](Paper& p) { replace(p.circular_bound, "{2k-3}", "{k}+1"); }, "Section 2.2",
      "g1 = g2");
  expect_found(
      section, [](Paper& p) { p.linear_bound += "+1"; }, "Theorem 1", "a linear");
  expect_found(
      section, [](Paper& p) { replace(p.circular_bound, "2k-3", "2k-2"); }, "Theorem 1",
      "for v >= 2k-3");
  expect_found(
      section, [](Paper& p) { p.families[0].design.v = "2k-4"; }, "Theorem 1", "for v >= 2k-3");
  expect_found(
      section,
      [](Paper& p) {
        p.eleven[0] = {12, 10, 5};
      },
      "Theorem 1", "for v >= 2k-3");
  expect_found(section, in_table_2("^{6}", "^{4}"), "Table 2", "unchanged subsets");
  expect_found(section, in_table_2("^{2}", "^{5}"), "Table 2", "unchanged subsets");
  for (std::size_t i = 0; i < 6; ++i) {
    expect_found(
        section, [=](Paper& p) { p.unchanged.between[i] = "2"; }, "Table 2", "unchanged subsets");
  }
  expect_found(
      section, [](Paper& p) { p.unchanged.first[0] = "3"; }, "Table 2", "unchanged");
  expect_found(
      section, [](Paper& p) { p.unchanged.last[0] = "2"; }, "Table 2", "unchanged");
  expect_found(
      section, [](Paper& p) { p.unchanged.closing = "3"; }, "Table 2", "unchanged");
  expect_found(
      section, [](Paper& p) { p.unchanged.missing = "1"; }, "Table 2", "no expansion set");
  expect_found(
      section, [](Paper& p) { replace(p.factorizations[0].factors, "d-f", "d-e"); }, "Figure 1");
  expect_found(
      section, [](Paper& p) { replace(p.factorizations[1].factors, "12-15", "12-14"); },
      "Figure 2");
}

TEST(FalsifiedPaper, recursion) {
  const Section section = check_recursion;
  expect_found(
      section, [](Paper& p) { replace(p.recursion[1].v, "+1", ""); }, "Theorem 2");
  expect_found(
      section, [](Paper& p) { replace(p.recursion[1].b, "+1", "+3"); }, "Theorem 2");
  Paper right = printed_paper();
  right.single_recursion.b = "b+v/(k-1)";
  EXPECT_EQ(differing(section, right).size(), differing(section).size() - 1);
  right.single_recursion.v = "v+2";
  EXPECT_EQ(differing(section, right).size(), differing(section).size());
  const auto in_table_3 = [](const std::string& from, const std::string& to) {
    return [=](Paper& p) { replace(table_in(p, "Table 3").layout, from, to); };
  };
  expect_found(section, in_table_3("14:1", "13:1"), "Table 3", "A linear");
  expect_found(section, in_table_3("14:1", "14:2"), "Table 3", "colours");
  expect_found(section, in_table_3("6*  6 ", "6*  6*"), "Table 3", "asterisks");
  expect_found(
      section,
      [](Paper& p) {  // the same factors in another order: the same design, other blocks
        replace(p.factorizations[1].factors, "8-9   10-14", "10-14 8-9");
      },
      "Table 3", "A linear");
  expect_found(
      section, [](Paper& p) { replace(p.factorizations[1].factors, "12-15", "12-14"); }, "Table 3",
      "DCCD(15,3,35)");
}

TEST(FalsifiedPaper, doubling) {
  const Section section = check_doubling;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string place = printed_paper().families[i].design.place;
    for (const char* change : {"+1", "-1"}) {
      expect_found(
          section, [=](Paper& p) { p.families[i].design.b += change; }, place);
    }
    expect_found(
        section, [=](Paper& p) { p.families[i].design.v += "+1"; }, place);
    expect_found(
        section, [=](Paper& p) { p.families[i].even = !p.families[i].even; }, place);
  }
  expect_found(
      section, [](Paper& p) { p.families[1].smallest_k = 3; }, "Theorem 4");
  expect_found(
      section, [](Paper& p) { p.cited.single.b = "2k"; }, "Section 3.2", "base block");
  expect_found(
      section, [](Paper& p) { p.cited.single.v = "2k"; }, "Section 3.2", "base block");
  expect_found(
      section, [](Paper& p) { p.cited.single_cyclic.v += "+1"; }, "Section 3.2", "for all k >= 2");
  expect_found(
      section, [](Paper& p) { p.cited.single_cyclic.b += "+c"; }, "Section 3.2", "for all k >= 2");
  expect_found(
      section, [](Paper& p) { p.families[0].design.b = "k"; }, "Theorem 3", "no tight");
  expect_found(
      section, [](Paper& p) { replace(table_in(p, "Table 5").layout, "2_l_", "2_l"); }, "Table 5",
      "asterisks");
  expect_found(
      section, [](Paper& p) { replace(table_in(p, "Table 6").layout, "4_s_", "1_s_"); }, "Table 6",
      "A minimum");
  expect_found(
      section, [](Paper& p) { replace(table_in(p, "Table 7").layout, "d*", "c*"); }, "Table 7",
      "A tight");
  expect_found(
      section, [](Paper& p) { replace(p.factorizations[2].factors, "a-c b-d", "a-d b-c"); },
      "Table 7", "A tight");
  expect_found(
      section, [](Paper& p) { replace(table_in(p, "Table 4 (right)").layout, "3^ 1*^", "3 1*^"); },
      "Table 7", "A tight");
}

TEST(FalsifiedPaper, cyclic) {
  const Section section = check_cyclic;
  for (std::size_t c = 1; c <= 5; ++c) {
    for (std::size_t i = 0; i < c; ++i) {
      expect_found(
          section, [=](Paper& p) { p.cyclic[c - 1].further[i] = "k-2,2(k-2)+3"; }, "Theorem 10",
          "(Table 9)");
    }
  }
  expect_found(
      section, [](Paper& p) { p.cyclic[0].further[0] = "k-2,2(k-2)+3"; }, "Theorem 10",
      "the proof");
  expect_found(
      section, [](Paper& p) { p.cyclic[1].further[0] = "2(k-2),5(k-2)+3"; }, "Theorem 10",
      "the proof");
  expect_found(
      section, [](Paper& p) { p.cyclic_family.v += "+1"; }, "Theorem 10", "(Table 9)");
  expect_found(
      section, [](Paper& p) { p.cyclic_family.b += "-1"; }, "Theorem 10", "(Table 9)");
  for (std::size_t c = 0; c < 2; ++c) {
    expect_found(
        section, [=](Paper& p) { p.differences[c].v += "+1"; }, "Theorem 10", "the proof");
    for (std::size_t i = 0; i <= c; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        expect_found(
            section, [=](Paper& p) { p.differences[c].blocks[i][j].second += "+1"; }, "Theorem 10",
            "the proof");
      }
    }
  }
  expect_found(
      section, [](Paper& p) { replace(p.base_blocks_in_example, "0 2 7", "0 2 6"); }, "Example 12",
      "all differences");
  expect_found(
      section, [](Paper& p) { p.cited.largest_difference = "(v-3)/2"; }, "Section 3.2", "in Z_v");
  expect_found(
      section, [](Paper& p) { p.cyclic_up_to = 6; }, "Theorem 10", "(Table 9)");
  expect_found(
      section, [](Paper& p) { p.cyclic.pop_back(); }, "Theorem 10", "(Table 9)");
  expect_found(
      section, [](Paper& p) { p.cyclic[2].further[1] = "3(k-2)+1,k-2"; }, "Theorem 10",
      "the elements introduced");
  // The link condition: without k-2 in the last base block the double change breaks.
  expect_found(
      section, [](Paper& p) { std::swap(p.cyclic[2].further[0], p.cyclic[2].further[2]); },
      "Theorem 10", "(Table 9)");
  expect_found(
      section, [](Paper& p) { replace(table_in(p, "Table 8").layout, "0    3*", "6    3*"); },
      "Table 8");
  expect_found(
      section, [](Paper& p) { replace(table_in(p, "Table 10").layout, "19!", "19"); }, "Table 10",
      "highlights");
  expect_found(
      section, [](Paper& p) { replace(p.base_blocks_in_example, "0 2 7", "0 2 8"); }, "Table 11",
      "DCCD(13,3,26)");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string place = printed_paper().circles[i].place;
    expect_found(
        section, [=](Paper& p) { p.circles[i].black = "3"; }, place);
    expect_found(
        section, [=](Paper& p) { p.circles[i].first_only = "0"; }, place);
    expect_found(
        section, [=](Paper& p) { p.circles[i].second_only = "3"; }, place);
    expect_found(
        section, [=](Paper& p) { p.circles[i].first_edges += " 0-3"; }, place);
    expect_found(
        section, [=](Paper& p) { p.circles[i].second_edges += " 0-3"; }, place);
    expect_found(
        section, [=](Paper& p) { p.circles[i].first = "0 5 9"; }, place);
  }
  Paper right = printed_paper();
  right.base_blocks_in_example = "0 2 7\n0 1 4\n";
  right.cited.largest_difference = "v/2";
  const auto items = differing(section, right);
  EXPECT_TRUE(std::none_of(items.begin(), items.end(), [](const PaperItem& item) {
    return item.place == "Example 12" || item.place == "Section 3.2";
  }));
  EXPECT_TRUE(std::any_of(items.begin(), items.end(), [](const PaperItem& item) {
    return item.place == "Table 11" && item.what.find("DCCD(13,3,26)") != std::string::npos;
  })) << "Table 11 is not in the order of Table 9";
}

TEST(FalsifiedPaper, corollaries) {
  const Section section = check_corollaries;
  for (std::size_t i = 0; i < printed_paper().eleven.size(); ++i) {
    PrintedTriple triple = printed_paper().eleven[i];
    ++triple.b;
    expect_found(
        section, [=](Paper& p) { p.eleven[i] = triple; }, "Corollary 15", std::to_string(triple.b));
    --triple.b;
    ++triple.v;
    expect_found(
        section, [=](Paper& p) { p.eleven[i] = triple; }, "Corollary 15", std::to_string(triple.v));
  }
  expect_found(
      section, [](Paper& p) { p.eleven.pop_back(); }, "Corollary 15", "eleven");
  expect_found(
      section, [](Paper& p) { p.count_in_corollary = 12; }, "Corollary 15", "eleven");
  for (const auto& [from, to] :
       {std::pair{"4ck", "5ck"}, {"-2c", "-3c"}, {"l +2", "2l +2"}, {"+2", "+3"}}) {
    expect_found(
        section, [=](Paper& p) { replace(p.expanded.v, from, to); }, "Corollary 14");
  }
  for (const auto& [from, to] : {std::pair{"4kc^2", "5kc^2"},
                                 {"2c^2", "3c^2"},
                                 {"4cl", "5cl"},
                                 {"3c ", "4c "},
                                 {"l^2", "2l^2"},
                                 {"/2", "/3"}}) {
    expect_found(
        section, [=](Paper& p) { replace(p.expanded.b, from, to); }, "Corollary 14");
  }
  for (std::size_t i = 0; i < printed_paper().expansion_order.size(); ++i) {
    expect_found(
        section, [=](Paper& p) { p.expansion_order[i] += "+1"; }, "Corollary 14", "the order");
  }
  for (std::size_t i = 0; i < 6; ++i) {
    expect_found(
        section, [=](Paper& p) { p.six_base_blocks.further[i] = "3,50"; }, "Proposition 16");
  }
  expect_found(
      section,
      [](Paper& p) { std::swap(p.six_base_blocks.further[0], p.six_base_blocks.further[5]); },
      "Proposition 16");
  expect_found(
      section, [](Paper& p) { p.range_short_by = 2; }, "Proposition 13", "the proof");
  Paper right = printed_paper();
  right.range_short_by = 0;
  std::replace(right.eleven.begin(), right.eleven.end(), PrintedTriple{67, 3, 489},
               PrintedTriple{51, 3, 425});
  std::replace(right.eleven.begin(), right.eleven.end(), PrintedTriple{161, 11, 640},
               PrintedTriple{171, 11, 765});
  EXPECT_TRUE(differing(section, right).empty()) << places(differing(section, right));
}

TEST(FalsifiedPaper, conclusion) {
  expect_found(
      check_conclusion, [](Paper& p) { p.count_in_conclusion = 12; }, "Section 4");
  expect_again(check_conclusion, "Section 4", 4);
  expect_found(
      check_conclusion, [](Paper& p) { p.cited.circular_single_to = "4k+4"; }, "Section 4",
      "minimum circular SCCDs");
}

TEST(FalsifiedPaper, what_cannot_be_read_is_refused) {
  Paper paper = printed_paper();
  paper.six_base_blocks.further[0] = "4;19";
  EXPECT_REFUSAL((void)run(check_corollaries, paper), BadInput,
                 "formula \"4;19\", character 2: nothing is expected here");
  paper = printed_paper();
  paper.families.clear();
  EXPECT_REFUSAL((void)run(check_doubling, paper), BadInput,
                 "the paper has no family \"Theorem 3\"");
}

}  // namespace
}  // namespace changeover::falsified_test
