// All verbs say the same of a cell, whether it comes planned or lies just outside, and whether the
// user has a better design there.
#include <gtest/gtest.h>

#include <random>

#include "cases.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/registry.hpp"

namespace changeover::test::agreement_test {
namespace {

std::string after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  if (at == std::string::npos) {
    return "nothing";
  }
  const std::size_t begin = at + words.size();
  return text.substr(begin, text.find_first_not_of("0123456789", begin) - begin);
}

// The number in front of the first "blocks".
std::string of_blocks(const std::string& text) {
  const std::size_t end = text.find(" blocks");
  if (end == std::string::npos) {
    return "nothing";
  }
  const std::size_t begin = text.find_last_not_of("0123456789", end - 1) + 1;
  return text.substr(begin, end - begin);
}

// The number of blocks of the best design, as each verb says it.
std::vector<std::string> numbers(const Parameters& p, const TemporaryFolder& folder,
                                 const std::string& catalog) {
  const std::string environment = "CHANGEOVER_CATALOG=" + catalog + " $changeover ";
  const std::string kind = p.kind == Kind::linear ? " --linear" : " --circular";
  const std::string change = " --change " + std::to_string(p.change);
  const std::string strength = p.strength == 2 ? "" : " --strength " + std::to_string(p.strength);
  const std::string v = std::to_string(p.v);
  const std::string k = std::to_string(p.k);
  const std::string cell = v + " " + k + change + kind + strength;
  std::vector<std::string> said;
  const auto ask = [&](const std::string& command) {
    return run(environment + command, folder.path()).out;
  };
  if (p.strength == 2) {
    said.push_back(after(ask("table --v " + v + " --k " + k + change + kind + " --format csv"),
                         "\n" + v + "," + k + "," + std::to_string(p.change) + "," +
                             std::string(to_string(p.kind)) + ","));
  }
  said.push_back(after(ask("bounds " + cell + " --json"), "\"best_known\":"));
  said.push_back(
      std::to_string(count(ask("design " + cell + " --format text | grep -v '^#'"), "\n")));
  said.push_back(of_blocks(ask("explain " + cell)));
  // The catalog has those that come planned, and what was added.
  const std::string shown = ask("catalog show " + cell_label(p));
  if (shown.starts_with(cell_label(p) + ".")) {
    said.push_back(of_blocks(shown));
  } else {
    EXPECT_FALSE(is_stored_cell(p)) << shown;
  }
  return said;
}

void expect_agreement(const Parameters& p, const TemporaryFolder& folder,
                      const std::string& catalog = "") {
  const std::vector<std::string> said = numbers(p, folder, catalog);
  for (const std::string& number : said) {
    EXPECT_EQ(number, said.front()) << cell_label(p);
  }
  EXPECT_NE(said.front(), "nothing") << cell_label(p);
  EXPECT_NE(said.front(), "0") << cell_label(p);
}

TEST(Agreement, OfCellsThatComePlanned) {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t change = 1; change <= 3; ++change) {
      for (int i = 0; i < 2; ++i) {
        Parameters p{.v = 0, .k = 4 + random() % 9, .change = change, .kind = kind};
        p.v = p.k + 4 + random() % (100 - p.k - 3);
        ASSERT_TRUE(is_stored_cell(p));
        expect_agreement(p, folder);
      }
    }
  }
}

TEST(Agreement, OfCellsJustOutside) {
  const TemporaryFolder folder;
  for (const Parameters& p :
       {Parameters{161, 12, 1, Kind::linear}, Parameters{162, 7, 2, Kind::circular},
        Parameters{161, 9, 3, Kind::linear}, Parameters{60, 41, 2, Kind::linear},
        Parameters{30, 5, 4, Kind::circular}, Parameters{24, 7, 5, Kind::circular},
        Parameters{198, 9, 2, Kind::linear}, Parameters{208, 8, 8, Kind::circular},
        Parameters{231, 6, 3, Kind::linear}}) {
    ASSERT_FALSE(is_stored_cell(p));
    expect_agreement(p, folder);
  }
}

TEST(Agreement, OfStrengthThree) {
  const TemporaryFolder folder;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    expect_agreement({7, 4, 1, kind, 3}, folder);
    expect_agreement({8, 5, 2, kind, 3}, folder);
    // No design is known, and every interface says so.
    expect({{"$changeover design 20 5 --change 1 --strength 3 --" + std::string(to_string(kind)), 4,
             "No construction serves"},
            {"$changeover bounds 20 5 --change 1 --strength 3 --json --" +
                 std::string(to_string(kind)),
             0, "\"best_known\":null"},
            {"$changeover catalog show 20 5 --change 1 --strength 3", 4, "the catalog has no"}},
           folder);
  }
}

// Found by search, with fewer blocks than all that is known without it.
TEST(Agreement, OfNeighboursOfADesignOfTheUsers) {
  const TemporaryFolder folder;
  spit(folder.file("better.txt"),
       "15 3 17 4 20 6 8 19\n12 1 7 2 13 0 5 16\n17 19 10 14 15 3 6 11\n2 0 4 8 9 20 18 12\n"
       "19 15 7 3 1 6 13 17\n11 18 5 0 9 12 14 10\n13 16 17 6 19 15 7 3\n2 4 8 10 20 14 11 5\n"
       "3 15 12 19 18 6 9 17\n10 1 4 8 20 16 7 13\n2 6 19 15 17 0 5 3\n9 16 14 11 18 7 1 13\n");
  const Parameters cell{21, 8, 8, Kind::circular};
  const std::vector<Parameters> better = {
      cell, {21, 8, 8, Kind::linear}, {22, 9, 8, Kind::circular}, {22, 9, 8, Kind::linear}};
  for (const Parameters& p : better) {
    EXPECT_GT(std::stoi(numbers(p, folder, "").front()), 12) << cell_label(p);
  }
  expect({{"$changeover catalog add better.txt --change 8 --circular --catalog mine.db", 0,
           "with 12 blocks"}},
         folder);
  for (const Parameters& p : better) {
    expect_agreement(p, folder, "mine.db");
    EXPECT_EQ(numbers(p, folder, "mine.db").front(), "12") << cell_label(p);
  }
  // Where others are better already nothing changes.
  expect_agreement({20, 8, 8, Kind::circular}, folder, "mine.db");
  EXPECT_EQ(numbers({20, 8, 8, Kind::circular}, folder, "mine.db"),
            numbers({20, 8, 8, Kind::circular}, folder, ""));
}

}  // namespace
}  // namespace changeover::test::agreement_test
