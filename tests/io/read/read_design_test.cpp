#include "changeover/io/input.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "changeover/io/formats.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/printable.hpp"
#include "random_designs.hpp"

namespace changeover::read_design_test {
namespace {

const std::string data = std::string(CHANGEOVER_TEST_DATA) + "/io/";

Design read(const std::string& text) { return read_design(input_from_text(text, "f")); }

TEST(ReadDesignTest, TheBeginningTellsTheFormat) {
  EXPECT_EQ(guess_format(""), Format::text);
  EXPECT_EQ(guess_format("\n 0 1 2"), Format::text);
  EXPECT_EQ(guess_format("\xEF\xBB\xBF\n{"), Format::json);
  EXPECT_EQ(guess_format(" [[0,1]]"), Format::json);
  EXPECT_EQ(guess_format("0,1,2"), Format::csv);
  EXPECT_EQ(guess_format("a;b"), Format::csv);
  EXPECT_EQ(guess_format("# a comment, with a comma\n0 1"), Format::text);
  EXPECT_EQ(guess_format("0 1 # a comment, with a comma\n"), Format::text);
  EXPECT_EQ(guess_format("# a comment\n\n0,1"), Format::csv);
  EXPECT_EQ(guess_format("# changeover design v=3\na;b c\n"), Format::text);
  EXPECT_EQ(guess_format("B0,0 B1,0\n0 1*\n"), Format::text);
}

TEST(ReadDesignTest, TheSameDesignComesOutOfEveryFormat) {
  const Design text = read_design(data + "dccd_6_4_3.txt");
  const Design json = read_design(data + "dccd_6_4_3.json");
  const Design csv = read_design(data + "dccd_6_4_3.csv");
  for (const Design* design : {&text, &json, &csv}) {
    EXPECT_EQ(design->parameters(), text.parameters());
    EXPECT_TRUE(std::equal(design->elements().begin(), design->elements().end(),
                           text.elements().begin(), text.elements().end()));
    EXPECT_TRUE(verify(*design).tight());
  }
}

TEST(ReadDesignTest, ATableOfThePaperIsReadWithItsNames) {
  const Design design = read_design(data + "dccd_10_4_9_named.txt");
  EXPECT_EQ(design.v(), 10U);
  EXPECT_EQ(design.labels()[4], "a");
  EXPECT_TRUE(verify(design).tight());
}

TEST(ReadDesignTest, StreamsGiveWhatReadersGive) {
  for (const std::string file :
       {"dccd_6_4_3.txt", "dccd_6_4_3.json", "dccd_6_4_3.csv", "dccd_10_4_9_named.txt"}) {
    const Design design = read_design(data + file);
    const auto stream = open_design(data + file);
    EXPECT_EQ(stream->block_count().value_or(design.block_count()), design.block_count());
    EXPECT_EQ(verify(*stream), verify(design));
    ASSERT_TRUE(stream->rewind());
    const Design again = read_all(*stream);
    EXPECT_EQ(again.labels(), design.labels());
    EXPECT_EQ(again.recipe, design.recipe);
  }
}

TEST(ReadDesignTest, WhatCannotBeReadGetsOneLine) {
  const auto refusal = [](const std::string& path) {
    return message_of<MissingResource>([&] { (void)read_design(path); });
  };
  EXPECT_EQ(refusal("/absent/file"),
            "/absent/file: cannot read: No such file or directory; check "
            "how the path is spelt");
  EXPECT_EQ(refusal("/"), "/: cannot read: Is a directory; name a file in it");
  EXPECT_EQ(refusal(""), "'': cannot read: No such file or directory; check how the path is spelt");
}

TEST(ReadDesignTest, AControlCharacterInANameIsRefusedInEveryFormat) {
  const auto refused = [](const std::string& text) {
    const std::string line = message_of([&] { (void)read(text); });
    EXPECT_TRUE(is_printable(line)) << line;
    return line.starts_with("f:");
  };
  for (const std::string bad : {"a\x1b[m", "\u009b", "\x7f", "\u202e", "\u2028", "\xff", "M\xfc"}) {
    EXPECT_TRUE(refused(bad + " b\nc d\n")) << printable(bad);
    EXPECT_TRUE(refused("# labels: " + bad + " b\n" + bad + " b\n")) << printable(bad);
    EXPECT_TRUE(refused(bad + ",b\nc,d\n")) << printable(bad);
    EXPECT_TRUE(refused("{\"blocks\":[[\"" + bad + "\",\"b\"]]}")) << printable(bad);
  }
  EXPECT_TRUE(refused(R"({"blocks":[["\u001b","b"]]})"));
  EXPECT_TRUE(refused(R"({"labels":["\u009b","b"],"blocks":[[0,1]]})"));
}

// Bytes for ever, as a device gives them.
class EndlessBytes final : public Input {
 public:
  explicit EndlessBytes(std::string unit) : Input("endless"), unit_(std::move(unit)) {}
  std::size_t read(std::span<char> buffer) override {
    for (char& c : buffer) {
      c = unit_[at_++ % unit_.size()];
    }
    return buffer.size();
  }

 private:
  std::string unit_;
  std::size_t at_ = 0;
};

TEST(ReadDesignTest, ADeviceThatNeverEndsIsRefusedAtItsFirstBytes) {
  EXPECT_EQ(message_of([] { (void)read_design("/dev/zero"); }),
            "/dev/zero:1:1: control byte 0x00; give plain text in UTF-8");
  for (const std::string& unit :
       {std::string("{\0", 2), std::string("a,b\x01"), std::string("\x7f")}) {
    EXPECT_NE(message_of([&] {
                (void)read_design(std::make_unique<EndlessBytes>(unit));
              }).find("control byte"),
              std::string::npos);
  }
}

TEST(ReadDesignTest, LinksInACircleAreMissing) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("loop_" + std::to_string(getpid()))).string();
  std::filesystem::create_symlink(path, path);
  EXPECT_NE(message_of<MissingResource>([&] { (void)read_design(path); }).find("symbolic link"),
            std::string::npos);
  std::filesystem::remove(path);
}

TEST(ReadDesignTest, StandardInputIsAFileLikeOthers) {
  const int saved = dup(STDIN_FILENO);
  ASSERT_NE(freopen((data + "dccd_6_4_3.json").c_str(), "r", stdin), nullptr);
  EXPECT_EQ(read_design("-").v(), 6U);
  dup2(saved, STDIN_FILENO);
  close(saved);
}

TEST(ReadDesignTest, MoreThanFitsIsRefused) {
  EXPECT_NE(message_of<MissingResource>(
                [] { (void)read_to_end(*input_from_text(std::string(1 << 20, 'x'), "f"), 1000); }),
            "");
}

RC_GTEST_PROP(ReadDesignProperty, AnyBytesGiveADesignOrOneLine, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  const std::string likely = " \n0123456789ab,;{}[]\":#v=k";
  const bool any = random() % 3 == 0;
  std::string text;
  for (auto size = random() % 200; size > 0; --size) {
    text += any ? static_cast<char>(random()) : likely[random() % likely.size()];
  }
  try {
    const Design design = read(text);
    RC_ASSERT(design.block_count() > 0);
  } catch (const BadInput& fault) {
    const std::string line = fault.what();
    RC_ASSERT(line.starts_with("f:"));
    RC_ASSERT(line.find('\n') == std::string::npos);
  }
}

RC_GTEST_PROP(ReadDesignProperty, WritersAreRecognised, (std::uint32_t seed)) {
  const Design design = random_design(seed);
  const auto check = [&](auto writer) {
    StringSink first;
    writer(design, first);
    StringSink second;
    writer(read(first.text()), second);
    RC_ASSERT(first.text() == second.text());
  };
  check([](const Design& d, Sink& sink) { write_text(d, sink); });
  check([](const Design& d, Sink& sink) { write_json(d, sink); });
  check([](const Design& d, Sink& sink) { write_csv(d, sink); });
}

}  // namespace
}  // namespace changeover::read_design_test
