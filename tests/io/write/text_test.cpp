#include "changeover/io/formats.hpp"

#include <unistd.h>

#include "changeover/core/developed.hpp"
#include "changeover/io/input.hpp"
#include "random_designs.hpp"

namespace changeover::text_test {
namespace {

// An input that cannot be rewound and hands out a few bytes at a time.
class PipeInput final : public Input {
 public:
  explicit PipeInput(std::string text, std::size_t piece = 7)
      : Input("<stdin>"), text_(std::move(text)), piece_(piece) {}
  std::size_t read(std::span<char> buffer) override {
    const std::size_t count = std::min({buffer.size(), piece_, text_.size() - position_});
    std::copy_n(text_.data() + position_, count, buffer.data());
    position_ += count;
    return count;
  }

 private:
  std::string text_;
  std::size_t piece_;
  std::size_t position_ = 0;
};

// `count` bytes made of `unit` over and over, and how many of them were asked for.
class EndlessInput final : public Input {
 public:
  EndlessInput(std::string unit, std::uint64_t count, std::uint64_t* taken)
      : Input("endless"), unit_(std::move(unit)), left_(count), taken_(taken) {}
  std::size_t read(std::span<char> buffer) override {
    std::size_t size = 0;
    for (; size < buffer.size() && left_ > 0; ++size, --left_, ++*taken_) {
      buffer[size] = unit_[*taken_ % unit_.size()];
    }
    return size;
  }

 private:
  std::string unit_;
  std::uint64_t left_;
  std::uint64_t* taken_;
};

Design read(const std::string& text, const ReadOptions& options = {}) {
  return read_text(input_from_text(text, "f"), options);
}

std::string written(const Design& design) {
  StringSink sink;
  write_text(design, sink);
  return sink.take();
}

std::string complaint(const std::string& text, const ReadOptions& options = {}) {
  return message_of([&] { (void)read(text, options); });
}

using Labels = std::vector<std::string>;

TEST(TextTest, TheExampleIsReadAndWrittenBack) {
  const std::string text =
      "# changeover design v=6 k=4 change=2 kind=circular\n0 1 2 3\n4 5 2 3\n4 5 0 1\n";
  const Design design = read(text);
  EXPECT_EQ(design.parameters(), (Parameters{.v = 6, .k = 4, .change = 2, .kind = Kind::circular}));
  EXPECT_EQ(design.blocks(), (std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}}));
  EXPECT_EQ(written(design), text);
}

TEST(TextTest, WhatTheFileDoesNotSayIsInferred) {
  const Design design = read("0 1 2\n0 3 4\n");
  EXPECT_EQ(design.parameters(), (Parameters{.v = 5, .k = 3, .change = 2, .kind = Kind::linear}));
  EXPECT_EQ(read("0 1 2\n0 1 3\n").parameters().change, 1U);
  EXPECT_EQ(read("0 1 2\n").parameters().change, 2U);
  EXPECT_EQ(read("0 1 2\n2 1 0\n").parameters().change, 2U);
}

TEST(TextTest, TheCallerWinsOverTheHeader) {
  const ReadOptions options{.v = 9, .change = 1, .kind = Kind::circular, .strength = 3};
  const Design design =
      read("# changeover design v=7 change=2 kind=linear\n0 1 2\n0 3 4\n", options);
  EXPECT_EQ(design.parameters(),
            (Parameters{.v = 9, .k = 3, .change = 1, .kind = Kind::circular, .strength = 3}));
}

TEST(TextTest, UndeclaredNumbersThatAreNotAnInitialRangeBecomeLabelsInOrder) {
  const Design design = read("10 2 33\n2 33 4\n");
  EXPECT_EQ(design.labels(), (Labels{"2", "4", "10", "33"}));
  EXPECT_EQ(design.blocks(), (std::vector<Block>{{2, 0, 3}, {0, 3, 1}}));
}

TEST(TextTest, UndeclaredWordsBecomeLabelsAsTheyOccur) {
  const Design design = read("b a 3\na 3 ∞_s\n");
  EXPECT_EQ(design.labels(), (Labels{"b", "a", "3", "∞_s"}));
  EXPECT_EQ(read("01 02\n02 03\n").labels(), (Labels{"01", "02", "03"}));
}

TEST(TextTest, WordsUnderADeclaredVAreNamedAsTheyOccurAndTheRestByNumbers) {
  const Design design = read("# changeover design v=7\n0 1 2\na b 2\n");
  EXPECT_EQ(design.labels(), (Labels{"0", "1", "2", "a", "b", "7", "8"}));
}

TEST(TextTest, ListedLabelsNameTheElements) {
  const Design design = read("# labels: c b a\na b\n");
  EXPECT_EQ(design.labels(), (Labels{"c", "b", "a"}));
  EXPECT_EQ(design.blocks(), (std::vector<Block>{{2, 1}}));
  EXPECT_TRUE(read("# labels: 0 1 2\n0 1\n").labels().empty());
  EXPECT_EQ(read("# labels: 2 1 0\n0 1\n").labels(), (Labels{"2", "1", "0"}));
}

TEST(TextTest, CommentsBlankLinesTabsCarriageReturnsAndAByteOrderMarkAreTolerated) {
  const Design design =
      read("\xEF\xBB\xBF# changeover design v=5\r\n#\r\n\r\n  0\t1 2 # trailing\r\n\n#x\n0 3 4#y");
  EXPECT_EQ(design.v(), 5U);
  EXPECT_EQ(design.blocks(), (std::vector<Block>{{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(read("0 1\n1 2\r").block_count(), 2U);
}

TEST(TextTest, ARecipeIsKept) {
  const std::string text =
      "# changeover design v=3 k=2 change=1 kind=linear\n"
      "# recipe: {\"construction\":\"x\",\"v\":3,\"k\":2,\"change\":1,\"kind\":\"linear\","
      "\"arguments\":{\"c\":-1},\"inputs\":[]}\n0 1\n1 2\n";
  const Design design = read(text);
  ASSERT_TRUE(design.recipe);
  EXPECT_EQ(design.recipe->arguments.at("c"), -1);
  EXPECT_EQ(written(design), text);
}

struct Case {
  std::string text;
  std::string message;
};

TEST(TextTest, EachFaultHasItsLineColumnAndRemedy) {
  const std::string long_word(256, 'x');
  const std::vector<Case> cases = {
      {"", "f:1:1: no blocks; give one block per line, its elements separated by blanks"},
      {"# only\n\n# comments\n",
       "f:4:1: no blocks; give one block per line, its elements separated "
       "by blanks"},
      {"0 1 2\n0 1\n",
       "f:2:4: block 2 has 2 elements, the blocks before have 3; correct one of them"},
      {"0 1 2\n0 1",
       "f:2:4: block 2 has 2 elements, the blocks before have 3; correct one of them"},
      {"0 1 2\n0 1 3 4\n",
       "f:2:7: block 2 has more than the 3 elements of the blocks before; correct one of them"},
      {"# changeover design v=9 k=3\n0 1\n",
       "f:2:4: block 1 has 2 elements, not k = 3; correct it, or k"},
      {"# changeover design v=9 k=3\n0 1 2 3\n",
       "f:2:7: block 1 has more than k = 3 elements; correct it, or k"},
      {"0 1 2\n3 1 3\n", "f:2:5: element '3' is twice in block 2; remove or correct one"},
      {"# changeover design v=3\n0 1\n1 3\n",
       "f:3:3: element '3' is not below v = 3; count from 0, or leave v out"},
      {"# changeover design v=3\n0 1\n1 99999999999999999999999\n",
       "f:3:3: element '99999999999999999999999' is not below v = 3; count from 0, or leave v out"},
      {"ab " + long_word + "\n",
       "f:1:4: a word of more than 255 bytes; elements are separated by "
       "blanks and blocks by line ends"},
      {std::string("0 1\n0\0001\n", 9), "f:2:2: control byte 0x00; give plain text in UTF-8"},
      {"0 1\n\x01\n", "f:2:1: control byte 0x01; give plain text in UTF-8"},
      {"0 a\x7f\n", "f:1:4: control byte 0x7f; give plain text in UTF-8"},
      {"# \x02\n0 1\n", "f:1:3: control byte 0x02; give plain text in UTF-8"},
      {"0 1\r2 3\n", "f:1:4: carriage return inside a line; end lines with LF or CR LF"},
      {"# a\r0 1\r", "f:1:4: carriage return inside a line; end lines with LF or CR LF"},
      {"# changeover design v=0\n0 1\n",
       "f:1:21: v='0': bad value; give a whole number from 1 to 65535"},
      {"# changeover design v=65536\n0 1\n",
       "f:1:21: v='65536': bad value; give a whole number from 1 to 65535"},
      {"# changeover design kind=round\n0 1\n",
       "f:1:21: kind='round': bad value; give linear or circular"},
      {"# changeover design strength=5\n0 1\n",
       "f:1:21: strength='5': bad value; give a whole number from 2 to 4"},
      {"# changeover design v=4 v=4\n0 1\n", "f:1:25: v is given twice; give it once"},
      {"# changeover design v=4\n# changeover design k=x\n0 1\n",
       "f:2:21: k='x': bad value; give a whole number from 1 to 65535"},
      {"# changeover design v=4 k=2 change=3\n0 1\n",
       "f:1:14: change = 3: consecutive blocks must differ in 1 to k = 2 elements"},
      {"# changeover design strength=3\n0 1\n",
       "f:1:14: strength = 3 exceeds k = 2: no block holds that many elements"},
      {"7\n", "f:1:1: strength = 2 exceeds k = 1: no block holds that many elements"},
      {"# labels: a b a\na b\n", "f:1:15: label 'a' is listed twice; remove or correct one"},
      {"# labels:\na b\n", "f:1:3: no labels; list one for each element, or leave the list out"},
      {"# labels: a b\n# labels: c\na b\n", "f:2:3: labels are listed twice; list them once"},
      {"# changeover design v=3\n# labels: a b\na b\n",
       "f:2:3: 2 labels for v = 3 elements; give one each"},
      {"# labels: a b,c\na\n",
       "f:1:13: a name with a comma, which not every format can carry; use "
       "another character"},
      {"# labels: a b\na c\n",
       "f:2:3: element 'c' is not in the list of labels; correct one of them"},
      {"# changeover design v=3\na b\nc d\n",
       "f:3:3: element 'd' is one too many for v = 3; correct it, or v"},
      {"a \"b\"\n",
       "f:1:3: a name with a double quote, which not every format can carry; use "
       "another character"},
      {"0 1\n# changeover design v=4\n1 2\n",
       "f:2:3: a header after the first block; move it to the top, one design per file"},
      {"0 1\n# labels: a b\n1 2\n",
       "f:2:3: labels after the first block; move it to the top, one design per file"},
      {"B1  B2\n0   4*\n1   5*\n",
       "f:1:1: this looks like a table for people; write it with --format text or --json"},
      {"B0,0 B1,0\n0 1\n",
       "f:1:1: this looks like a table for people; write it with --format text or --json"},
      {"\x1b[1mB1\x1b[0m B2\n",
       "f:1:1: this looks like a coloured table for people; write it with --format text or --json"},
      {"\\begin{tabular}{ll}\n",
       "f:1:1: this looks like LaTeX, a table for people; write it with --format text or --json"},
      {"0 & 1\n",
       "f:1:1: this looks like LaTeX, a table for people; write it with --format text or --json"},
      {"# recipe: {\"construction\":1}\n0 1\n",
       "f:1:27: expected the name of a construction in quotes, found a number; correct it"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(complaint(c.text), c.message) << c.text;
  }
}

TEST(TextTest, AWordAmongDeclaredNumbersIsTakenAsANameIfItComesEarlyAndRefusedIfLate) {
  std::string text = "# changeover design v=9\n";
  for (int i = 0; i < 100'000; ++i) {
    text += "0 1 2\n";
  }
  EXPECT_EQ(
      complaint(text + "0 x 2\n"),
      "f:100002:3: element 'x' is not a number, but those before are; list all names in a line "
      "'# labels: …'");
}

TEST(TextTest, BlocksNamedLikeColumnsAreStillBlocks) {
  EXPECT_EQ(read("B1 B2\nB2 B3\n").labels(), (Labels{"B1", "B2", "B3"}));
}

TEST(TextTest, TheCallersParametersAreCheckedToo) {
  EXPECT_EQ(complaint("0 1\n", {.v = 70'000}),
            "f: v = 70000 is out of range; give a whole number from 1 to 65535");
  EXPECT_EQ(complaint("0 1\n", {.k = 0}),
            "f: k = 0 is out of range; give a whole number from 1 to 65535");
  EXPECT_EQ(complaint("0 1\n", {.k = 3}),
            "f:1:4: block 1 has 2 elements, not k = 3; correct it, or k");
  EXPECT_EQ(complaint("0 1\n", {.v = 1}),
            "f:1:3: element '1' is not below v = 1; count from 0, or leave v out");
}

TEST(TextTest, WhatOnlyTheCallerSaysWrongIsToldApart) {
  const auto blame = [](const std::string& text, const ReadOptions& options) {
    return message_of<BadOption>([&] { (void)read(text, options); });
  };
  EXPECT_EQ(blame("0 1\n", {.change = 0}),
            "f: change = 0 is out of range; give a whole number from 1 to 65535");
  EXPECT_EQ(blame("0 1\n", {.strength = 5}),
            "f: strength = 5 is out of range; give a whole number from 2 to 4");
  EXPECT_EQ(blame("0 1\n", {.change = 3}),
            "f: change = 3: consecutive blocks must differ in 1 to k = 2 elements");
  EXPECT_EQ(blame("# changeover design change=2\n0 1\n", {.strength = 3}),
            "f: strength = 3 exceeds k = 2: no block holds that many elements");
  const auto is_callers_fault = [](const std::string& text, const ReadOptions& options) {
    try {
      (void)read(text, options);
    } catch (const BadOption&) {
      return true;
    } catch (const BadInput&) {
      return false;
    }
    ADD_FAILURE() << "nothing is wrong";
    return false;
  };
  EXPECT_FALSE(is_callers_fault("# changeover design change=3\n0 1\n", {.v = 5}));
  EXPECT_FALSE(is_callers_fault("7\n", {.change = 1}));
}

TEST(TextTest, NumbersTooLargeForElementsAreLabelsInIncreasingOrder) {
  const std::string huge = "123456789012345678901234567890";
  const Design design = read("0 65535\n" + huge + "1 18446744073709551616\n" + huge + " 65535\n");
  EXPECT_EQ(design.labels(), (Labels{"0", "65535", "18446744073709551616", huge, huge + "1"}));
  EXPECT_EQ(written(read(written(design))), written(design));
}

TEST(TextTest, HugeLinesAreRefusedEarlyAndHugeBlanksSkipped) {
  const std::uint64_t bytes = 100'000'000;
  std::uint64_t taken = 0;
  const auto endless = [&](const std::string& unit) {
    taken = 0;
    return message_of(
        [&] { (void)open_text(std::make_unique<EndlessInput>(unit, bytes, &taken), {.v = 10}); });
  };
  EXPECT_EQ(endless("1"),
            "endless:1:1: a word of more than 255 bytes; elements are separated by "
            "blanks and blocks by line ends");
  EXPECT_LT(taken, 1'000'000U);
  EXPECT_EQ(endless("1 "), "endless:1:3: element '1' is twice in block 1; remove or correct one");
  EXPECT_LT(taken, 1'000'000U);
  EXPECT_EQ(endless(" "),
            "endless:1:100000001: no blocks; give one block per line, its elements "
            "separated by blanks");
  EXPECT_EQ(endless("#"),
            "endless:1:100000001: no blocks; give one block per line, its elements "
            "separated by blanks");
  EXPECT_EQ(endless(std::string(1, '\0')),
            "endless:1:1: control byte 0x00; give plain text in UTF-8");

  std::string line;
  for (int i = 0; i < 65'536; ++i) {
    line += "x" + std::to_string(i) + " ";
  }
  EXPECT_EQ(complaint(line + "\n"),
            "f:1:447636: element 'x65535' is one too many: at most 65535 can "
            "be read; use fewer");
}

TEST(TextTest, PiecesOfAnySizeGiveTheSameDesign) {
  const Design design = random_design(7);
  const std::string text = written(design);
  for (const std::size_t piece : {1U, 2U, 511U, 4096U}) {
    EXPECT_EQ(written(read_text(std::make_unique<PipeInput>(text, piece))), text);
  }
  const std::string foreign = "x y\ny z\n";  // no v: kept in memory, for it cannot be rewound
  const auto stream = open_text(std::make_unique<PipeInput>(foreign));
  EXPECT_EQ(stream->block_count(), 2U);
  EXPECT_TRUE(stream->rewind());
  const auto declared =
      open_text(std::make_unique<PipeInput>("# changeover design v=3\n0 1\n1 2\n"));
  EXPECT_EQ(declared->block_count(), std::nullopt);
  EXPECT_FALSE(declared->rewind());
  EXPECT_EQ(read_all(*declared).block_count(), 2U);
}

TEST(TextTest, WordsAreWholeAcrossTheEdgesOfTheBuffer) {
  // Blanks of every length before the edge at 256 KiB.
  for (std::size_t shift = 0; shift < 12; ++shift) {
    const std::string text = "# changeover design v=60000\n1 2" +
                             std::string((std::size_t{1} << 18) - 35 + shift, ' ') +
                             "12345 23456\n3 4 5 6\n";
    EXPECT_EQ(read(text).blocks(), (std::vector<Block>{{1, 2, 12345, 23456}, {3, 4, 5, 6}}));
  }
}

TEST(TextTest, AStreamCanBeReadTwice) {
  for (const std::string text : {"# changeover design v=9\n0 1\n2 3\n4 5\n", "a b\nc d\ne f\n"}) {
    const auto stream = open_text(input_from_text(text));
    const Design first = read_all(*stream);
    ASSERT_TRUE(stream->rewind());
    EXPECT_EQ(written(read_all(*stream)), written(first));
    EXPECT_EQ(stream->block_count(), 3U);
  }
}

TEST(TextTest, AStreamIsWrittenLikeTheDesign) {
  const BaseBlocks base{{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}};
  DevelopedSource source(base);
  StringSink sink;
  EXPECT_EQ(write_text(source, sink), 11U);
  source.rewind();
  EXPECT_EQ(sink.text(), written(read_all(source)));
}

TEST(TextTest, ElementsBeyondTheTableAreWrittenToo) {
  const BaseBlocks base{{.v = 4'000'000'007, .k = 2, .change = 2, .kind = Kind::circular},
                        {{0, 3'999'999'999}}};
  DevelopedSource source(base);
  class Three final : public BlockByBlock<Three> {
   public:
    explicit Three(BlockSource& inner) : inner_(inner) {}
    const Parameters& parameters() const override { return inner_.parameters(); }
    bool make(std::span<Element> block) { return left_-- > 0 && inner_.next(block); }

   private:
    BlockSource& inner_;
    int left_ = 3;
  } three(source);
  StringSink sink;
  write_text(three, sink);
  EXPECT_EQ(sink.text(),
            "# changeover design v=4000000007 k=2 change=2 kind=circular\n0 3999999999\n"
            "1 4000000000\n2 4000000001\n");
}

TEST(TextTest, AMillionBlocksPassThroughSmallPieces) {
  const BaseBlocks base{{.v = 50'001, .k = 4, .kind = Kind::circular},
                        {{0, 1, 2, 5}, {0, 1, 7, 9}, {0, 1, 11, 1000}}};
  DevelopedSource source(base);
  StringSink sink;
  EXPECT_EQ(write_text(source, sink), 150'003U);
  const auto stream = open_text(input_from_text(sink.text()));
  source.rewind();
  Block ours(4);
  Block theirs(4);
  while (source.next(ours)) {
    ASSERT_TRUE(stream->next(theirs));
    ASSERT_EQ(ours, theirs);
  }
  EXPECT_FALSE(stream->next(theirs));
}

RC_GTEST_PROP(TextProperty, WritingReadingAndWritingGivesTheSameBytes, (std::uint32_t seed)) {
  const Design design = random_design(seed);
  const std::string text = written(design);
  const Design again = read(text);
  RC_ASSERT(again.parameters() == design.parameters());
  RC_ASSERT(again.labels() == design.labels());
  RC_ASSERT(again.recipe == design.recipe);
  RC_ASSERT(again.blocks() == design.blocks());
  RC_ASSERT(written(again) == text);
}

RC_GTEST_PROP(TextProperty, MutatedFilesGiveADesignOrOneLine, (std::uint32_t seed)) {
  read_mutated_file(
      seed, [](const std::string& text) { return read(text); }, written);
}

}  // namespace
}  // namespace changeover::text_test
