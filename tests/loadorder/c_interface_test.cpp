#include <gtest/gtest.h>

#include <string>

#include "changeover/loadorder/changeover_loadorder.h"

extern "C" {
long count_pairs_in_c(uint64_t items, uint64_t room, uint64_t* loads_seen);
int error_in_c(uint64_t items, uint64_t room, char* error, size_t size);
}

namespace changeover::test::c_interface_test {
namespace {

TEST(CInterface, BringsAllPairsTogetherInAProgramWrittenInC) {
  for (const std::uint64_t items : {1U, 2U, 7U, 20U, 64U}) {
    std::uint64_t loads = 0;
    EXPECT_EQ(count_pairs_in_c(items, 5, &loads), static_cast<long>(items * (items - 1) / 2));
    EXPECT_GE(loads, items);
  }
}

TEST(CInterface, SaysInOneLineWhatIsWrongAndKeepsToTheSizeOfTheText) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  EXPECT_EQ(error_in_c(0, 5, error, sizeof error), 1);
  EXPECT_NE(std::string(error).find("0 items"), std::string::npos);
  EXPECT_EQ(error_in_c(9, 1, error, sizeof error), 1);
  EXPECT_NE(std::string(error).find("at least 2"), std::string::npos);
  char little[5] = {'x', 'x', 'x', 'x', 'x'};
  EXPECT_EQ(error_in_c(9, 1, little, sizeof little), 1);
  EXPECT_EQ(std::string(little), "room");
  EXPECT_EQ(error_in_c(9, 1, nullptr, 0), 1);
}

TEST(CInterface, AnswersAbsurdArgumentsInOneLineAndThrowsNothing) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  for (const std::uint64_t items :
       {std::uint64_t{0}, std::uint64_t{5}, std::uint64_t{1} << 32, UINT64_MAX / 2, UINT64_MAX}) {
    for (const std::uint64_t room :
         {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 33, UINT64_MAX}) {
      changeover_loadorder* order = changeover_loadorder_open(items, room, error, sizeof error);
      if (order == nullptr) {
        EXPECT_NE(std::string(error), "") << items << ' ' << room;
        EXPECT_EQ(std::string(error).find('\n'), std::string::npos);
      } else {
        EXPECT_EQ(std::string(error), "");
        EXPECT_EQ(items, 5U);
      }
      changeover_loadorder_close(order);
    }
  }
}

TEST(CInterface, TakesNothingForAnErrorAndNotForAnOrder) {
  changeover_loadorder_step step;
  EXPECT_EQ(changeover_loadorder_next(nullptr, &step), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_EQ(changeover_loadorder_rewind(nullptr), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_EQ(changeover_loadorder_loads(nullptr), 0U);
  EXPECT_EQ(changeover_loadorder_steps(nullptr), 0U);
  EXPECT_EQ(changeover_loadorder_lower_bound(nullptr), 0U);
  EXPECT_NE(std::string(changeover_loadorder_error(nullptr)), "");
  changeover_loadorder* order = changeover_loadorder_open(9, 4, nullptr, 100);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(changeover_loadorder_next(order, nullptr), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_NE(std::string(changeover_loadorder_error(order)), "");
  EXPECT_EQ(changeover_loadorder_next(order, &step), CHANGEOVER_LOADORDER_STEP);
  EXPECT_EQ(step.number, 1U);
  changeover_loadorder_close(order);
}

TEST(CInterface, StartsOverWhenAsked) {
  changeover_loadorder* order = changeover_loadorder_open(9, 4, nullptr, 0);
  ASSERT_NE(order, nullptr);
  changeover_loadorder_step step;
  std::uint64_t steps = 0;
  while (changeover_loadorder_next(order, &step) == CHANGEOVER_LOADORDER_STEP) {
    ++steps;
  }
  EXPECT_EQ(steps, changeover_loadorder_steps(order));
  EXPECT_EQ(changeover_loadorder_next(order, &step), CHANGEOVER_LOADORDER_END);
  EXPECT_EQ(changeover_loadorder_rewind(order), CHANGEOVER_LOADORDER_END);
  ASSERT_EQ(changeover_loadorder_next(order, &step), CHANGEOVER_LOADORDER_STEP);
  EXPECT_EQ(step.number, 1U);
  EXPECT_EQ(step.load_count, 4U);
  changeover_loadorder_close(order);
}

}  // namespace
}  // namespace changeover::test::c_interface_test
