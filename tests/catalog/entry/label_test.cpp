#include "changeover/catalog/entry.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "../entries.hpp"

namespace changeover::test::label_test {
namespace {

TEST(Label, IsReadAsItIsWritten) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    Parameters p{.v = 2 + random() % 1000,
                 .k = 2,
                 .kind = random() % 2 == 0 ? Kind::linear : Kind::circular};
    p.k = 2 + random() % (p.v - 1);
    p.change = 1 + random() % p.k;
    p.strength = static_cast<std::uint32_t>(2 + random() % (std::min<std::uint64_t>(p.k, 4) - 1));
    Checksum checksum = {};
    for (auto& byte : checksum) {
      byte = static_cast<std::remove_reference_t<decltype(byte)>>(random());
    }
    const std::uint64_t b = 1 + random() % 100000;
    ASSERT_EQ(parse_cell_label(cell_label(p)), p) << cell_label(p);
    const std::string text = design_label(p, b, checksum);
    const auto label = parse_design_label(text);
    ASSERT_TRUE(label) << text;
    EXPECT_EQ(*label, (DesignLabel{p, b, to_hex(checksum).substr(0, label_digits)}));
    EXPECT_FALSE(parse_cell_label(text)) << text;
    EXPECT_FALSE(parse_design_label(cell_label(p))) << text;
  }
}

TEST(Label, IsNothingElse) {
  for (const char* const text : {"",
                                 ".",
                                 "....",
                                 "20",
                                 "20.5.2",
                                 "20.5.2.",
                                 "20.5.2.Linear",
                                 "20.5.2.line",
                                 "20.5.2.linear.",
                                 "+20.5.2.linear",
                                 "020.5.2.linear",
                                 " 20.5.2.linear",
                                 "20.5.2.linear ",
                                 "20.5.2.linear.t2",
                                 "20.5.2.linear.t03",
                                 "20.5.2.linear.t5",
                                 "20.5.2.linear.t",
                                 "20.5.2.linear.3",
                                 "0.5.2.linear",
                                 "4.5.2.linear",
                                 "20.5.0.linear",
                                 "20.5.6.linear",
                                 "20.2.1.linear.t3",
                                 "20,5,2,linear",
                                 "4294967296.5.2.linear",
                                 "-1.5.2.linear",
                                 "20.5.2.linear\n",
                                 "1e3.5.2.linear"}) {
    EXPECT_FALSE(parse_cell_label(text)) << text;
  }
  EXPECT_FALSE(parse_cell_label("99999999999999999999.5.2.linear"));
  EXPECT_TRUE(parse_cell_label("20.5.2.linear"));
  for (const char* const text :
       {"20.5.2.linear.39", "20.5.2.linear.39.", "20.5.2.linear.39.3fa9c1d",
        "20.5.2.linear.39.3fa9c1d20", "20.5.2.linear.39.3FA9C1D2", "20.5.2.linear.0.3fa9c1d2",
        "20.5.2.linear.039.3fa9c1d2", "20.5.2.linear.-1.3fa9c1d2", "20.5.2.linear.39.3fa9c1d2.",
        "20.5.2.linear.39.3fa9c1dg", "20.5.2.linear.t2.39.3fa9c1d2", "x20.5.2.linear.39.3fa9c1d2",
        "20.5.2.linear.18446744073709551616.3fa9c1d2"}) {
    EXPECT_FALSE(parse_design_label(text)) << text;
  }
  EXPECT_TRUE(parse_design_label("20.5.2.linear.39.3fa9c1d2"));
  EXPECT_TRUE(parse_design_label("20.5.2.linear.t3.39.3fa9c1d2"));
}

// What no alias may be: whatever is the beginning of a label, or looks like it.
TEST(Label, ReadsAsOne) {
  for (const std::string label : {"20.5.2.linear.39.3fa9c1d2", "6.4.1.circular.t3.12.00000000"}) {
    for (std::size_t length = 1; length <= label.size(); ++length) {
      EXPECT_TRUE(reads_as_label(label.substr(0, length))) << label.substr(0, length);
    }
  }
  for (const char* const text :
       {"20.5.2.LINEAR.29", " 20.5.2.linear.29", "20 .5.2.linear", "020.5.2.linear.29",
        "3.5.2.linear", "20.5.2.linear.29.3FA9C1D2", "20.5.2.linear.x", "20 5"}) {
    EXPECT_TRUE(reads_as_label(text)) << text;
  }
  for (const char* const text :
       {"", " ", ".", "nice", "example-7", "20.5.2.line.29", "20..2", "x20", "20.5.2.linearly",
        "20-5-2", "linear", "20.5.2-old", "v20.5.2"}) {
    EXPECT_FALSE(reads_as_label(text)) << text;
  }
}

// The digest is that of the text without comments.
TEST(Label, DigestIsThatOfTheText) {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const CatalogEntry entry = random_entry(random);
    std::string text;
    for (const Block& block : entry.recipe.blocks) {
      text += fmt::format("{}\n", fmt::join(block, " "));
    }
    Sha256 hash;
    hash.add(text);
    EXPECT_EQ(entry.checksum, hash.finish());
    EXPECT_EQ(entry.b, entry.recipe.blocks.size());
  }
}

}  // namespace
}  // namespace changeover::test::label_test
