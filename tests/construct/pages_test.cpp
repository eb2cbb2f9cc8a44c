// What pages of the documentation state of designs, held to what the program says today.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/verify/verdict.hpp"
#include "run_program.hpp"

namespace changeover::test::pages_test {
namespace {

const std::string top = CHANGEOVER_TEST_DATA "/../../";

std::vector<std::string> lines_of(const std::string& page) {
  std::istringstream text(slurp(top + page));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

// The numbers of all "(1,2,3)" of a text, blanks left out, with so many in each.
std::vector<std::vector<std::uint64_t>> tuples(const std::string& text, std::size_t size) {
  static const std::regex tuple(R"(\((\d+(?:, ?\d+)*)\))");
  std::vector<std::vector<std::uint64_t>> found;
  for (std::sregex_iterator at(text.begin(), text.end(), tuple), end; at != end; ++at) {
    std::vector<std::uint64_t> numbers;
    std::istringstream parts((*at)[1].str());
    for (std::string part; std::getline(parts, part, ',');) {
      numbers.push_back(std::stoull(part));
    }
    if (numbers.size() == size) {
      found.push_back(std::move(numbers));
    }
  }
  return found;
}

Parameters circular(std::uint64_t v, std::uint64_t k, std::uint64_t m) {
  return {.v = v, .k = k, .change = m, .kind = Kind::circular};
}

std::uint64_t best(const Parameters& p) {
  const auto offer = best_known(Registry::standard(), p);
  return offer ? offer->b : 0;
}

TEST(Pages, TheoremsNameDesignsThatAreMinimum) {
  std::size_t rows = 0;
  bool there = false;
  for (const std::string& line : lines_of("docs/theorems.md")) {
    there = there || line == "## Designs beyond the paper";
    if (!there || !line.starts_with("| (") || line.starts_with("| (v")) {
      continue;
    }
    const bool tight = line.find("| tight |") != std::string::npos;
    ASSERT_TRUE(tight || line.find("| economical |") != std::string::npos) << line;
    for (const auto& row : tuples(line.substr(0, line.find('|', 2)), 3)) {
      const Parameters p = circular(row[0], row[1], 2);
      EXPECT_EQ(best(p), row[2]) << name(p);
      EXPECT_EQ(lower_bound(p).blocks, row[2]) << name(p);
      EXPECT_EQ(tight, row[2] * newly_covered_at_most(p) == p.v * (p.v - 1) / 2) << name(p);
      ++rows;
    }
  }
  EXPECT_GT(rows, 15U);
  EXPECT_EQ(best(circular(8, 6, 2)), 3U);
}

// One tight design of docs/new_designs.md: base blocks, to be developed by adding 1 to the residues
// of each cycle.
Design developed(const Parameters& p, std::uint64_t n, const std::vector<Block>& base) {
  Design design(p);
  const auto fixed = static_cast<Element>(p.v % n == 0 ? p.v : p.v - 1);
  for (std::uint64_t shift = 0; shift < n; ++shift) {
    for (Block block : base) {
      for (Element& x : block) {
        x = x == fixed ? x : static_cast<Element>(x / n * n + (x % n + shift) % n);
      }
      design.append(block);
    }
  }
  return design;
}

TEST(Pages, NewDesignsAreTightAndTheBestThatIsKnown) {
  std::size_t tables = 0;
  std::size_t lists = 0;
  std::uint64_t m = 0;
  std::string item;  // a list item goes on over lines
  const auto look_at_item = [&] {
    static const std::regex head(R"(^- \((\d+),(\d+),(\d+)\), n = (\d+): )");
    std::smatch match;
    if (!std::regex_search(item, match, head)) {
      return;
    }
    const Parameters p = circular(std::stoull(match[1]), std::stoull(match[2]), m);
    static const std::regex set(R"(\{([\d,]+)\})");
    std::vector<Block> base;
    for (std::sregex_iterator at(item.begin(), item.end(), set), end; at != end; ++at) {
      Block block;
      std::istringstream parts((*at)[1].str());
      for (std::string part; std::getline(parts, part, ',');) {
        block.push_back(static_cast<Element>(std::stoul(part)));
      }
      base.push_back(block);
    }
    const Design design = developed(p, std::stoull(match[4]), base);
    EXPECT_EQ(design.block_count(), std::stoull(match[3])) << item;
    EXPECT_TRUE(verify(design).tight()) << item;
    ++lists;
  };
  for (const std::string& line : lines_of("docs/new_designs.md")) {
    if (line.starts_with("  ") && !item.empty()) {
      item += line;
      continue;
    }
    look_at_item();
    item = line.starts_with("- (") ? line : "";
    if (line.starts_with("## ")) {
      const std::size_t at = line.find("m = ");
      m = at == std::string::npos ? 0 : std::stoull(line.substr(at + 4));
    }
    if (line.starts_with("| (") && !line.starts_with("| (v") && m > 0) {
      const auto row = tuples(line.substr(0, line.find('|', 2)), 3).at(0);
      EXPECT_EQ(best(circular(row[0], row[1], m)), row[2]) << line;
      ++tables;
    }
  }
  look_at_item();
  EXPECT_GT(tables, 40U);
  EXPECT_EQ(lists, tables);
}

// What was not found then has not been found since, and a theorem excludes what the page says that
// it
// does.
TEST(Pages, WhatWasNotFoundIsStillOpenOrExcluded) {
  const std::string page = slurp(top + "docs/new_designs.md");
  const std::string rest = page.substr(page.find("## What was not found"));
  const auto open = tuples(rest, 3);
  EXPECT_GE(open.size(), 10U);
  for (const auto& row : open) {
    const Parameters p = circular(row[0], row[1], 2);
    EXPECT_EQ(row[2] * newly_covered_at_most(p), p.v * (p.v - 1) / 2) << name(p);
    EXPECT_GT(best(p), row[2]) << name(p) << " was found";
  }
  const std::size_t theorem = rest.find("*Excluded by a theorem.*");
  std::istringstream excluded(rest.substr(theorem, rest.find("*Excluded by the SAT") - theorem));
  std::size_t rows = 0;
  for (std::string line; std::getline(excluded, line);) {
    if (!line.starts_with("- m = ")) {
      continue;
    }
    const std::uint64_t m = std::stoull(line.substr(6));
    for (const auto& row : tuples(line, 2)) {
      const Parameters p = circular(row[0], row[1], m);
      const std::uint64_t pairs = p.v * (p.v - 1) / 2;
      EXPECT_EQ(pairs % newly_covered_at_most(p), 0U) << name(p);
      EXPECT_GT(lower_bound(p).blocks, pairs / newly_covered_at_most(p)) << name(p);
      ++rows;
    }
  }
  EXPECT_GE(rows, 16U);
}

TEST(Pages, ReadmeSaysHowManyCellsTheCatalogHas) {
  std::smatch match;
  const std::string page = slurp(top + "README.md");
  static const std::regex some(R"(of some (\d+),(\d+) cells come with the program)");
  ASSERT_TRUE(std::regex_search(page, match, some));
  const std::uint64_t said = std::stoull(match[1]) * 1000 + std::stoull(match[2]);
  EXPECT_EQ((standard_catalog().size().cells + 500) / 1000 * 1000, said);
}

// bench/README.md: | k | change | kind | cells | proved minimum | share | mean | worst |
TEST(Pages, BenchSaysHowGoodTheTablesAre) {
  static const std::regex row(
      R"(^\| (\d+)\.\.(\d+) \| (\d) \| (linear|circular) \| ([\d,]+) \| .*)");
  std::size_t rows = 0;
  for (const std::string& line : lines_of("bench/README.md")) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) {
      continue;
    }
    CellRange range{.k_from = std::stoull(match[1]),
                    .k_to = std::stoull(match[2]),
                    .change = std::stoull(match[3])};
    range.v_from = range.k_from == 3 ? 5 : 20;
    range.v_to = 160;
    std::uint64_t cells = 0;
    std::uint64_t minimum = 0;
    double sum = 0;
    double worst = 0;
    const BestKnownTable plan = best_known_table(Registry::standard(), range);
    for (const KnownCell& cell : plan.cells()) {
      if (to_string(cell.parameters.kind) == match[4].str() && cell.best) {
        const double ratio =
            static_cast<double>(cell.best->b) / static_cast<double>(cell.bound.blocks);
        ++cells;
        minimum += cell.status() == "minimum" ? 1U : 0U;
        sum += ratio;
        worst = std::max(worst, ratio);
      }
    }
    const auto grouped = [](std::uint64_t number) {
      const std::string digits = std::to_string(number);
      return digits.size() > 3
                 ? digits.substr(0, digits.size() - 3) + "," + digits.substr(digits.size() - 3)
                 : digits;
    };
    const auto count = static_cast<double>(cells);
    EXPECT_EQ(line,
              fmt::format("| {}..{} | {} | {} | {} | {} | {} % | {:.4f} | {:.3f} |", range.k_from,
                          range.k_to, range.change, match[4].str(), grouped(cells),
                          grouped(minimum), 100 * minimum / cells, sum / count, worst));
    ++rows;
  }
  EXPECT_EQ(rows, 12U);
}

}  // namespace
}  // namespace changeover::test::pages_test
