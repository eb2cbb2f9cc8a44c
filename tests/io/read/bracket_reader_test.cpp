#include <algorithm>
#include <random>

#include "changeover/io/formats.hpp"
#include "changeover/io/input.hpp"
#include "random_designs.hpp"

namespace changeover::bracket_reader_test {
namespace {

Design read(const std::string& text, const ReadOptions& options = {}) {
  return read_design(input_from_text(text, "f"), options);
}

void refuses(const std::string& text, const std::string& says) {
  EXPECT_REFUSAL((void)read(text), BadInput, says);
}

TEST(BracketReader, KnowsItsBeginnings) {
  for (const char* brackets :
       {"{A,B}", "(1 2)\n(2 3)", "[1,2,4]\n[2,3,5]", "[['a','b']]", "[[a,b],[b,c]]", "[(0,1)]",
        "B = [[0,1]]", "blocks := [[1,2]];", "gap> blocks := [[1,2]];", ">>> [(0,1)]",
        "# mine, all\n{0,1}", "\xEF\xBB\xBF{ A", "['a','b']", "# c\n[[1,2],[2,3]]", "[{1,2},{2,3}]",
        "gap> [[1,2]];", "sage: [[0,1]]", "{\"A\",\"B\"} {\"B\",\"C\"}"}) {
    EXPECT_EQ(guess_format(brackets), Format::brackets) << brackets;
  }
  for (const char* json : {"{}", "{\"v\":3}", "[]", "[[1,2]]", "[[\"a\",\"b\"]]", "[{\"v\":3}]",
                           "{\"v\"", "{ \"v\" : 3 }", "{", "["}) {
    EXPECT_EQ(guess_format(json), Format::json) << json;
  }
  EXPECT_EQ(guess_format("sage: D = IncidenceStructure([[0,1]])"), Format::literal);
  EXPECT_EQ(guess_format("# labels: (a b\n(a b\n"), Format::text);
  EXPECT_EQ(guess_format("# changeover design v=3\n{a b\n"), Format::text);
  EXPECT_EQ(guess_format("A = 1"), Format::text);
}

TEST(BracketReader, ReadsSetsAsPeopleWriteThem) {
  const std::vector<Block> blocks{{0, 1, 2}, {1, 2, 3}, {2, 3, 0}};
  for (
      const char* text : {
          "{A,B,C}\n{B,C,D}\n{C,D,A}\n",
          "{A,B,C}, {B,C,D}, {C,D,A}",
          "(A B C)\r\n(B C D)\r\n(C D A)\r\n",
          "[ [ A, B, C ], # first\n [ B, C, D ], [ C, D, A ] ]",
          "B = [('A','B','C'),('B','C','D'),('C','D','A')]",
          "gap> blocks := [ [ \"A\", \"B\", \"C\" ], [ \"B\", \"C\", \"D\" ], [\"C\",\"D\",\"A\"] ];;",
          "{{A;B;C};{B;C;D};{C;D;A}}",
      }) {
    const Design design = read(text);
    EXPECT_EQ(design.labels(), (std::vector<std::string>{"A", "B", "C", "D"})) << text;
    ASSERT_EQ(design.block_count(), blocks.size()) << text;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      EXPECT_TRUE(std::ranges::equal(design.block(i), blocks[i])) << text;
    }
  }
}

TEST(BracketReader, NumbersAreAsInAnArrayOfJson) {
  EXPECT_TRUE(read("{0,1} {1,2}").labels().empty());
  EXPECT_EQ(read("(1,2) (2,3)").labels(), (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_EQ(read("(1,2) (2,3)", {.v = 5}).v(), 5U);
  EXPECT_EQ(read("(1 2')(2' 3)").labels(), (std::vector<std::string>{"1", "2'", "3"}));
  EXPECT_EQ(read("{1',2} {2,3} {1',3}").block_count(), 3U);
  EXPECT_EQ(read("(10,2) (2,x)").labels(), (std::vector<std::string>{"10", "2", "x"}));
}

// Every design comes back from its blocks in brackets, whatever separates them.
TEST(BracketReader, RandomDesignsComeBack) {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    const Parameters p{.v = 6 + random() % 10, .k = 3 + random() % 3};
    Design design(p);
    std::vector<Element> all(static_cast<std::size_t>(p.v));
    std::iota(all.begin(), all.end(), Element{0});
    for (std::size_t b = 0, count = 2 + random() % 8; b < count; ++b) {
      std::shuffle(all.begin(), all.end(), random);
      design.append(std::span(all).first(static_cast<std::size_t>(p.k)));
    }
    const std::size_t kind = random() % 3;
    const std::string between = random() % 2 == 0 ? "," : " ";
    const bool is_list = random() % 2 == 0;
    std::string text = is_list ? "D := [" : "";
    for (std::size_t b = 0; b < design.block_count(); ++b) {
      text += (b == 0 ? "" : between) + "([{"[kind];
      for (std::size_t j = 0; j < p.k; ++j) {
        text += (j == 0 ? "" : between) + std::to_string(design.block(b)[j]);
      }
      text += ")]}"[kind];
    }
    text += is_list ? "]" : "";
    // [[0,1],[2,3]] without "D :=" is JSON, and says the same.
    const Design again = read(text, {.v = p.v});
    EXPECT_TRUE(std::ranges::equal(again.elements(), design.elements())) << text;
  }
}

TEST(BracketReader, RefusesWhatIsNotBlocks) {
  refuses("{A,B,D}\nB C E\n", "f:2:1: 'B' is in no bracket; write each block as {A,B,C}");
  refuses("{A,B,{D}}", "f:1:6: a bracket within a block; write each block as {A,B,C}");
  refuses("[[A,B],C]", "f:1:8: 'C' is between blocks; write each block as {A,B,C}");
  refuses("{{{A,B}}}", "f:1:3: a bracket within a block; write each block as {A,B,C}");
  refuses("{A,B)", "f:1:5: this bracket closes none that is open; correct it");
  refuses("{A,B", "f:1:1: this bracket is not closed; close it");
  refuses("{A,B}}", "f:1:6: this bracket closes none that is open; correct it");
  refuses("{1,2, // x\n3}", "f:1:7: '//' is not an element; begin a comment with #");
  refuses("{a : 1}", "f:1:4: ':' is not an element; write every block as {A,B,C}");
  refuses("{1,…,3}", "f:1:4: '…' is not an element; write every block as {A,B,C}");
  refuses("{},{1}", "f:1:1: block 1 is empty; remove it");
  refuses("{1},{2}", "f:1:1: strength = 2 exceeds k = 1: no block holds that many elements");
  refuses("{'A,B}", "f:1:2: a quote is opened and not closed; close it");
  refuses("{'A'B}", "f:1:5: a name goes on after its quote; correct it");
  EXPECT_REFUSAL((void)read_brackets(*input_from_text("# x\n", "f")), BadInput,
                 "f:2:1: no blocks; write each block as {A,B,C}");
  refuses("{1..3}", "f:1:2: a range; write out its elements");
  refuses("()", "f:1:1: block 1 is empty; remove it");
  refuses("{A,A,B}", "f:1:4: element 'A' is twice in block 1; remove or correct one");
  refuses("{A,B}{C,D,E}",
          "f:1:11: block 2 has more than the 2 elements of the blocks before; correct one of them");
}

TEST(BracketReader, LinesOfTextHaveNoSuchSigns) {
  refuses("A B D\nx (B C\n",
          "f:2:3: '(B' has a bracket; write every block as {A,B,C}, or list all names in a line "
          "'# labels: …'");
  refuses("B: A B D\n", "f:1:1: 'B:' looks like the name of the block; leave it out");
  refuses("1. A B D\n", "f:1:1: '1.' looks like the name of the block; leave it out");
  refuses("A B D % first\n", "f:1:7: '%' is not an element; begin a comment with #");
  refuses("B =\n", "f:1:3: '=' is not an element; write every block as {A,B,C}");
  refuses("gap> 1 2\n", "f:1:1: 'gap>' is not an element; write every block as {A,B,C}");
  refuses("a{A,B},{B,C}\n",
          "f:1:1: 'a{A' has a bracket; write every block as {A,B,C}, or list all names in a line "
          "'# labels: …'");
  refuses("B: {A,B}\n",
          "f:1:1: 'B: {A' has a bracket; write every block as {A,B,C}, or list all names in a line "
          "'# labels: …'");
  refuses("ABD\nBCE\n",
          "f:1:1: each block has one element; separate the elements of a block by blanks");
  EXPECT_EQ(read("# labels: B: (A %\nB: (A %\n").v(), 3U);
  EXPECT_EQ(read("# changeover design v=2\na: b\n").v(), 2U);
  for (const char* names : {"A(1) A(2)\nA(1) A(3)\n", "f[0],f[1]\nf[0],f[2]\n"}) {
    EXPECT_EQ(read(names).v(), 3U) << names;  // brackets that belong to names
  }
}

}  // namespace
}  // namespace changeover::bracket_reader_test
