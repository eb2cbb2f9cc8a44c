#include "changeover/io/formats.hpp"

#include <gmock/gmock.h>

#include "random_designs.hpp"

namespace changeover::other_formats_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Design read(const std::string& text, const ReadOptions& options = {}) {
  return read_design(input_from_text(text, "f"), options);
}
std::string fault(const std::string& text, const ReadOptions& options = {}) {
  return message_of([&] { (void)read(text, options); });
}
template <typename Write>
std::string written(Write&& write, const Design& design) {
  StringSink sink;
  write(design, sink);
  return sink.text();
}

// Seven points, blocks in an unusual order.
Design fano() {
  Design design({.v = 7, .k = 3, .change = 2, .kind = Kind::circular});
  for (const Block& block : std::vector<Block>{
           {0, 1, 3}, {3, 2, 1}, {2, 3, 5}, {3, 4, 6}, {4, 5, 0}, {5, 6, 1}, {6, 0, 2}}) {
    design.append(block);
  }
  return design;
}

TEST(OtherFormats, AreKnownByTheirContent) {
  EXPECT_EQ(guess_format("BlockDesign(7,[[1,2]])"), Format::literal);
  EXPECT_EQ(guess_format("# a comment, D := no\n\n D := BlockDesign ( 7,"), Format::literal);
  EXPECT_EQ(guess_format("# changeover design v=3\nD = IncidenceStructure("), Format::literal);
  EXPECT_EQ(guess_format("rec( v := 3,"), Format::literal);
  EXPECT_EQ(guess_format("\xEF\xBB\xBF <list_of_designs>"), Format::xml);
  EXPECT_EQ(guess_format("rec,a\n"), Format::csv);
  EXPECT_EQ(guess_format("BlockDesign a b\n"), Format::text);
  EXPECT_EQ(guess_format("D = 1 2\n"), Format::text);
}

TEST(OtherFormats, Gap) {
  EXPECT_EQ(written(write_gap, fano()),
            "# changeover design v=7 k=3 change=2 kind=circular\nD := BlockDesign(7, [\n"
            "[1,2,4],\n[2,3,4],\n[3,4,6],\n[4,5,7],\n[1,5,6],\n[2,6,7],\n[1,3,7]\n]);\n");
  const std::vector<Block> blocks{{0, 1, 3}, {1, 2, 4}};
  for (const char* text : {
           "BlockDesign(5, [[1,2,4],[2,3,5]])",
           "BlockDesign( 5, [ [ 1, 2, 4 ], [ 2, 3, 5 ] ] );;",
           "gap := BlockDesign(5,[[1,2,4],[2,3,5]]);  # of mine, with [1,2]\n",
           "rec( blocks := [ [ 1, 2, 4 ], [ 2, 3, 5 ] ], id := \"a ) , [\", isBinary := true,\n"
           "  isBlockDesign := true, autGroup := Group( [ (1,2)(3,4) ] ), v := 5 )",
           "D := rec( isBlockDesign:=true, v:=5, blocks:=[[1,2,4],[2,3,5]] );",
       }) {
    const Design design = read(text);
    EXPECT_EQ(design.blocks(), blocks) << text;
    EXPECT_EQ(design.parameters().v, 5U);
    EXPECT_TRUE(design.labels().empty());
  }
  EXPECT_EQ(read("BlockDesign(4, [[1 .. 3], [2,3,4]])").blocks(),
            (std::vector<Block>{{0, 1, 2}, {1, 2, 3}}));
}

TEST(OtherFormats, Sage) {
  EXPECT_THAT(written(write_sage, fano()),
              HasSubstr("\nD = IncidenceStructure(7, [\n[0,1,3],\n[1,2,3],\n"));
  for (const char* text : {
           "IncidenceStructure(5, [[0,1,3],[1,2,4]])",
           "IncidenceStructure([[0,1,3],[1,2,4]])",
           "D = BlockDesign(5, [(0,1,3), (1,2,4),], check=False)",
           "BlockDesign(5, [[0,1,3],[1,2,4]])",
           "IncidenceStructure(points=5, blocks=[[0,1,3],[1,2,4]], name='x)')",
       }) {
    EXPECT_EQ(read(text).blocks(), (std::vector<Block>{{0, 1, 3}, {1, 2, 4}})) << text;
  }
}

// As its authors print it: other elements, also with points in them, around the blocks.
TEST(OtherFormats, DesignTheory) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<list_of_designs\n design_type=\"block_design\"\n "
      "dtrs_protocol=\"2.0\"\n no_designs=\"1\"\n pairwise_nonisomorphic=\"true\"\n "
      "xmlns=\"http://designtheory.org/xml-namespace\">\n <info><software> [ DESIGN-1.1 ] "
      "</software></info>\n <designs>\n  <block_design b=\"2\" id=\"v4-b2-k3-0\" v=\"4\">\n   "
      "<blocks ordered=\"true\">\n    <block>\n     <z>0</z>\n     <z>1</z>\n <z> 2 </z>\n    "
      "</block>\n    <block><z>1</z><z>2</z><z>3</z></block>\n   </blocks>\n   <indicators>"
      "<t_design flag=\"true\"/></indicators>\n   <automorphism_group><permutation><z>1</z><z>0</z>"
      "</permutation></automorphism_group>\n  </block_design>\n </designs>\n</list_of_designs>\n";
  const Design design = read(text);
  EXPECT_EQ(design.blocks(), (std::vector<Block>{{0, 1, 2}, {1, 2, 3}}));
  EXPECT_EQ(design.parameters().change, 1U);
  const std::string ours = written(write_designtheory, fano());
  EXPECT_THAT(ours, HasSubstr("<?changeover design v=7 k=3 change=2 kind=circular?>"));
  EXPECT_THAT(ours, HasSubstr("   <blocks ordered=\"true\">\n    <block><z>0</z><z>1</z><z>3</z>"));
  EXPECT_EQ(read(ours).parameters(), fano().parameters());
}

TEST(OtherFormats, LaJolla) {
  EXPECT_EQ(written(write_ljcr, fano()), "1 2 4\n2 3 4\n3 4 6\n4 5 7\n1 5 6\n2 6 7\n1 3 7\n");
  const Design design = read(
      "{\"v\":7,\"k\":3,\"t\":2,\"size\":7,\"method\":\"lex\",\"blocks\":"
      "[[1,2,3],[1,4,5],[1,6,7],[2,4,6],[2,5,7],[3,4,7],[3,5,6]]}");
  EXPECT_EQ(design.block_count(), 7U);
  EXPECT_EQ(design.parameters().v, 7U);
  EXPECT_EQ(design.parameters().strength, 2U);
  EXPECT_EQ(design.label(0), "1");
  EXPECT_EQ(read("{\"v\":4,\"t\":3,\"blocks\":[[1,2,3],[1,2,4],[2,3,4]]}").parameters().strength,
            3U);
  EXPECT_THAT(fault("{\"v\":4,\"t\":2,\"blocks\":[[1,2],[1,4]]}"), HasSubstr("only 3 of them"));
  EXPECT_EQ(read("{\"v\":4,\"blocks\":[[0,1],[1,2]]}").parameters().v, 4U);
}

TEST(OtherFormats, OneLineForEachFault) {
  EXPECT_EQ(fault("BlockDesign(7, [[1,2],\n[2,x]])"),
            "f:2:4: expected a number; points are numbers");
  EXPECT_EQ(fault("D := BlockDesign(3, [[0,1],[1,2]]);"),
            "f:1:23: 0 is not a point; they are numbered from 1 to 3");
  EXPECT_EQ(fault("D = BlockDesign(3, [[0,1],[1,3]])"),
            "f:1:30: 3 is not a point; they are numbered from 0 to 2");
  EXPECT_THAT(fault("BlockDesign(9, [[1,2],[2,3]])"),
              HasSubstr("points may be counted from 1 (GAP)"));
  EXPECT_THAT(fault("BlockDesign(3, [[0,1],[2,3]])"),
              HasSubstr("points may be counted from 1 (GAP)"));
  EXPECT_THAT(fault("BlockDesign(7, [[1,2,4]], Group((1,2,3,4,5,6,7)));"),
              HasSubstr("f:1:27: a third argument"));
  EXPECT_THAT(fault("rec( isBlockDesign := true, blocks := [[1,2]] )"), HasSubstr("is missing"));
  EXPECT_THAT(fault("rec( v := 3 )"), HasSubstr("no blocks"));
  EXPECT_THAT(fault("rec( v := 3, v := 3 )"), HasSubstr("given twice"));
  EXPECT_THAT(fault("BlockDesign(3, [[1,2],[2,3]"), HasSubstr("but the text ends"));
  EXPECT_THAT(fault("BlockDesign(3, [[1,2],[2,3]]); BlockDesign(3, [[1,2]]);"),
              HasSubstr("one design per file"));
  EXPECT_THAT(fault("BlockDesign(3, [[1,2],[2,3,1]]);"), HasSubstr("block 2"));
  EXPECT_THAT(fault("BlockDesign(3, [[1,2],[]]);"), HasSubstr("block 2 is empty"));
  EXPECT_THAT(fault("BlockDesign(3, [[1,1],[2,3]]);"), HasSubstr("f:1:20: "));
  EXPECT_THAT(fault("BlockDesign(99999999999999999999, [[1,2]]);"), HasSubstr("from 1 to 65535"));
  EXPECT_THAT(fault("BlockDesign(3, [[1 .. 99999999999]]);"),
              HasSubstr("this range does not go up"));
  EXPECT_THAT(fault("BlockDesign(3, [[3 .. 1]]);"), HasSubstr("this range does not go up"));
  EXPECT_THAT(fault("# changeover design v=4\nBlockDesign(3, [[1,2],[2,3]]);"),
              HasSubstr("f:2:13: 3 points, but a comment says v=4"));
  EXPECT_THAT(fault("# labels: a b\nBlockDesign(3, [[1,2],[2,3]]);"), HasSubstr("f:1:1: "));
  EXPECT_THAT(fault("# labels: a a b\nBlockDesign(3, [[1,2],[2,3]]);"), HasSubstr("twice"));
  EXPECT_THAT(fault("# changeover design change=0\nBlockDesign(3, [[1,2],[2,3]]);"),
              HasSubstr("change="));
  EXPECT_THAT(fault("BlockDesign(n, [[1,2]]);"),
              HasSubstr("f:1:13: points and blocks are numbers"));
  EXPECT_THAT(fault("D := IncidenceStructure(3, [[1,2],[2,3]]);"), HasSubstr("is not a design"));
  EXPECT_THAT(fault("rec( v := 3, name := \"open )"), HasSubstr("a quote is opened"));
}

TEST(OtherFormats, OneLineForEachFaultInXml) {
  const auto xml = [](const std::string& inner, const std::string& attributes = "v='3'") {
    return fault("<list_of_designs><designs><block_design " + attributes + ">" + inner +
                 "</block_design></designs></list_of_designs>");
  };
  const std::string blocks = "<blocks><block><z>0</z><z>1</z></block></blocks>";
  EXPECT_EQ(xml(blocks), "");
  EXPECT_THAT(xml(""), HasSubstr("no block_design with blocks"));
  EXPECT_THAT(xml(blocks, ""), HasSubstr("no attribute v"));
  EXPECT_THAT(xml(blocks, "v='much'"), HasSubstr("'much' is not a number of points"));
  EXPECT_THAT(xml("<blocks><block><z>0</z><z>3</z></block></blocks>"),
              HasSubstr("3 is not a point"));
  EXPECT_THAT(xml("<blocks><block><z>-1</z></block></blocks>"), HasSubstr("'-1' is not a point"));
  EXPECT_THAT(xml("<blocks><block>0 1</block></blocks>"), HasSubstr("text among the blocks"));
  EXPECT_THAT(xml("<blocks><block><q>1/2</q></block></blocks>"), HasSubstr("'q' among the blocks"));
  EXPECT_THAT(xml("<blocks><block><z>0"), HasSubstr("not XML"));
  EXPECT_THAT(fault("<html/>"), HasSubstr("the file begins with 'html'"));
  EXPECT_THAT(fault("<list_of_designs><block_design v='3'>" + blocks +
                    "</block_design><block_design v='3'/></list_of_designs>"),
              HasSubstr("a second design"));
  EXPECT_THAT(fault("<!DOCTYPE l [<!ENTITY z '<z>0</z>'>]><l>&z;</l>"),
              HasSubstr("an entity is declared"));
  EXPECT_THAT(fault("<?changeover design kind=round?><list_of_designs/>"), HasSubstr("kind="));
}

TEST(OtherFormats, TheCallerKnowsBetter) {
  const Design design = read("BlockDesign(3, [[1,2],[2,3]])", {.kind = Kind::circular});
  EXPECT_EQ(design.parameters().kind, Kind::circular);
}

RC_GTEST_PROP(OtherFormats, WriteReadWriteIsTheSame, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const auto v = static_cast<std::uint64_t>(*rc::gen::inRange(2, 40));
  const auto k = 2 + random() % (v - 1);
  Design design(
      {.v = v,
       .k = k,
       .change = 1 + random() % k,
       .kind = random() % 2 == 0 ? Kind::linear : Kind::circular,
       .strength = static_cast<std::uint32_t>(2 + random() % (std::min<std::uint64_t>(k, 4) - 1))});
  std::vector<Element> points(v);
  std::iota(points.begin(), points.end(), 0U);
  for (std::uint64_t b = 1 + random() % 9; b > 0; --b) {
    std::shuffle(points.begin(), points.end(), random);
    design.append(std::span(points).first(k));
  }
  if (random() % 2 == 0) {
    std::vector<std::string> labels = random_labels(v, random);
    labels[0] += "?>&amp;--]]>";
    design.set_labels(labels);
  }
  for (const auto& write : {write_gap, write_sage, write_designtheory}) {
    const std::string text = written(write, design);
    const Design again = read(text);
    RC_ASSERT(again.parameters() == design.parameters());
    RC_ASSERT(again.labels() == design.labels());
    RC_ASSERT(written(write, again) == text);
    for (std::size_t i = 0; i < design.block_count(); ++i) {
      Block block(design.block(i).begin(), design.block(i).end());
      std::sort(block.begin(), block.end());
      RC_ASSERT(again.blocks()[i] == block);
    }
  }
}

// Whatever is damaged, there is a design or one line.
TEST(OtherFormats, DamagedBytes) {
  std::mt19937 random(1);
  for (const auto& write : {write_gap, write_sage, write_designtheory}) {
    const std::string good = written(write, fano());
    std::size_t faults = 0;
    for (int i = 0; i < 1000; ++i) {
      std::string bad = good;
      bad[random() % bad.size()] = static_cast<char>(random());
      if (i % 5 == 0) {
        bad.resize(random() % bad.size());
      }
      const std::string what = fault(bad);
      faults += what.empty() ? 0U : 1U;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
    EXPECT_GT(faults, 300U);
  }
}

}  // namespace
}  // namespace changeover::other_formats_test
