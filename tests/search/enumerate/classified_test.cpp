// The counts that the catalog has are those of the enumeration, and of the literature.
#include <gtest/gtest.h>

#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/search/enumeration.hpp"
#include "tight_count.hpp"

namespace changeover::test::classified_test {
namespace {

std::string groups_of(const Classification& counted) {
  std::string text;
  for (const auto& [order, classes] : counted.group_orders) {
    text += (text.empty() ? "" : " ") + std::to_string(std::stoull(order)) + ":" +
            std::to_string(classes);
  }
  return text;
}

// As sets: the catalog has orders by size.
std::set<std::string> words_of(std::string_view text) {
  std::set<std::string> words;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    words.emplace(word);
    text.remove_prefix(std::min(text.size(), word.size() + 1));
  }
  return words;
}

void expect_counted(const Classified& each, std::chrono::duration<double> most, std::size_t& held) {
  RunControl control({.time = most, .threads = 1});
  const Classification counted = classify_designs(each.parameters, each.b, {}, control);
  if (counted.why_stopped != WhyStopped::exhausted) {
    return;
  }
  ++held;
  EXPECT_EQ(counted.standard_forms, each.standard_forms) << name(each.parameters);
  EXPECT_EQ(counted.classes, each.classes) << name(each.parameters);
  EXPECT_EQ(counted.tight, each.tight) << name(each.parameters);
  EXPECT_EQ(words_of(groups_of(counted)), words_of(each.groups)) << name(each.parameters);
}

TEST(ClassifiedCells, AreThoseOfTheLiterature) {
  const auto tight = [](std::uint64_t v, std::uint64_t k, Kind kind, std::uint64_t b) {
    const auto found = classified({.v = v, .k = k, .change = 1, .kind = kind}, b);
    return found.value_or(Classified{});
  };
  EXPECT_EQ(tight(9, 4, Kind::circular, 12).classes, 2U);    // McSorley1999
  EXPECT_EQ(tight(10, 4, Kind::circular, 15).classes, 12U);  // McSorley1999
  EXPECT_FALSE(classified({.v = 9, .k = 4, .change = 1, .kind = Kind::circular}, 13));
}

TEST(ClassifiedCells, AreMinimaEachOnce) {
  std::set<Parameters> seen;
  for (const Classified& each : classified_cells()) {
    EXPECT_TRUE(seen.insert(each.parameters).second) << name(each.parameters);
    EXPECT_GE(each.b, lower_bound(each.parameters).blocks) << name(each.parameters);
    EXPECT_GE(each.standard_forms, each.classes) << name(each.parameters);
    EXPECT_GE(each.classes, each.tight) << name(each.parameters);
    EXPECT_GE(each.classes, 1U) << name(each.parameters);
  }
  EXPECT_GT(seen.size(), 150U);
}

// Renaming and rotating moves a circular design of b blocks to v!·b/|G| sequences, where G is its
// group; if no two elements are alike, v! of them are one standard form. A linear design is its own
// class.
TEST(ClassifiedCells, FormsAreOrbitsOfTheGroups) {
  for (const Classified& each : classified_cells()) {
    const Parameters& p = each.parameters;
    std::uint64_t classes = 0;
    double forms = 0;
    for (const std::string& word : words_of(each.groups)) {
      const std::uint64_t count = std::stoull(word.substr(word.find(':') + 1));
      classes += count;
      forms += static_cast<double>(each.b * count) / std::stod(word);
    }
    EXPECT_EQ(classes, each.classes) << name(p);
    const auto counted = static_cast<double>(each.standard_forms);
    if (p.kind == Kind::linear) {
      EXPECT_EQ(each.standard_forms, each.classes) << name(p);
    } else if (p.change == 1 && p.v + 2 >= 2 * p.k) {
      EXPECT_NEAR(forms, counted, 1e-6) << name(p);
    } else {
      EXPECT_LE(forms, counted + 1e-6) << name(p);
    }
  }
}

void expect_another_program_counts(int v, int k, Kind kind) {
  TightCount other(v, k, kind);
  const Parameters p{.v = static_cast<std::uint64_t>(v),
                     .k = static_cast<std::uint64_t>(k),
                     .change = 1,
                     .kind = kind};
  const auto found = classified(p, static_cast<std::uint64_t>(other.blocks()));
  ASSERT_TRUE(found) << v << ' ' << k;
  EXPECT_EQ(other.forms(), found->standard_forms) << v << ' ' << k;
}

TEST(ClassifiedCells, TightOnesAreCountedByAnotherProgram) {
  for (const int v : {6, 7}) {
    expect_another_program_counts(v, 3, Kind::linear);
  }
  for (const int v : {4, 5, 8}) {
    expect_another_program_counts(v, 3, Kind::circular);
  }
  for (const int v : {9, 10}) {
    expect_another_program_counts(v, 4, Kind::circular);
  }
}

TEST(ClassifiedCells, LargeTightOnesAreCountedByAnotherProgramSlow) {
  expect_another_program_counts(12, 4, Kind::linear);
  expect_another_program_counts(9, 3, Kind::circular);
}

TEST(ClassifiedCells, SmallOnesAreCountedAnew) {
  std::size_t held = 0;
  for (const Classified& each : classified_cells()) {
    if (each.classes < 300 && each.parameters.v <= 9) {
      expect_counted(each, std::chrono::milliseconds(200), held);
    }
  }
  EXPECT_GT(held, 30U);
}

TEST(ClassifiedCells, AllAreCountedAnewSlow) {
  std::size_t held = 0;
  for (const Classified& each : classified_cells()) {
    expect_counted(each, std::chrono::minutes(10), held);
  }
  EXPECT_EQ(held, classified_cells().size());
}

}  // namespace
}  // namespace changeover::test::classified_test
