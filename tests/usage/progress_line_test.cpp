#include "answer/progress_line.hpp"

#include <gtest/gtest.h>

#include "cli/spelling.hpp"

namespace changeover::cli::progress_line_test {
namespace {

Progress busy() {
  return {.phase = "annealing 12 base blocks under an automorphism of order 7 on 84 elements",
          .steps = 123'456'789,
          .unit = "moves",
          .best = 321,
          .lower_bound = 300,
          .missing = 17,
          .elapsed = std::chrono::seconds(75),
          .left = std::chrono::seconds(3600)};
}

TEST(ProgressLine, SaysEverythingWhereThereIsRoom) {
  EXPECT_EQ(progress_line(busy(), 200),
            "annealing 12 base blocks under an automorphism of order 7 on 84 elements; 123 M moves "
            "(1646 k/s); 17 missing; best 321; bound 300; 1:15 min, 1:00 h left");
}

TEST(ProgressLine, KeepsTheBestAndTheTimeLeftLongest) {
  for (std::size_t width = 45; width <= 160; ++width) {
    const std::string line = progress_line(busy(), width);
    EXPECT_LE(line.size(), width);
    EXPECT_NE(line.find("best 321"), std::string::npos) << line;
    EXPECT_NE(line.find("left"), std::string::npos) << line;
  }
  for (std::size_t width = 0; width < 45; ++width) {
    EXPECT_LE(progress_line(busy(), width).size(), width);
  }
}

TEST(ProgressLine, WritesTimesThatNoClockHas) {
  EXPECT_EQ(clock_time(std::chrono::duration<double>(1e300)), "277777:46 h");
  EXPECT_EQ(clock_time(std::chrono::duration<double>(-5)), "0 s");
}

TEST(Spelling, FindsTheNearestWordOrNone) {
  EXPECT_EQ(did_you_mean("desing", {"verify", "design"}), ", did you mean design?");
  EXPECT_EQ(did_you_mean("loadorer", {"verify", "loadorder"}), ", did you mean loadorder?");
  EXPECT_EQ(did_you_mean("class", {"verify", "classify"}), ", did you mean classify?");
  EXPECT_EQ(did_you_mean("nonsense", {"verify", "classify"}), "");
  EXPECT_EQ(did_you_mean("", {"verify"}), "");
}

}  // namespace
}  // namespace changeover::cli::progress_line_test
