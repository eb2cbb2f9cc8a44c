#include "changeover/io/formats.hpp"

#include "io/write/json_writer.hpp"
#include "random_designs.hpp"

namespace changeover::json_test {
namespace {

Design read(const std::string& text, const ReadOptions& options = {}) {
  return read_json(*input_from_text(text, "f"), options);
}

std::string written(const Design& design) {
  StringSink sink;
  write_json(design, sink);
  return sink.take();
}

std::string complaint(const std::string& text, const ReadOptions& options = {}) {
  return message_of([&] { (void)read(text, options); });
}

using Labels = std::vector<std::string>;

TEST(JsonWriterTest, ValuesComeWithTheirCommasAndColons) {
  JsonWriter json;
  json.begin_object().key("a").value(1).key("b").begin_array().value(true).null().value("x");
  json.begin_object().end_object().begin_array().end_array().end_array();
  json.key("c").value(std::vector<std::vector<int>>{{1, 2}, {}, {-3}});
  json.key("d").value(std::optional<int>()).key("e").value(std::optional<std::string>("y"));
  json.key("f").value(0.1).key("g").value(1.0 / 0.0).key("h").value(~std::uint64_t{0});
  json.key("i").raw("{}").key("j").value(std::string("s")).key("k").value('\x01' == 1).end_object();
  EXPECT_EQ(json.text(),
            R"({"a":1,"b":[true,null,"x",{},[]],"c":[[1,2],[],[-3]],"d":null,"e":"y","f":0.1,)"
            R"("g":null,"h":18446744073709551615,"i":{},"j":"s","k":true})");
}

TEST(JsonWriterTest, StringsAreEscapedAndMadeUtf8) {
  JsonWriter json;
  json.value("\"\\\n\t\x01\x7f∞\xff\xc3");
  EXPECT_EQ(json.take(), "\"\\\"\\\\\\n\\t\\u0001\\u007f∞\uFFFD\uFFFD\"");
  EXPECT_EQ(json.text(), "");
  json.value("\xed\xa0\x80 \xf4\x90\x80\x80 \xc0\x80");  // surrogate, too large, overlong
  EXPECT_EQ(json.text().find('\xed'), std::string::npos);
}

TEST(JsonTest, NumbersTooLargeForElementsAreLabels) {
  const Design design =
      read("{\"blocks\":[[0,65535],[0,123456789012345678901234567890],[18446744073709551615,0]]}");
  EXPECT_EQ(design.labels(), (std::vector<std::string>{"0", "65535", "18446744073709551615",
                                                       "123456789012345678901234567890"}));
  EXPECT_EQ(written(read(written(design))), written(design));
}

TEST(JsonTest, StringsHoldNothingThatATerminalObeys) {
  std::string json;
  append_json_string(json, "\x1b[m\u009b\u202e\u2028\x7f∞\xff");
  EXPECT_EQ(json, "\"\\u001b[m\\u009b\\u202e\\u2028\\u007f∞\uFFFD\"");
}

TEST(JsonTest, TheExampleIsReadAndWrittenBack) {
  const std::string text =
      "{\"format\":\"changeover-design/1\",\"v\":6,\"k\":4,\"change\":2,\"kind\":\"circular\","
      "\"blocks\":[\n[0,1,2,3],\n[4,5,2,3],\n[4,5,0,1]\n]}\n";
  EXPECT_EQ(written(read(text)), text);
}

TEST(JsonTest, LabelsRecipeAndVerdictFollowTheBlocks) {
  Design design(Parameters{.v = 3, .k = 2, .change = 1}, std::vector<Block>{{0, 1}, {1, 2}});
  design.set_labels({"a", "∞_s", "c"});
  design.recipe = Recipe{"r", {.v = 3, .k = 2, .change = 1}, {{"c", 1}}, {}, {{0, 1}}};
  StringSink sink;
  write_json(design, sink, DesignVerdict{.valid = true, .b = 2, .lower_bound = 3});
  EXPECT_EQ(sink.text(),
            "{\"format\":\"changeover-design/1\",\"v\":3,\"k\":2,\"change\":1,\"kind\":\"linear\","
            "\"blocks\":[\n[0,1],\n[1,2]\n],\"labels\":[\"a\",\"∞_s\",\"c\"],\"recipe\":"
            "{\"construction\":\"r\",\"v\":3,\"k\":2,\"change\":1,\"kind\":\"linear\","
            "\"arguments\":{\"c\":1},\"inputs\":[],\"blocks\":[[0,1]]},\"verdict\":{\"valid\":true,"
            "\"tight\":false,\"economical\":false,\"b\":2,\"lower_bound\":3,"
            "\"minimum\":\"unknown\"}}\n");
  const Design again = read(sink.text());
  EXPECT_EQ(again.recipe, design.recipe);
  EXPECT_EQ(again.labels(), design.labels());
}

TEST(JsonTest, ForeignFilesAreTaken) {
  EXPECT_EQ(read("[[0,1],[1,2]]").v(), 3U);
  EXPECT_EQ(read("\xEF\xBB\xBF {\"blocks\" : [ [\"b\",\"a\"], [\"a\",\"c\"] ], \"more\":"
                 "{\"x\":[[{}]]}, \"v\":null}")
                .labels(),
            (Labels{"b", "a", "c"}));
  EXPECT_EQ(read("[[5,9],[9,11]]").labels(), (Labels{"5", "9", "11"}));
}

TEST(JsonTest, NumbersAreElementsAndStringsAreLabelsWhenLabelsAreListed) {
  const Design design = read("{\"labels\":[\"3\",\"x\",\"1\"],\"blocks\":[[0,\"1\"],[\"x\",2]]}");
  EXPECT_EQ(design.block(0)[1], 2U);
  EXPECT_EQ(design.block(1)[0], 1U);
}

struct Case {
  std::string text;
  std::string message;
};

TEST(JsonTest, EachFaultHasItsLineColumnAndRemedy) {
  const std::vector<Case> cases = {
      {"{}", "f:1:2: no key \"blocks\"; add it, or name another file"},
      {"{\"blocks\":[]}", "f:1:1: no blocks; give at least one"},
      {"3", "f:1:1: expected an object with the key \"blocks\", found a number; correct it"},
      {"{\"blocks\":[\n[0,1],\n[]\n]}", "f:3:2: block 2 is empty; remove it"},
      {"{\"blocks\":[\n[0,1,2],\n[0,1]\n]}",
       "f:3:5: block 2 has 2 elements, the blocks before have 3; correct one of them"},
      {"{\"blocks\":[\n[0,1],\n[0,2,3]\n]}",
       "f:3:6: block 2 has more than the 2 elements of the blocks before; correct one of them"},
      {"{\"k\":3,\"blocks\":[\n[0,1]\n]}",
       "f:2:2: block 1 has 2 elements, not k = 3; correct it, or k"},
      {"{\"blocks\":[\n[0,1],\n[2, 2]\n]}",
       "f:3:5: element '2' is twice in block 2; remove or correct one"},
      {"{\"blocks\":[\n[0,1],\n[2, 7]\n],\"v\":3}",
       "f:3:5: element '7' is not below v = 3; count from 0, or leave v out"},
      {"{\"blocks\":[[0,-1]]}", "f:1:15: element '-1' is not a whole number; write 0 or more"},
      {"{\"blocks\":[[0,1.5]]}", "f:1:15: element '1.5' is not a whole number; write 0 or more"},
      {"{\"blocks\":[[0,1e3]]}", "f:1:15: element '1e3' is not a whole number; write 0 or more"},
      {"{\"blocks\":[[0,true]]}",
       "f:1:15: expected an element, a number or a label in quotes, found true or false; correct it"},
      {"{\"blocks\":[[0,[1]]]}",
       "f:1:15: expected an element, a number or a label in quotes, found an array; correct it"},
      {"{\"blocks\":[0]}",
       "f:1:12: expected an array of elements, a block, found a number; correct it"},
      {"{\"blocks\":{}}", "f:1:11: expected an array for blocks, found an object; correct it"},
      {"{\"v\":\"6\"}", "f:1:6: expected a number for v, found a string; correct it"},
      {"{\"v\":-6}", "f:1:6: v='-6': bad value; give a whole number from 1 to 65535"},
      {"{\"v\":6.5}", "f:1:6: v='6.5': bad value; give a whole number from 1 to 65535"},
      {"{\"v\":65536}", "f:1:6: v='65536': bad value; give a whole number from 1 to 65535"},
      {"{\"v\":6,\n \"v\":7}", "f:2:6: v is given twice; give it once"},
      {"{\"kind\":\"round\"}", "f:1:9: kind='round': bad value; give linear or circular"},
      {"{\"kind\":1}",
       "f:1:9: expected \"linear\" or \"circular\" for kind, found a number; correct it"},
      {"{\"format\":\"changeover-design/2\"}",
       "f:1:11: format is not \"changeover-design/1\"; this is another kind of file, or of a "
       "later version"},
      {"{\"blocks\":[[0,1]],\"blocks\":[[0,1]]}", "f:1:19: blocks is given twice; give it once"},
      {"{\"labels\":[\"a\",\"a\"]}", "f:1:16: label 'a' is listed twice; remove or correct one"},
      {"{\"labels\":[\"a b\"]}",
       "f:1:12: a name with a blank or control character; use '_' or '-' instead"},
      {"{\"labels\":[\"\"]}", "f:1:12: an element has an empty name; name it"},
      {"{\"labels\":[[]]}", "f:1:12: expected a label in quotes, found an array; correct it"},
      {"{\"v\":3,\"labels\":[\"a\"],\"blocks\":[[0,1]]}",
       "f:1:17: 1 label for v = 3 elements; give one each"},
      {"{\"labels\":[\"a\",\"b\"],\"blocks\":[[\"a\",\"c\"]]}",
       "f:1:36: element 'c' is not in the list of labels; correct one of them"},
      {"{\"v\":2,\"blocks\":[[\"a\",\"b\"],\n[\"a\",\"c\"]]}",
       "f:2:6: element 'c' is one too many for v = 2; correct it, or v"},
      {"{\"change\":3,\"blocks\":[[0,1]]}",
       "f:1:1: change = 3: consecutive blocks must differ in 1 to k = 2 elements"},
      {"{\"recipe\":3}", "f:1:11: expected an object for recipe, found a number; correct it"},
      {"{\"recipe\":{\n}}", "f:2:1: the recipe lacks construction; add it"},
      {"[[0,1]] x",
       "f:1:9: not JSON: invalid literal; correct "
       "it"},
  };
  for (const Case& c : cases) {
    EXPECT_EQ(complaint(c.text), c.message) << c.text;
  }
}

TEST(JsonTest, WhatIsNoJsonIsSaidOnOneLineWithItsPlace) {
  for (const std::string text :
       {"{", "{\"blocks\":[[0,1],\n[2,]]}", "{\"a\":\"\xff\"}", "[[0 1]]", "{\"a\":\"\n\"}",
        "[[01]]", "{\"blocks\":[[0,1]", "nul", "\"\\u12\"", "{,}"}) {
    const std::string message = complaint(text);
    EXPECT_TRUE(message.starts_with("f:")) << text << message;
    EXPECT_NE(message.find("not JSON"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_TRUE(complaint("{\"blocks\":[[0,1],\n[2,]]}").starts_with("f:2:4: "));
  EXPECT_EQ(complaint(""), "f:1:1: the input is empty; give a JSON object");
}

TEST(JsonTest, DeepNestingIsRefusedWithoutStack) {
  EXPECT_EQ(
      complaint(std::string(10'000'000, '[')),
      "f:1:3: expected an element, a number or a label in quotes, found an array; correct it");
  EXPECT_EQ(complaint("{\"x\":" + std::string(10'000'000, '[')),
            "f:1:261: JSON nested more than 256 deep; use fewer levels");
  std::string recipe = "{\"recipe\":";
  for (int i = 0; i < 1'000'000; ++i) {
    recipe += "{\"inputs\":[";
  }
  EXPECT_NE(complaint(recipe).find("nested more than 256 deep"), std::string::npos);
}

TEST(JsonTest, PlacesAreRightBehindStringsWithQuotesAndBrackets) {
  EXPECT_EQ(complaint("{\"x\":\"a\\\"],[\\\\\",\"y\\\"\":[\",\"],\n\"v\":0}"),
            "f:2:5: v='0': bad value; give a whole number from 1 to 65535");
  EXPECT_EQ(complaint("{\"blocks\":[[\"a\\u0022\"]]}"),
            "f:1:13: a name with a double quote, which not every format can carry; use another "
            "character");
}

TEST(JsonTest, RecipesAreReadBackAndTheirFaultsPlaced) {
  EXPECT_EQ(message_of([] { (void)recipe_from_json("{\"construction\":\"x\",\n\"v\":-1}"); }),
            "<recipe>:2:5: expected a number up to 4294967295 for v, found a number; correct it");
  EXPECT_EQ(message_of([] { (void)recipe_from_json("{\"arguments\":{\"c\":1.5}}", "g"); }),
            "g:1:19: argument 'c' = '1.5' is not a whole number of 64 bits; correct the recipe");
  EXPECT_EQ(message_of([] { (void)recipe_from_json("{\"input\":[]}", "g"); }),
            "g:1:2: unknown key 'input' in the recipe; remove it, or use a newer program");
  EXPECT_EQ(message_of([] { (void)recipe_from_json("{\"inputs\":[{\"x\":[{}]}]}", "g"); }),
            "g:1:13: unknown key 'x' in the recipe; remove it, or use a newer program");
  EXPECT_NE(message_of([] { (void)recipe_from_json("[]"); }), "");
  EXPECT_NE(message_of([] { (void)recipe_from_json(""); }), "");
  const Recipe minimal =
      recipe_from_json("{\"construction\":\"x\",\"v\":1,\"k\":1,\"change\":1,\"kind\":\"linear\"}");
  EXPECT_TRUE(minimal.inputs.empty() && minimal.arguments.empty());
}

TEST(JsonTest, TheFullVerdictSaysEverything) {
  Verdict verdict;
  verdict.parameters = {.v = 3, .k = 2, .change = 1, .kind = Kind::circular};
  verdict.b = 2;
  verdict.bad_steps = 1;
  verdict.bad_step_examples = {{.from = 2, .to = 1, .changes = 2}};
  verdict.subsets = 3;
  verdict.uncovered = 1;
  verdict.uncovered_examples = {{0, 2}};
  verdict.fixed = {1};
  verdict.elements = {{.introductions = 1, .blocks = 2, .covered = 3, .excess = 4}};
  const std::string json = verdict_to_json(verdict, {"a", "b", "c"});
  EXPECT_TRUE(json.starts_with(
      "{\"v\":3,\"k\":2,\"change\":1,\"kind\":\"circular\",\"strength\":2,\"valid\":false,"
      "\"tight\":false,\"economical\":false,\"b\":2,\"counting_bound\":0,\"bad_steps\":1,"
      "\"bad_step_examples\":[{\"from\":2,\"to\":1,\"changes\":2}],\"subsets\":3,\"uncovered\":1,"
      "\"uncovered_examples\":[[\"a\",\"c\"]],\"covered\":0,\"never_newly_covered\":0,\"excess\":0,"
      "\"fixed\":[\"b\"],\"degree_identity\":false,\"unchanged_subsets\":"))
      << json;
  EXPECT_TRUE(
      json.ends_with("\"elements\":[{\"element\":\"a\",\"introductions\":1,\"blocks\":2,"
                     "\"covered\":3,\"excess\":4}]}"))
      << json;
  verdict.parameters.strength = 3;
  EXPECT_NE(verdict_to_json(verdict).find("\"degree_identity\":null"), std::string::npos);
  EXPECT_NE(verdict_to_json(verdict).find("[[0,2]]"), std::string::npos);
}

RC_GTEST_PROP(JsonProperty, WritingReadingAndWritingGivesTheSameBytes, (std::uint32_t seed)) {
  const Design design = random_design(seed);
  const std::string text = written(design);
  const Design again = read(text);
  RC_ASSERT(again.parameters() == design.parameters());
  RC_ASSERT(again.labels() == design.labels());
  RC_ASSERT(again.recipe == design.recipe);
  RC_ASSERT(written(again) == text);
}

RC_GTEST_PROP(JsonProperty, MutatedFilesGiveADesignOrOneLine, (std::uint32_t seed)) {
  read_mutated_file(
      seed, [](const std::string& text) { return read(text); }, written);
}

}  // namespace
}  // namespace changeover::json_test
