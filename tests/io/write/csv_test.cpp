#include "changeover/io/formats.hpp"

#include "random_designs.hpp"

namespace changeover::csv_test {
namespace {

Design read(const std::string& text, const ReadOptions& options = {}) {
  return read_csv(*input_from_text(text, "f"), options);
}

std::string written(const Design& design) {
  StringSink sink;
  write_csv(design, sink);
  return sink.take();
}

std::string complaint(const std::string& text, const ReadOptions& options = {}) {
  return message_of([&] { (void)read(text, options); });
}

using Labels = std::vector<std::string>;

TEST(CsvTest, TheExampleIsReadAndWrittenBack) {
  const std::string text =
      "block,element_1,element_2,element_3,element_4,v,change,kind\n"
      "1,0,1,2,3,6,2,circular\n2,4,5,2,3,6,2,circular\n3,4,5,0,1,6,2,circular\n";
  const Design design = read(text);
  EXPECT_EQ(design.parameters(), (Parameters{.v = 6, .k = 4, .change = 2, .kind = Kind::circular}));
  EXPECT_EQ(written(design), text);
}

TEST(CsvTest, StrengthAndLabelsHaveColumnsOfTheirOwn) {
  Design design(Parameters{.v = 5, .k = 3, .change = 1, .strength = 3},
                std::vector<Block>{{0, 1, 2}, {0, 1, 3}});
  design.set_labels({"10", "20", "30", "40", "50"});
  const std::string text = written(design);
  EXPECT_EQ(text,
            "block,element_1,element_2,element_3,v,change,kind,strength,elements\n"
            "1,10,20,30,5,1,linear,3,labels\n2,10,20,40,5,1,linear,3,labels\n");
  EXPECT_EQ(read(text).labels(), (Labels{"10", "20", "30", "40", "5"}));
  EXPECT_EQ(written(read(text)), text);
}

TEST(CsvTest, WhatSpreadsheetsMakeOfItIsTaken) {
  const Design plain = read("0,1,2\n0,3,4\n");
  EXPECT_EQ(plain.parameters(), (Parameters{.v = 5, .k = 3, .change = 2}));
  EXPECT_EQ(read("0;1;2\r\n0;3;4\r\n").v(), 5U);
  const Design named = read(
      "\xEF\xBB\xBF\"Block\";\"Element 1\";\"element2\";\"note\"\n"
      "1;a ; \"b\" ;\"x;\"\"y\"\n;;;\n\n# a comment\n2;c;b;\n");
  EXPECT_EQ(named.labels(), (Labels{"a", "b", "c"}));
  EXPECT_EQ(named.block_count(), 2U);
}

TEST(CsvTest, ColumnsMayComeInAnyOrderAndConstantsOnce) {
  const Design design = read("kind,element_2,v,element_1\ncircular,1,7,0\n,2,,1\n");
  EXPECT_EQ(design.parameters(), (Parameters{.v = 7, .k = 2, .change = 1, .kind = Kind::circular}));
  EXPECT_EQ(design.block(0)[0], 1U);
}

TEST(CsvTest, APermutationOfTheNumbersIsWrittenAsNumbers) {
  Design design(Parameters{.v = 3, .k = 2, .change = 1}, std::vector<Block>{{0, 1}, {1, 2}});
  design.set_labels({"2", "0", "1"});
  EXPECT_EQ(written(design),
            "block,element_1,element_2,v,change,kind\n1,2,0,3,1,linear\n2,0,1,3,1,linear\n");
  EXPECT_EQ(written(read(written(design))), written(design));
}

TEST(CsvTest, ANameThatASpreadsheetWouldComputeIsEscapedAndComesBack) {
  Design design(Parameters{.v = 7, .k = 7}, std::vector<Block>{{0, 1, 2, 3, 4, 5, 6}});
  const Labels labels = {"=1+1", "+a", "-1", "@x", "'=1", "'tis", "a;b"};
  design.set_labels(labels);
  const std::string text = written(design);
  EXPECT_NE(text.find("\n1,'=1+1,'+a,-1,'@x,''=1,'tis,\"a;b\",7,"), std::string::npos) << text;
  EXPECT_EQ(read(text).labels(), labels);
  EXPECT_EQ(written(read(text)), text);
}

TEST(CsvTest, NumbersTooLargeForElementsAreLabels) {
  const Design design = read("0,70000\n65535,0\n");
  EXPECT_EQ(design.labels(), (Labels{"0", "65535", "70000"}));
  EXPECT_EQ(written(read(written(design))), written(design));
}

struct Case {
  std::string text;
  std::string message;
};

TEST(CsvTest, EachFaultHasItsLineColumnAndRemedy) {
  const std::vector<Case> cases = {
      {"", "f:1:1: no blocks; give at least one"},
      {"block,element_1\n", "f:1:1: no blocks; give at least one"},
      {"block,x\n1,2\n",
       "f:1:1: no columns element_1, element_2, …; give the columns of elements these names"},
      {"0,1,2\n0,1\n",
       "f:2:3: block 2 has 2 elements, the blocks before have 3; correct one of them"},
      {"0,1\n0,1,2\n",
       "f:2:5: block 2 has more than the 2 elements of the blocks before; correct one of them"},
      {"0,1\n2,2\n", "f:2:3: element '2' is twice in block 2; remove or correct one"},
      {"element_1,element_2,v\n0,1,3\n0, 7,3\n",
       "f:3:4: element '7' is not below v = 3; count from 0, or leave v out"},
      {"element_1,element_2,v\n0,1,3\n0,2,4\n",
       "f:3:5: v is '4' here and '3' in the rows before; make them equal"},
      {"element_1,element_2,v\n0,1,x\n",
       "f:2:5: v='x': bad value; give a whole number from 1 to 65535"},
      {"element_1,element_2,k\n0,1,3\n",
       "f:2:1: block 1 has 2 elements, not k = 3; correct it, or k"},
      {"element_1,v,v\n", "f:1:13: two columns v; remove one"},
      {"element_1,elements\n0,x\n",
       "f:2:3: the column elements says neither labels nor numbers; write one of them"},
      {"0,\"1\n", "f:1:3: a quote is opened and not closed on this line; close it"},
      {"0,\"1", "f:1:3: a quote is opened and not closed on this line; close it"},
      {"0,\"1\"2\n", "f:1:6: text after a closing quote; double each quote within quotes"},
      {"0,1\r2,3\n", "f:1:4: carriage return inside a line; end lines with LF or CR LF"},
      {"# a\r0,1\r", "f:1:4: carriage return inside a line; end lines with LF or CR LF"},
      {std::string("0,\0", 3), "f:1:3: control byte 0x00; give plain text in UTF-8"},
      {"a,b c\n", "f:1:3: a name with a blank or control character; use '_' or '-' instead"},
      {"a,\"b,c\"\n",
       "f:1:3: a name with a comma, which not every format can carry; use another character"},
      {"a," + std::string(300, 'x'), "f:1:3: a field of more than 255 bytes; use shorter names"},
      {"B0,0 B1,0\n0 1*\n",
       "f:1:1: this looks like a table for people; write it with --format text or --json"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(complaint(c.text), c.message) << c.text;
  }
}

RC_GTEST_PROP(CsvProperty, WritingReadingAndWritingGivesTheSameBytes, (std::uint32_t seed)) {
  const Design design = random_design(seed);
  const std::string text = written(design);
  const Design again = read(text);
  RC_ASSERT(again.parameters() == design.parameters());
  RC_ASSERT(written(again) == text);
}

RC_GTEST_PROP(CsvProperty, MutatedFilesGiveADesignOrOneLine, (std::uint32_t seed)) {
  read_mutated_file(
      seed, [](const std::string& text) { return read(text); }, written);
}

}  // namespace
}  // namespace changeover::csv_test
