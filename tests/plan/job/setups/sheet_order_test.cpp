// The tests of several sheets in the order of their steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/job/setups/step_numbers.hpp"

namespace changeover::sheet_order_test {
namespace {

using testing::ElementsAre;

DoneRow test_of(const std::string& bench, std::optional<std::uint64_t> step,
                const std::string& result = "pass") {
  return {.setup = {}, .result = result, .bench = bench, .step = step};
}

std::vector<std::uint64_t> steps_of(const std::vector<DoneRow>& rows) {
  std::vector<std::uint64_t> steps;
  for (const DoneRow& row : rows) {
    steps.push_back(row.step.value_or(0));
  }
  return steps;
}

TEST(SheetOrder, IsThatOfTheSteps) {
  // Earlier tests have numbers of their own, and stay.
  std::vector<DoneRow> rows{test_of("", 9),  test_of("", 4), test_of("", 6),
                            test_of("", {}), test_of("", 1), test_of("", 5)};
  EXPECT_TRUE(put_sheets_in_order(rows, {1, 4}));
  EXPECT_THAT(steps_of(rows), ElementsAre(9, 1, 4, 5, 6, 0));
  EXPECT_FALSE(put_sheets_in_order(rows, {1, 4}));
}

TEST(SheetOrder, IsOfEachBench) {
  std::vector<DoneRow> rows{test_of("N", 2), test_of("S", 1), test_of("N", 1)};
  EXPECT_TRUE(put_sheets_in_order(rows, {0, 1, 2}));
  EXPECT_THAT(steps_of(rows), ElementsAre(1, 1, 2));
  EXPECT_EQ(rows[1].bench, "S");
}

TEST(SheetOrder, StaysIfTheNumbersSayNone) {
  std::vector<DoneRow> twice{test_of("", 3), test_of("", 3), test_of("", 1)};
  EXPECT_FALSE(put_sheets_in_order(twice, {0, 2}));
  std::vector<DoneRow> none{test_of("", 3), test_of("", {}), test_of("", 1)};
  EXPECT_FALSE(put_sheets_in_order(none, {0, 1}));
  EXPECT_THAT(steps_of(none), ElementsAre(3, 0, 1));
  std::vector<DoneRow> rest{test_of("", 7, ""), test_of("", 1)};
  EXPECT_FALSE(put_sheets_in_order(rest, {0, 1})) << "what was done is in its order";
  EXPECT_THAT(steps_of(rest), ElementsAre(1, 7));
}

}  // namespace
}  // namespace changeover::sheet_order_test
