// The rest of the paper as data: statements, figures, base blocks, claims and the example of costs.
#include "paper/print/printed.hpp"

namespace changeover {
namespace {

std::vector<PrintedStatement> statements() {
  return {
      {"Theorem 1",
       "A linear DCCD(v,k,b) has at least g1 = (C(v,2) - C(k,2))/(2k-3) + 1 blocks, a circular one "
       "at least g2 = C(v,2)/(2k-3)."},
      {"Theorem 2",
       "If v is an odd multiple of k-2 and a DCCD(v,k,b) has an expansion set, then a "
       "DCCD(v*,k,b*) exists with v* = v + v/(k-2) + 1 and b* = b + (1/2)(v/(k-2))(v/(k-2) + 1); "
       "tight, economical or circular if the given one is."},
      {"Theorem 3",
       "A tight circular DCCD(2k-2,k,k-1) exists for all k >= 2 if and only if k is even."},
      {"Theorem 4", "A minimum circular DCCD(2k-2,k,k) exists for all odd k >= 5."},
      {"Example 5", "A minimum circular DCCD(8,5,5) by Theorem 4."},
      {"Example 6", "A minimum circular DCCD(12,7,7) by Theorem 4."},
      {"Proposition 7",
       "A tight circular DCCD(2k-2,k,k-1) has an expansion set if and only if k = 4."},
      {"Theorem 8", "A tight circular DCCD(2k-3,k,k-2) exists for all odd k >= 3."},
      {"Example 9", "A tight circular DCCD(11,4,11) from one base block."},
      {"Theorem 10",
       "A tight circular DCCD(c(4k-6)+1,k,c^2(4k-6)+c) exists for all k >= 3 when 1 <= c <= 5."},
      {"Example 11", "The tight circular DCCD(21,4,42) of Theorem 10 with c = 2."},
      {"Example 12", "The tight circular DCCD(13,3,26) of Theorem 10 with c = 2."},
      {"Proposition 13", "If k-2 divides 2c+1, a design of Theorem 10 has an expansion set."},
      {"Corollary 14",
       "If l = (2c+1)/(k-2) is odd, a tight circular DCCD(4ck-2c+l+2, k, "
       "4kc^2+2c^2+4cl+3c+(l^2+l)/2) exists."},
      {"Corollary 15", "Eleven tight circular DCCDs exist."},
      {"Proposition 16", "A tight circular DCCD(61,4,366) exists."},
  };
}

std::vector<PrintedFactorization> factorizations() {
  return {
      {.place = "Figure 1", .vertices = {"a", "b", "c", "d", "e", "f"}, .factors = R"(
b-e c-a d-f
c-e b-d f-a
d-e c-f b-a
f-e b-c d-a
a-e b-f c-d
)"},
      {.place = "Figure 2",
       .vertices = {"8", "9", "10", "11", "12", "13", "14", "15"},
       .factors = R"(
8-9   10-14 11-13 12-15
8-10  11-14 12-13 9-15
8-11  9-10  12-14 13-15
8-15  9-14  10-13 11-12
8-12  13-14 9-11  10-15
8-13  9-12  10-11 14-15
8-14  9-13  10-12 11-15
)"},
      // Not drawn: the text before Table 7 speaks of the 1-factorization of K_4 on {a,b,c,d}.
      {.place = "K_4 of Table 7", .vertices = {"a", "b", "c", "d"}, .factors = R"(
a-b c-d
a-c b-d
a-d b-c
)"},
  };
}

std::vector<PrintedCircle> circles() {
  return {
      {.place = "Figure 3",
       .v = 11,
       .first = "0 1 2 5",
       .second = "1 2 3 6",
       .first_edges = "0-2 0-5 1-2 1-5 2-5",
       .second_edges = "1-3 1-6 2-3 2-6 3-6",
       .black = "1 2",
       .first_only = "0 5",
       .second_only = "3 6"},
      {.place = "Figure 4a",
       .v = 13,
       .first = "0 1 4",
       .second = "0 2 7",
       .first_edges = "0-1 0-4 1-4",
       .second_edges = "0-2 0-7 2-7",
       .black = "0",
       .first_only = "1 4",
       .second_only = "2 7"},
      {.place = "Figure 4b",
       .v = 13,
       .first = "0 2 7",
       .second = "1 2 5",
       .first_edges = "0-2 0-7 2-7",
       .second_edges = "1-2 1-5 2-5",
       .black = "2",
       .first_only = "0 7",
       .second_only = "1 5"},
  };
}

std::vector<PrintedBaseBlocks> cyclic_base_blocks() {
  return {
      {"Table 9", 1, {"k-2,2(k-2)+1"}},
      {"Table 9", 2, {"2(k-2),5(k-2)+2", "k-2,3(k-2)+1"}},
      {"Table 9", 3, {"2(k-2),7(k-2)+3", "3(k-2)+1,5(k-2)+2", "k-2,4(k-2)+2"}},
      {"Table 9", 4, {"2(k-2),8(k-2)+4", "3(k-2)+1,5(k-2)+2", "4(k-2)+2,7(k-2)+4", "k-2,6(k-2)+3"}},
      {"Table 9",
       5,
       {"2(k-2),6(k-2)+3", "3(k-2),9(k-2)+4", "4(k-2)+2,7(k-2)+4", "5(k-2)+3,8(k-2)+4",
        "k-2,10(k-2)+5"}},
  };
}

Paper make_paper() {
  Paper paper;
  paper.statements = statements();
  paper.tables = printed_tables();
  paper.factorizations = factorizations();
  paper.circles = circles();
  paper.cyclic = cyclic_base_blocks();
  paper.six_base_blocks = {"Table 12", 6, {"4,19", "6,22", "8,25", "10,48", "12,32", "2,28"}};
  paper.cyclic_up_to = 5;
  paper.families = {
      {.design = {"Theorem 3", "2k-2", "k-1"}, .smallest_k = 2, .even = true},
      {.design = {"Theorem 4", "2k-2", "k"}, .smallest_k = 5, .even = false},
      {.design = {"Theorem 8", "2k-3", "k-2"}, .smallest_k = 3, .even = false},
  };
  paper.cyclic_family = {"Theorem 10", "c(4k-6)+1", "c^2(4k-6)+c"};
  paper.differences = {
      {1, "4k-5", {{{"k-1", "k-1"}, {"1", "k-2"}, {"k", "2k-3"}}}},
      {2,
       "8k-11",
       {{{"3k-4", "3k-4"}, {"k-1", "2k-4"}, {"3k-3", "4k-6"}},
        {{"2k-3", "2k-3"}, {"1", "k-2"}, {"2k-2", "3k-5"}}}},
  };
  paper.expanded = {"Corollary 14", "4ck -2c + l +2", "4kc^2 +2c^2 + 4cl+3c  + (l^2+l)/2"};
  paper.expansion_order = {R"(\frac{v}{k-2})", R"(\frac{4ck-6c+1}{k-2})", R"(4c+\frac{2c+1}{k-2})"};
  paper.again = {
      {{"Abstract", "2k-2", "k-1"}, "Theorem 3"},
      {{"Abstract", "2k-3", "k-2"}, "Theorem 8"},
      {{"Abstract", "c(4k-6)+1", "c^2(4k-6)+c"}, "Theorem 10"},
      {{"Section 4", "2k-2", "k-1"}, "Theorem 3"},
      {{"Section 4", "2k-3", "k-2"}, "Theorem 8"},
      {{"Section 4", "2k-2", "k"}, "Theorem 4"},
      {{"Section 4", "c(4k-6)+1", "c^2(4k-6)+c"}, "Theorem 10"},
  };
  paper.linear_bound = R"(\frac{\binom{v}{2}-\binom{k}{2}}{2k-3}+1)";
  paper.circular_bound = R"(\frac{\binom{v}{2}}{2k-3})";
  paper.eleven = {{15, 3, 35},    {21, 5, 30},   {27, 3, 117},   {55, 7, 135},
                  {39, 3, 247},   {105, 9, 364}, {67, 3, 489},   {77, 5, 418},
                  {161, 11, 640}, {63, 3, 651},  {253, 13, 1386}};
  paper.count_in_abstract = 12;
  paper.count_in_corollary = 11;
  paper.count_in_conclusion = 11;
  paper.covering = R"(
1 2 3
4 5 6
7 8 9
1 4 7
2 5 8
3 6 9
1 5 9
2 6 7
3 4 8
1 6 8
2 4 9
3 5 7
)";
  paper.costs = {{.test = 1, .change = 5, .covering = 177, .single = 118, .twice = 137},
                 {.test = 10, .change = 1, .covering = 153, .single = 200, .twice = 145}};
  paper.recursion = {
      {"Abstract", R"(v+\frac{v+k-2}{k-2})", R"(b+\frac{v}{k-2}\frac{v+k-2}{2k-4})"},
      {"Theorem 2", R"(v+\frac{v}{k-2}+1)", R"(b+\frac{1}{2}\frac{v}{k-2}(\frac{v}{k-2}+1))"},
      {"Section 4", R"(v+\frac{v}{k-2}+1)", R"(b+\frac{v}{k-2}\frac{v+k-2}{2k-4})"},
  };
  paper.single_recursion = {"Section 3.1", "v+1", "b"};
  paper.covered = {
      .table = "Table 7", .x = "0", .y = "1", .covered = {"B7"}, .not_covered = {"B8", "B9", "B1"}};
  paper.unchanged = {.between = {"0", "4", "3", "6", "6", "5"},
                     .first = {"0", "1", "2"},
                     .last = {"1", "3", "5"},
                     .closing = "1",
                     .missing = "2"};
  paper.base_blocks_in_example = R"(
0 1 4
0 2 7
)";
  paper.range_short_by = 1;
  paper.cited = {.linear_b = R"(\ceiling{\frac{v(v-1)-k(k-1)}{4(k-2)+2}}+1)",
                 .circular_b = R"(\ceiling{\frac{v(v-1)}{4(k-2)+2}})",
                 .k4_b = R"(\ceiling{(v^2-v-12)/10})",
                 .minimum_v = "3k-5",
                 .minimum_b = "2k-4",
                 .prime_power_b = "(2v-2)/3",
                 .prime_power_v = "3k-5",
                 .no_fixed_from = "3k-6",
                 .fixed_at = "2k-3",
                 .pairs_b = "v(v-1)/2",
                 .single = {"Section 3.2", "2k-1", "2k-1"},
                 .single_cyclic = {"Section 3.2", "2c(k-1)+1", "2c^2 (k - 1) + c"},
                 .single_k = {2, 3, 4},
                 .room_v = "k+m",
                 .largest_difference = "(v-1)/2",
                 .k4_from = 6,
                 .k4_to = 14,
                 .circular_single_to = "2k-1"};
  return paper;
}

}  // namespace

const Paper& printed_paper() {
  static const Paper paper = make_paper();
  return paper;
}

}  // namespace changeover
