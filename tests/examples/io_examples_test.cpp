// The examples of the headers of io/, as they stand there.
#include <regex>

#include "example_support.hpp"

namespace changeover::test::io_examples_test {
namespace {

class IoExamples : public InAFolder {
 protected:
  const Design design = three_blocks();
};

class InputExamples : public InAFolder {};

TEST_F(IoExamples, Text) {
  const std::string example = R"(
    # changeover design v=6 k=4 change=2 kind=circular
    0 1 2 3
    4 5 2 3
    4 5 0 1
)";
  StringSink sink;
  write_text(design, sink);
  EXPECT_EQ(sink.text(), without_margin(example));
}

TEST_F(IoExamples, Csv) {
  const std::string example = R"(
    block,element_1,element_2,element_3,element_4,v,change,kind
    1,0,1,2,3,6,2,circular
    2,4,5,2,3,6,2,circular
    3,4,5,0,1,6,2,circular
)";
  StringSink sink;
  write_csv(design, sink);
  EXPECT_EQ(sink.text(), without_margin(example));
}

TEST_F(IoExamples, Json) {
  const std::string example = R"(
    {"format":"changeover-design/1","v":6,"k":4,"change":2,"kind":"circular","blocks":[
    [0,1,2,3],
    [4,5,2,3],
    [4,5,0,1]
    ]}
)";
  StringSink sink;
  write_json(design, sink);
  EXPECT_EQ(sink.text(), without_margin(example));
}

TEST_F(InputExamples, OtherFormats) {
  put("from_gap.g", "BlockDesign(6, [[1,2,3,4],[3,4,5,6],[1,2,5,6]]);\n");
  Design design = read_design("from_gap.g");  // known by its content, like all formats
  StringSink sink;
  write_gap(design, sink);  // D := BlockDesign(6, [ … ]);
  EXPECT_THAT(sink.text(), HasSubstr("D := BlockDesign(6, [\n[1,2,3,4],\n"));
}

TEST_F(InputExamples, Input) {
  put("mine.txt", "0 1 2 3\n4 5 2 3\n4 5 0 1\n");
  std::unique_ptr<Input> input = open_input("mine.txt");  // "-": standard input
  Design design = read_text(std::move(input));
  EXPECT_EQ(design.block_count(), 3U);
}

TEST_F(InputExamples, ReadDesign) {
  put("mine.txt", "0 1 2 3\n4 5 2 3\n4 5 0 1\n");
  std::filesystem::copy("mine.txt", "huge.txt");
  Design design = read_design("mine.txt");  // "-": standard input
  EXPECT_EQ(design.parameters().kind, Kind::linear);
  auto stream = open_design("huge.txt", {.kind = Kind::circular});
  Verdict verdict = verify(*stream);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.parameters.kind, Kind::circular);
}

TEST_F(IoExamples, OutputFile) {
  put("mine.json", "what was there before");
  OutputFile file("mine.json");  // "" or "-": standard output
  write_json(design, file);
  file.flush();
  EXPECT_EQ(read_to_end(*open_input("mine.json")), "what was there before");
  file.commit();  // only now does mine.json change
  EXPECT_EQ(read_design("mine.json").block_count(), 3U);
}

TEST_F(IoExamples, Sink) {
  StringSink sink;
  write_text(design, sink);
  EXPECT_THAT(sink.text(), HasSubstr("0 1 2 3\n4 5 2 3\n"));
}

TEST_F(IoExamples, Request) {
  RequestList pairs{.rows = {{{.fields = {"Pump A", "Motor"}}}}};  // or .file = "pairs.csv"
  EXPECT_TRUE(pairs.is_given());
}

TEST_F(IoExamples, AlignedRows) {
  std::vector<MarkedElement> top;
  for (const AlignedBlock& column : aligned_rows(design)) {
    top.push_back({column[0].element, column[0].introduced, column[0].leaving});
  }
  EXPECT_THAT(top, ElementsAre(MarkedElement{0, false, true}, MarkedElement{4, true, false},
                               MarkedElement{4, false, true}));
}

TEST_F(IoExamples, Table) {
  const std::string example = R"(
    B1  B2  B3
    0   4*  4
    1   5*  5
    2*  2   0*
    3*  3   1*
      ^   ^   ^
)";
  StringSink sink;
  write_table(design, sink, {.positions = {1, 2, 3}});
  EXPECT_EQ(sink.text(), without_margin(example));
}

TEST_F(IoExamples, Latex) {
  const std::string example = R"(
    \begin{table}[ht!]
    \centering
    \begin{tabular}{lll}
    $B_{1}$ & $B_{2}$ & $B_{3}$ \\ %
    0 & 4$^*$ & 4 \\ %
    1 & 5$^*$ & 5 \\ %
    2$^*$ & 2 & 0$^*$ \\ %
    3$^*$ & 3 & 1$^*$
    \end{tabular}
    \caption{A circular DCCD(6,4,3)}
    \end{table}
)";
  StringSink sink;
  write_latex(design, sink);
  EXPECT_EQ(sink.text(), std::regex_replace(without_margin(example), std::regex(" %"), ""));
}

}  // namespace
}  // namespace changeover::test::io_examples_test
