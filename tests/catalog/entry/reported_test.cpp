#include "changeover/catalog/catalog.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "changeover/bounds/lower_bound.hpp"

namespace changeover::reported_test {
namespace {

constexpr Parameters reported_cell{.v = 26, .k = 6, .change = 1, .kind = Kind::linear};

TEST(Reported, only_what_is_better_than_what_is_held) {
  const auto without = reported_below(reported_cell, std::nullopt);
  ASSERT_TRUE(without);
  EXPECT_EQ(without->blocks, 63U);
  EXPECT_EQ(without->cites, "Bean2026");
  EXPECT_EQ(reported_below(reported_cell, 64)->blocks, 63U);
  EXPECT_FALSE(reported_below(reported_cell, 63));
  EXPECT_FALSE(reported_below(reported_cell, 62));
}

TEST(Reported, for_exactly_these_parameters) {
  for (const auto change : {&Parameters::v, &Parameters::k, &Parameters::change}) {
    Parameters p = reported_cell;
    ++(p.*change);
    EXPECT_FALSE(reported_below(p, std::nullopt)) << name(p);
  }
  Parameters p = reported_cell;
  p.kind = Kind::circular;
  EXPECT_FALSE(reported_below(p, std::nullopt));
  p = reported_cell;
  p.strength = 3;
  EXPECT_FALSE(reported_below(p, std::nullopt));
}

TEST(Reported, who_reports_as_many_blocks) {
  using Keys = std::vector<std::string>;
  EXPECT_EQ(reporters_of({12, 4, 1, Kind::linear}, 21), (Keys{"PreeceEtAl1995", "Phillips1999"}));
  EXPECT_EQ(reporters_of({20, 5, 1, Kind::linear}, 46), Keys{"Phillips2001"});
  EXPECT_EQ(reporters_of({61, 4, 2, Kind::circular}, 366), Keys{"ChafeeStevens2025"});
  EXPECT_EQ(reporters_of({20, 5, 1, Kind::linear}, 47), Keys{});
  EXPECT_EQ(reporters_of({20, 5, 1, Kind::circular}, 46), Keys{});
}

TEST(Reported, nothing_is_below_a_bound_and_all_sources_are_in_the_references) {
  std::ifstream file(CHANGEOVER_TEST_DATA "/../../docs/references.bib");
  const std::string references(std::istreambuf_iterator<char>(file), {});
  ASSERT_FALSE(references.empty());
  for (const Reported& each : reported_designs()) {
    EXPECT_GE(each.blocks, lower_bound(each.parameters).blocks) << name(each.parameters);
    EXPECT_NE(references.find("{" + std::string(each.cites) + ","), std::string::npos)
        << each.cites;
  }
}

}  // namespace
}  // namespace changeover::reported_test
