// What bench/README.md and docs/loadorder.md say of load orders is what the program gives today.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"
#include "run_program.hpp"

namespace changeover::test::pages_test {
namespace {

// The cells of a row of a Markdown table, without blanks around them.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line.substr(1));
  for (std::string cell; std::getline(rest, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    const std::size_t end = cell.find_last_not_of(' ');
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

TEST(Pages, BenchSaysHowManyLoadsThereAre) {
  std::istringstream page(slurp(CHANGEOVER_TEST_DATA "/../../bench/README.md"));
  std::size_t rows = 0;
  std::size_t minimum = 0;
  std::size_t near = 0;
  bool there = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| P | C | bound | ours |")) {
      there = true;
      std::getline(page, line);  // the rule below it
      continue;
    }
    if (!there || !line.starts_with("| ")) {
      there = false;
      continue;
    }
    const std::vector<std::string> row = cells_of(line);
    ASSERT_EQ(row.size(), 12U) << line;
    const LoadOrder order = plan_load_order(std::stoull(row[0]), std::stoull(row[1]));
    const LoadOrderFacts& facts = order.facts();
    EXPECT_EQ(row[2], std::to_string(facts.bound.loads)) << line;
    EXPECT_EQ(row[3], std::to_string(facts.loads)) << line;
    EXPECT_EQ(row[4], facts.gap() == 0 ? "0 %" : fmt::format("{:.2f} %", 100 * facts.gap()))
        << line;
    std::uint64_t peer = std::stoull(row[7]);
    for (std::size_t i = 8; i < 11; ++i) {
      peer = std::min<std::uint64_t>(peer, std::stoull(row[i]));
    }
    EXPECT_EQ(row[11],
              fmt::format("{:.3f}", static_cast<double>(peer) / static_cast<double>(facts.loads)))
        << line;
    ++rows;
    minimum += facts.gap() == 0 ? 1U : 0U;
    near += facts.gap() <= 0.03 ? 1U : 0U;
  }
  EXPECT_EQ(rows, 15U);
  EXPECT_EQ(minimum, 9U);  // "Nine are minimum."
  EXPECT_EQ(near, 14U);    // "within 3 % of the bound in 14"
}

// docs/loadorder.md: | P/C | C = 8 | 16 | 24 | 32 | 48 | 64 | bound | orders | over it | of 15
// within 2 % |
TEST(Pages, LoadorderSaysHowFarOrdersAreFromTheBound) {
  const std::string text = slurp(CHANGEOVER_TEST_DATA "/../../docs/loadorder.md");
  const std::vector<std::uint64_t> shown = {8, 16, 24, 32, 48, 64};
  std::size_t far = 0;
  std::size_t rows = 0;
  for (std::uint64_t quarters = 8; quarters <= 32; ++quarters) {
    std::string expected = fmt::format("| {:.2f} |", static_cast<double>(quarters) / 4);
    std::size_t near = 0;
    for (std::uint64_t room = 8; room <= 64; room += 4) {
      const LoadOrder order = plan_load_order(quarters * room / 4, room);
      const LoadOrderFacts& facts = order.facts();
      near += 100 * facts.loads <= 102 * facts.bound.loads ? 1U : 0U;
      if (std::find(shown.begin(), shown.end(), room) != shown.end()) {
        expected += fmt::format(" {:.1f} % |", 100 * facts.gap());
      }
    }
    far += 15 - near;
    const std::size_t at = text.find(expected.substr(0, expected.find('|', 2) + 1));
    if (at == std::string::npos) {
      EXPECT_EQ(near, 15U) << expected;  // "none of them with P < 4C"
      continue;
    }
    const std::string line = text.substr(at, text.find('\n', at) - at);
    EXPECT_EQ(line.substr(0, expected.size()), expected);
    EXPECT_TRUE(line.ends_with(fmt::format("| {} |", near))) << line << ": " << near;
    ++rows;
  }
  EXPECT_EQ(rows, 17U);
  const std::string all = fmt::format("375 cells in all, {} orders are more than 2 % above", far);
  EXPECT_NE(text.find(all), std::string::npos) << all;
  const std::string bench = slurp(CHANGEOVER_TEST_DATA "/../../bench/README.md");
  const std::string cells = fmt::format("{} of 375 cells are more than", far);
  EXPECT_NE(bench.find(cells), std::string::npos) << cells;
}

}  // namespace
}  // namespace changeover::test::pages_test
