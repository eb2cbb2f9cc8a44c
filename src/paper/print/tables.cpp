// The tables of blocks, as printed.
#include "paper/print/printed.hpp"

namespace changeover {
namespace {

constexpr Kind linear = Kind::linear;
constexpr Kind circular = Kind::circular;

PrintedTable table_1() {
  return {.place = "Table 1",
          .caption = "A minimum DCCD(9,3,12)",
          .parameters = {.v = 9, .k = 3, .change = 2, .kind = linear},
          .b = 12,
          .kinds = {},
          .minimum = true,
          .elements = {"1", "2", "3", "4", "5", "6", "7", "8", "9"},
          .layout = R"(
1* 1  1  1  4* 3* 2* 3* 8* 8  8  2*
2* 4* 5* 6* 6  6  6  5* 9* 2* 3* 9*
3* 7* 9* 8* 5* 9* 7* 7  7  5* 4* 4
)"};
}

PrintedTable table_2() {
  return {.place = "Table 2",
          .caption = "A tight linear (circular) DCCD(7,3,7)",
          .parameters = {.v = 7, .k = 3, .change = 2, .kind = circular},
          .b = 7,
          .kinds = {linear, circular},
          .tight = true,
          .layout = R"(
B1   B2   B3   B4   B5 B6   B7
0*   0    2*   0*   1* 5*   5
1    4*   4    6*   6  6    3*
2*   5*   3*   3    4* 2*   1*
U ^{2} ^{0} ^{4} ^{3} . ^{6} ^{5} ^{1}
)"};
}

PrintedTable table_3() {
  return {
      .place = "Table 3",
      .caption = "A linear DCCD(15,3,35) built from the linear DCCD(7,3,7) of Table 2 and K_8",
      .parameters = {.v = 15, .k = 3, .change = 2, .kind = linear},
      .b = 35,
      .kinds = {linear},
      .elements = {"0", "1", "2", "3", "4", "5", "6", "8", "9", "10", "11", "12", "13", "14", "15"},
      .layout = R"(
B1  B2   B3   B4   B5 B6   B7   B8   B9   B10 B11  B12
8:1 10:1 11:1 12:1 0* 0    0    0    0    0   8:3  9:3
9:1 14:1 13:1 15:1 1* 8:2  11:2 12:2 9:2  4*  4    4
2   2    2    2    2  10:2 14:2 13:2 15:2 5*  11:3 10:3
--
B13  B14  B15 B16  B17  B18  B19  B20 B21 B22  B23  B24
12:3 13:3 2*  8:4  9:4  10:4 11:4 0*  1*  8:5  13:5 9:5
4    4    4   15:4 14:4 13:4 12:4 6*  6   6    6    6
14:3 15:3 3*  3    3    3    3    3   4*  12:5 14:5 11:5
--
B25  B26 B27  B28  B29  B30  B31 B32  B33  B34  B35
10:5 5*  5    5    5    5    5   8:7  9:7  10:7 11:7
6    6   8:6  9:6  10:6 14:6 3*  14:7 13:7 12:7 15:7
15:5 2*  13:6 12:6 11:6 15:6 1*  1    1    1    1
)"};
}

PrintedTable table_4_left() {
  return {.place = "Table 4 (left)",
          .caption = "A tight circular SCCD(3,2,3)",
          .parameters = {.v = 3, .k = 2, .change = 1, .kind = circular},
          .b = 3,
          .kinds = {circular},
          .tight = true,
          .layout = R"(
B'1 B'2 B'3
0   2*  2
1*  1   0*
)"};
}

PrintedTable table_4_right() {
  return {.place = "Table 4 (right)",
          .caption = "A tight circular DCCD(6,4,3)",
          .parameters = {.v = 6, .k = 4, .change = 2, .kind = circular},
          .b = 3,
          .kinds = {circular},
          .tight = true,
          .layout = R"(
B1  B2 B3
0   4* 4
1   5* 5
2*  2  0*
3*^ 3^ 1*^
)"};
}

PrintedTable table_5() {
  return {.place = "Table 5",
          .caption = "A minimum circular DCCD(8,5,5)",
          .parameters = {.v = 8, .k = 5, .change = 2, .kind = circular},
          .b = 5,
          .kinds = {circular},
          .minimum = true,
          .leaving = true,
          .elements = {"∞_s", "0_s", "1_s", "2_s", "∞_l", "0_l", "1_l", "2_l"},
          .layout = R"(
B0    B1   B2    B3   B4
∞_l*_ 1_s* 1_s   1_s_ 0_s*
0_l*  0_l  0_l   0_l_ ∞_s*_
0_s   0_s_ ∞_l*_ 1_l* 1_l
1_l   1_l_ ∞_s*_ 2_s* 2_s
2_s_  2_l* 2_l   2_l  2_l_
)"};
}

PrintedTable table_6() {
  return {.place = "Table 6",
          .caption = "A minimum circular DCCD(12,7,7)",
          .parameters = {.v = 12, .k = 7, .change = 2, .kind = circular},
          .b = 7,
          .kinds = {circular},
          .minimum = true,
          .leaving = true,
          .elements = {"∞_s", "0_s", "1_s", "2_s", "3_s", "4_s", "∞_l", "0_l", "1_l", "2_l", "3_l",
                       "4_l"},
          .layout = R"(
B0    B1   B2   B3    B4   B5   B6
∞_l*_ 3_s* 3_s  3_s   3_s_ 2_s* 2_s
0_l*  0_l  0_l  0_l   0_l_ 3_l* 3_l
0_s   0_s  0_s_ ∞_s*_ 1_l* 1_l  1_l
1_l   1_l_ 4_l* 4_l   4_l  4_l  4_l_
4_s_  2_l* 2_l  2_l   2_l  2_l_ 0_s*
3_l   3_l  3_l_ ∞_l*_ 4_s* 4_s  4_s
2_s   2_s_ 1_s* 1_s   1_s  1_s_ ∞_s*_
)"};
}

PrintedTable table_7() {
  return {.place = "Table 7",
          .caption = "A tight circular DCCD(10,4,9)",
          .parameters = {.v = 10, .k = 4, .change = 2, .kind = circular},
          .b = 9,
          .kinds = {circular},
          .tight = true,
          .elements = {"0", "1", "2", "3", "4", "5", "a", "b", "c", "d"},
          .layout = R"(
B1 B2 B3 B4 B5 B6 B7 B8 B9
0  a* c* 4* 4  4  4  a* b*
1  b* d* 5* 5  5  5  d* c*
2* 2  2  2  a* b* 0* 0  0
3* 3  3  3  c* d* 1* 1  1
)"};
}

PrintedTable table_8() {
  return {.place = "Table 8",
          .caption = "A tight circular DCCD(11,4,11)",
          .parameters = {.v = 11, .k = 4, .change = 2, .kind = circular},
          .b = 11,
          .kinds = {circular},
          .tight = true,
          .layout = R"(
B0,0 B0,1 B0,2 B0,3 B0,4 B0,5 B0,6 B0,7 B0,8 B0,9 B0,10
0    3*   3    3    6*   6    6    9*   9    9    1*
1    1    4*   4    4    7*   7    7    10*  10   10
2*   2    2    5*   5    5    8*   8    8    0*   0
5*   6*   7*   8*   9*   10*  0*   1*   2*   3*   4*
)"};
}

PrintedTable table_10() {
  return {.place = "Table 10",
          .caption = "A tight circular DCCD(21,4,42)",
          .parameters = {.v = 21, .k = 4, .change = 2, .kind = circular},
          .b = 42,
          .kinds = {circular},
          .tight = true,
          .layout = R"(
B0,0 B1,0 B0,1 B1,1 B0,2 B1,2 B0,3 B1,3 B0,4 B1,4 B0,5 B1,5 B0,6 B1,6
0    0    5*   3*   3    3    3    3    8*   6*   6    6    6    6
1    1    1    1    6*   4*   4    4    4    4    9*   7*   7    7
4*!  2*!  2    2    2    2    7*   5*   5    5    5    5    10*  8*
12*! 7*!  13*  8*   14*  9*   15*  10*  16*  11*  17*  12*  18*  13*
--
B0,7 B1,7 B0,8 B1,8 B0,9 B1,9 B0,10 B1,10 B0,11 B1,11 B0,12 B1,12 B0,13 B1,13
11*  9*   9    9    9!   9    14*   12*   12    12    12    12    17*   15*
7    7    12*  10*  10!  10   10    10    15*   13*   13    13    13    13
8    8    8    8    13*! 11*  11    11    11    11    16*   14*   14    14
19*  14*  20*  15*  0*   16*  1*    17*   2*    18*   3*    19*   4*    20*
--
B0,14 B1,14 B0,15 B1,15 B0,16 B1,16 B0,17 B1,17 B0,18 B1,18 B0,19 B1,19 B0,20 B1,20
15    15!   15    15    20*   18*   18!   18    18    18    2*    0*    0     0
18*   16*!  16    16    16    16    0*    19*   19    19    19    19!   3*!   1*!
14    14!   19*   17*   17    17    17!   17    1*    20*   20    20!   20    20
5*    0*    6*    1*    7*    2*    8*!   3*    9*    4*    10*   5*!   11*!  6*!
)"};
}

PrintedTable table_11() {
  return {.place = "Table 11",
          .caption = "Tight circular DCCD(13,3,26)",
          .parameters = {.v = 13, .k = 3, .change = 2, .kind = circular},
          .b = 26,
          .kinds = {circular},
          .tight = true,
          .layout = R"(
B0,0 B1,0 B0,1 B1,1 B0,2 B1,2 B0,3 B1,3 B0,4 B1,4 B0,5 B1,5 B0,6
0*   0    1*   1    2*   2    3*   3    4*   4    5*   5    6*
1    2*   2    3*   3    4*   4    5*   5    6*   6    7*   7
4*   7*   5*   8*   6*   9*   7*   10*  8*   11*  9*   12*  10*
--
B1,6 B0,7 B1,7 B0,8 B1,8 B0,9 B1,9 B0,10 B1,10 B0,11 B1,11 B0,12 B1,12
6    7*   7    8*   8    9*   9    10*   10*   11*   11    12*   12
8*   8    9*   9    10*  10   11*  11    12*   12    0*    0     1*
0*   11*  1*   12*  2*   0    3    1     4     2     5     3     6
)"};
}

}  // namespace

std::vector<PrintedTable> printed_tables() {
  return {table_1(), table_2(), table_3(), table_4_left(), table_4_right(), table_5(),
          table_6(), table_7(), table_8(), table_10(),     table_11()};
}

}  // namespace changeover
