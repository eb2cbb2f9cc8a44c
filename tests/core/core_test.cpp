#include <gtest/gtest.h>

#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/core/parameters.hpp"
#include "core/checked.hpp"
#include "message_of.hpp"

namespace changeover::core_test {
namespace {

TEST(Binomial, EqualsPascalsTriangle) {
  std::vector<std::uint64_t> row{1};
  for (std::uint64_t n = 0; n <= 67; ++n) {
    for (std::uint64_t r = 0; r <= n; ++r) {
      EXPECT_EQ(binomial(n, r), row[r]);
    }
    EXPECT_EQ(binomial(n, n + 1), 0U);
    std::vector<std::uint64_t> next(row.size() + 1, 1);
    for (std::size_t i = 1; i < row.size(); ++i) {
      next[i] = row[i - 1] + row[i];
    }
    row = next;
  }
}

TEST(Binomial, RefusesToOverflow) {
  EXPECT_EQ(binomial(68, 30), 17876288714431443296ULL);
  EXPECT_THROW((void)binomial(68, 34), ImpossibleParameters);
  EXPECT_EQ(binomial(std::uint64_t{1} << 32, 2), ((std::uint64_t{1} << 32) - 1) << 31);
  EXPECT_THROW((void)checked_add(~std::uint64_t{0}, 1), ImpossibleParameters);
  EXPECT_THROW((void)checked_multiply(~std::uint64_t{0}, 2), ImpossibleParameters);
}

TEST(Parameters, NameTheNumberAtFault) {
  const auto message = [](const Parameters& p) -> std::string {
    return message_of<ImpossibleParameters>([&] { check(p); });
  };
  EXPECT_NE(message({.v = 3, .k = 4}).find("k = 4"), std::string::npos);
  EXPECT_NE(message({.v = 3, .k = 0}).find("k = 0"), std::string::npos);
  EXPECT_NE(message({.v = 5'000'000'000, .k = 3}).find("v = 5000000000"), std::string::npos);
  EXPECT_NE(message({.v = 5, .k = 3, .change = 4}).find("change = 4"), std::string::npos);
  EXPECT_NE(message({.v = 5, .k = 3, .change = 0}).find("change = 0"), std::string::npos);
  EXPECT_NE(message({.v = 9, .k = 6, .strength = 5}).find("strength = 5"), std::string::npos);
  EXPECT_NE(message({.v = 9, .k = 2, .strength = 3}).find("strength = 3"), std::string::npos);
  EXPECT_EQ(message({.v = 5, .k = 3}), "");
}

TEST(Parameters, SayWhyNoDesignCanExist) {
  EXPECT_TRUE(impossibility({.v = 4, .k = 2}).has_value());
  EXPECT_TRUE(impossibility({.v = 5, .k = 4}).has_value());
  EXPECT_FALSE(impossibility({.v = 5, .k = 4, .change = 1}).has_value());
  EXPECT_FALSE(impossibility({.v = 4, .k = 4}).has_value());
  EXPECT_FALSE(impossibility({.v = 61, .k = 4}).has_value());
}

TEST(Parameters, AreNamedAsInTheField) {
  EXPECT_EQ(name({.v = 61, .k = 4, .kind = Kind::circular}), "circular DCCD(61,4)");
  EXPECT_EQ(name({.v = 9, .k = 4, .change = 1}), "linear SCCD(9,4)");
  EXPECT_EQ(name({.v = 9, .k = 4, .change = 3}, false), "3-change covering design (9,4)");
  EXPECT_EQ(newly_covered_at_most({.v = 9, .k = 4, .change = 1}), 3U);
  EXPECT_EQ(newly_covered_at_most({.v = 9, .k = 4, .change = 2}), 5U);
  EXPECT_EQ(newly_covered_at_most({.v = 9, .k = 4, .change = 3}), 6U);
}

TEST(Design, RefusesMalformedBlocksAndStaysAsItWas) {
  Design design({.v = 6, .k = 3});
  design.append(Block{0, 1, 2});
  EXPECT_THROW(design.append(Block{0, 1}), BadInput);
  EXPECT_THROW(design.append(Block{3, 4, 6}), BadInput);
  EXPECT_THROW(design.append(Block{3, 4, 3}), BadInput);
  EXPECT_EQ(design.block_count(), 1U);
  design.append(Block{3, 4, 5});
  design.append(Block{3, 4, 0});
  EXPECT_EQ(design.block_count(), 3U);
  EXPECT_REFUSAL(Design({.v = 65'536, .k = 3}), ImpossibleParameters,
                 "v = 65536 exceeds the 65535 elements of a design in memory");
}

TEST(Design, KeepsLabelsThatEveryFormatCanCarry) {
  Design design({.v = 3, .k = 2, .change = 1});
  design.set_labels({"∞_s", "0_l", "a"});
  EXPECT_EQ(design.label(0), "∞_s");
  EXPECT_REFUSAL(design.set_labels({"a", "b"}), BadInput,
                 "2 labels for v = 3 elements: give one each");
  EXPECT_REFUSAL(design.set_labels({"a", "b", "a"}), BadInput, "the label 'a' names two elements");
  EXPECT_REFUSAL(design.set_labels({"a", "b c", "d"}), BadInput,
                 "the label 'b c': a name with a blank");
  EXPECT_REFUSAL(design.set_labels({"a", "b,c", "d"}), BadInput,
                 "the label 'b,c': a name with a comma");
  EXPECT_REFUSAL(design.set_labels({"a", "", "d"}), BadInput,
                 "the label '': an element has an empty name; name it");
  EXPECT_EQ(design.label(2), "a");
  design.set_labels({"0", "1", "2"});
  EXPECT_TRUE(design.labels().empty());
  EXPECT_EQ(design.label(2), "2");
}

TEST(DesignSource, CanBeReadTwice) {
  const Design design({.v = 4, .k = 2, .change = 1}, std::vector<Block>{{0, 1}, {1, 2}});
  DesignSource source(design);
  const Design first = read_all(source);
  EXPECT_TRUE(source.rewind());
  const Design second = read_all(source);
  EXPECT_TRUE(std::equal(first.elements().begin(), first.elements().end(),
                         second.elements().begin(), second.elements().end()));
  EXPECT_EQ(source.block_count(), 2U);
}

TEST(DevelopedSource, AddsEachElementOfZvInTurn) {
  DevelopedSource source({{.v = 5, .k = 2, .change = 1, .kind = Kind::circular}, {{0, 1}, {1, 3}}});
  const Design design = read_all(source);
  ASSERT_EQ(design.block_count(), 10U);
  EXPECT_EQ(Block(design.block(9).begin(), design.block(9).end()), (Block{0, 2}));
  EXPECT_THROW(DevelopedSource({{.v = 5, .k = 2}, {}}), BadInput);
  EXPECT_REFUSAL(DevelopedSource({{.v = 5, .k = 2}, {{0, 5}}}), BadInput,
                 "base block 1 does not have k = 2 elements below v = 5");
}

TEST(PairSet, HoldsWhatWasInserted) {
  for (const std::uint32_t v : {2U, 3U, 12U, 65U}) {
    PairSet set(v);
    std::uint64_t inserted = 0;
    for (Element x = 0; x < v; ++x) {
      for (Element y = x + 1; y < v; ++y) {
        if ((x * 7 + y * 13) % 3 == 0) {
          set.insert(y, x);
          ++inserted;
        }
      }
    }
    EXPECT_EQ(set.size(), inserted);
    EXPECT_EQ(set.missing(), binomial(v, 2) - inserted);
    std::uint64_t seen = 0;
    set.for_each_missing(~std::uint64_t{0}, [&](Element x, Element y) {
      EXPECT_LT(x, y);
      EXPECT_FALSE(set.contains(x, y));
      ++seen;
    });
    EXPECT_EQ(seen, set.missing());
    set.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
      EXPECT_EQ((x * 7 + y * 13) % 3, 0U);
      ++seen;
    });
    EXPECT_EQ(seen, binomial(v, 2));
  }
}

}  // namespace
}  // namespace changeover::core_test
