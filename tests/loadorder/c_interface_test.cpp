#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/version.hpp"
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

changeover_loadorder_options some_options() {
  changeover_loadorder_options options{};
  options.size = sizeof options;
  return options;
}

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// Plays what a worker does; its pairs are computed with both items in memory.
void play(changeover_loadorder* order, std::uint64_t worker, std::uint64_t room, Pairs& pairs,
          std::uint64_t& loads) {
  ASSERT_EQ(changeover_loadorder_take_worker(order, worker), CHANGEOVER_LOADORDER_END);
  std::set<std::uint32_t> memory;
  changeover_loadorder_step step;
  loads = 0;
  while (changeover_loadorder_next(order, &step) == CHANGEOVER_LOADORDER_STEP) {
    for (std::size_t i = 0; i < step.evict_count; ++i) {
      ASSERT_EQ(memory.erase(step.evict[i]), 1U);
    }
    for (std::size_t i = 0; i < step.load_count; ++i) {
      ASSERT_TRUE(memory.insert(step.load[i]).second);
      ++loads;
    }
    ASSERT_LE(memory.size(), room);
    std::size_t count = 0;
    const std::uint32_t* const of_step = changeover_loadorder_pairs(order, &count);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_LT(of_step[2 * i], of_step[2 * i + 1]);
      ASSERT_TRUE(memory.contains(of_step[2 * i]) && memory.contains(of_step[2 * i + 1]));
      ASSERT_TRUE(pairs.emplace(of_step[2 * i], of_step[2 * i + 1]).second);
    }
  }
  ASSERT_EQ(std::string(changeover_loadorder_error(order)), "");
}

TEST(COptions, WorkersComputeEachPairOnceInWhateverOrderTheyAreTaken) {
  for (const int first_holder : {0, 1}) {
    changeover_loadorder_options options = some_options();
    options.workers = 3;
    options.with_pairs = 1;
    options.first_holder = first_holder;
    changeover_loadorder* order = changeover_loadorder_open_with(30, 8, &options, nullptr, 0);
    ASSERT_NE(order, nullptr);
    EXPECT_EQ(changeover_loadorder_workers(order), 3U);
    Pairs all;
    std::uint64_t together = 0;
    std::uint64_t most = 0;
    for (const std::uint64_t worker : {2U, 0U, 1U}) {
      Pairs pairs;
      std::uint64_t loads = 0;
      play(order, worker, 8, pairs, loads);
      EXPECT_EQ(pairs.size(), changeover_loadorder_worker_pairs(order, worker));
      EXPECT_EQ(loads, changeover_loadorder_worker_loads(order, worker));
      together += loads;
      most = std::max(most, loads);
      for (const auto& pair : pairs) {
        EXPECT_TRUE(all.insert(pair).second);
      }
    }
    EXPECT_EQ(all.size(), 435U);
    EXPECT_EQ(together, changeover_loadorder_loads(order));
    EXPECT_GE(most, changeover_loadorder_makespan_bound(order));
    EXPECT_EQ(changeover_loadorder_take_worker(order, 3), CHANGEOVER_LOADORDER_ERROR);
    EXPECT_EQ(changeover_loadorder_seek(order, 1), CHANGEOVER_LOADORDER_ERROR);
    changeover_loadorder_close(order);
  }
}

// Reads the steps of all workers side by side: no two ever hold one item, and every pair is
// computed once.
void play_together(std::uint64_t items, std::uint64_t room, std::uint64_t workers) {
  changeover_loadorder_options options = some_options();
  options.workers = workers;
  options.disjoint = 1;
  options.with_pairs = 1;
  std::vector<changeover_loadorder*> orders;
  for (std::uint64_t w = 0; w < workers; ++w) {
    orders.push_back(changeover_loadorder_open_with(items, room, &options, nullptr, 0));
    ASSERT_NE(orders.back(), nullptr);
    ASSERT_EQ(changeover_loadorder_workers(orders.back()), workers);
    ASSERT_EQ(changeover_loadorder_take_worker(orders.back(), w), CHANGEOVER_LOADORDER_END);
  }
  const std::uint64_t steps = changeover_loadorder_steps(orders.front());
  EXPECT_EQ(steps % workers, 0U);
  std::vector<std::set<std::uint32_t>> memory(workers);
  std::vector<std::uint64_t> loads(workers);
  std::vector<std::uint64_t> computed_by(workers);
  Pairs pairs;
  for (std::uint64_t number = 1; number <= steps / workers; ++number) {
    std::vector<changeover_loadorder_step> all(workers);
    for (std::size_t w = 0; w < workers; ++w) {
      ASSERT_EQ(changeover_loadorder_next(orders[w], &all[w]), CHANGEOVER_LOADORDER_STEP);
      ASSERT_EQ(all[w].number, number);
      for (std::size_t i = 0; i < all[w].evict_count; ++i) {
        ASSERT_EQ(memory[w].erase(all[w].evict[i]), 1U);
      }
    }
    std::set<std::uint32_t> held;
    std::size_t held_by_each = 0;
    for (std::size_t w = 0; w < workers; ++w) {
      memory[w].insert(all[w].load, all[w].load + all[w].load_count);
      loads[w] += all[w].load_count;
      ASSERT_LE(memory[w].size(), room);
      held.insert(memory[w].begin(), memory[w].end());
      held_by_each += memory[w].size();
    }
    ASSERT_EQ(held.size(), held_by_each) << "step " << number;
    for (std::size_t w = 0; w < workers; ++w) {
      std::size_t count = 0;
      const std::uint32_t* const computed = changeover_loadorder_pairs(orders[w], &count);
      computed_by[w] += count;
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(memory[w].contains(computed[2 * i]) && memory[w].contains(computed[2 * i + 1]));
        ASSERT_TRUE(pairs.emplace(computed[2 * i], computed[2 * i + 1]).second);
      }
    }
  }
  EXPECT_EQ(pairs.size(), items * (items - 1) / 2);
  std::uint64_t together = 0;
  for (std::size_t w = 0; w < workers; ++w) {
    changeover_loadorder_step step;
    EXPECT_EQ(changeover_loadorder_next(orders[w], &step), CHANGEOVER_LOADORDER_END);
    EXPECT_EQ(loads[w], changeover_loadorder_worker_loads(orders[w], w));
    EXPECT_EQ(computed_by[w], changeover_loadorder_worker_pairs(orders[w], w));
    EXPECT_GE(changeover_loadorder_loads(orders[w]), changeover_loadorder_lower_bound(orders[w]));
    together += loads[w];
  }
  EXPECT_EQ(together, changeover_loadorder_loads(orders.front()));
  EXPECT_GE(*std::ranges::max_element(loads), changeover_loadorder_makespan_bound(orders.front()));
  for (changeover_loadorder* const order : orders) {
    changeover_loadorder_close(order);
  }
}

TEST(COptions, DisjointWorkersNeverHoldOneItemTwice) {
  play_together(30, 6, 3);
  play_together(24, 8, 2);
  play_together(10, 4, 1);
}

TEST(COptions, DisjointWorkersShowLoadsWithoutPairsAndBeginAtTheirFirstStep) {
  changeover_loadorder_options options = some_options();
  options.workers = 2;
  options.disjoint = 1;
  changeover_loadorder* order = changeover_loadorder_open_with(20, 5, &options, nullptr, 0);
  ASSERT_NE(order, nullptr);
  for (const std::uint64_t worker : {1U, 0U}) {
    Pairs pairs;
    std::uint64_t loads = 0;
    play(order, worker, 5, pairs, loads);
    EXPECT_EQ(loads, changeover_loadorder_worker_loads(order, worker));
    EXPECT_TRUE(pairs.empty());
  }
  EXPECT_EQ(changeover_loadorder_seek(order, 2), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_NE(std::string(changeover_loadorder_error(order)).find("from the first"),
            std::string::npos);
  EXPECT_EQ(changeover_loadorder_take_worker(order, 2), CHANGEOVER_LOADORDER_ERROR);
  changeover_loadorder_close(order);
}

// A list that was forgotten is not all pairs, and seconds are checked as elsewhere.
TEST(COptions, ForgottenListsAndSecondsThatAreNoneAreRefused) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  const auto refused = [&](const changeover_loadorder_options& options) {
    EXPECT_EQ(changeover_loadorder_open_with(10, 3, &options, error, sizeof error), nullptr);
    return std::string(error);
  };
  changeover_loadorder_options options = some_options();
  options.pair_count = 2;
  EXPECT_EQ(refused(options), "pair_count is 2, but pairs is NULL; give both");
  options = some_options();
  options.group_count = 3;
  EXPECT_EQ(refused(options), "group_count is 3, but group_items is NULL; give both");
  for (const double seconds : {std::nan(""), -1.0, HUGE_VAL}) {
    options = some_options();
    options.seconds = seconds;
    EXPECT_EQ(refused(options), "seconds is not a number of seconds, 0 or more; correct it");
  }
}

TEST(COptions, OfASizeThatNoHeaderHasAreRefused) {
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  const auto refused = [&](const changeover_loadorder_options& options) {
    EXPECT_EQ(changeover_loadorder_open_with(10, 3, &options, error, sizeof error), nullptr);
    return std::string(error);
  };
  changeover_loadorder_options options = some_options();
  options.size = 3;
  EXPECT_EQ(refused(options),
            "the size of the options is 3; set it to sizeof (changeover_loadorder_options)");
  for (const std::size_t size : {std::size_t{0}, std::size_t{15}, SIZE_MAX}) {
    options.size = size;
    EXPECT_EQ(refused(options), "the size of the options is " + std::to_string(size) +
                                    "; set it to sizeof (changeover_loadorder_options)");
  }
  // With `workers` alone, as the first header would have had it.
  options.size = offsetof(changeover_loadorder_options, pairs);
  options.workers = 2;
  changeover_loadorder* const order =
      changeover_loadorder_open_with(10, 3, &options, error, sizeof error);
  ASSERT_NE(order, nullptr) << error;
  EXPECT_EQ(changeover_loadorder_workers(order), 2U);
  EXPECT_EQ(changeover_loadorder_take_worker(order, 2), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_STREQ(changeover_loadorder_error(order), "there is no worker 2; give 0 to 1");
  changeover_loadorder_close(order);
}

TEST(COptions, OfANewerHeaderAreRefusedIfTheyAreSet) {
  struct Newer {
    changeover_loadorder_options known;
    std::uint64_t added;
  } newer{some_options(), 0};
  newer.known.size = sizeof newer;
  changeover_loadorder* const order =
      changeover_loadorder_open_with(10, 3, &newer.known, nullptr, 0);
  EXPECT_NE(order, nullptr);
  changeover_loadorder_close(order);
  newer.added = 1;
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  EXPECT_EQ(changeover_loadorder_open_with(10, 3, &newer.known, error, sizeof error), nullptr);
  EXPECT_EQ(std::string(error), "an option is set that version " +
                                    std::string(changeover::version) +
                                    " does not know; leave it out, or use a newer library");
}

TEST(COptions, TheVersionIsThatOfTheLibrary) {
  EXPECT_EQ(std::string(changeover_loadorder_version()), std::string(changeover::version));
  EXPECT_EQ(CHANGEOVER_LOADORDER_VERSION, CHANGEOVER_VERSION);
  unsigned major = 0;
  unsigned minor = 0;
  unsigned patch = 0;
  ASSERT_EQ(std::sscanf(changeover_loadorder_version(), "%u.%u.%u", &major, &minor, &patch), 3);
  EXPECT_EQ(major * 10000 + minor * 100 + patch, unsigned{CHANGEOVER_VERSION});
}

TEST(COptions, DisjointWorkersAreRefusedWhatTheyCannotHave) {
  changeover_loadorder_options options = some_options();
  options.disjoint = 1;
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  const auto refused = [&](std::uint64_t room) {
    EXPECT_EQ(changeover_loadorder_open_with(20, room, &options, error, sizeof error), nullptr);
    return std::string(error);
  };
  EXPECT_EQ(refused(5), "disjoint needs workers; set workers to 1 or more");
  options.workers = 3;
  changeover_loadorder* const crowded =
      changeover_loadorder_open_with(20, 8, &options, error, sizeof error);
  EXPECT_NE(crowded, nullptr) << error;
  changeover_loadorder_close(crowded);
  options.unread = 1;
  EXPECT_EQ(refused(5), "unread has no meaning with disjoint; leave it out");
  options.pair_cost = [](std::uint32_t, std::uint32_t, void*) { return 1.0; };
  EXPECT_EQ(refused(5), "pair_cost has no meaning with disjoint; leave it out");
  options.first_holder = 1;
  EXPECT_EQ(refused(5), "first_holder has no meaning with disjoint; leave it out");
  // A program that does not know of disjoint workers.
  options = some_options();
  options.workers = 3;
  options.disjoint = 1;
  options.size = offsetof(changeover_loadorder_options, disjoint);
  changeover_loadorder* order =
      changeover_loadorder_open_with(20, 8, &options, error, sizeof error);
  ASSERT_NE(order, nullptr);
  changeover_loadorder_close(order);
}

TEST(COptions, OnlyTheListedPairsAreComputed) {
  const std::vector<std::uint32_t> list{0, 1, 5, 2, 3, 9, 9, 0};
  changeover_loadorder_options options = some_options();
  options.pairs = list.data();
  options.pair_count = 4;
  options.with_pairs = 1;
  changeover_loadorder* order = changeover_loadorder_open_with(10, 3, &options, nullptr, 0);
  ASSERT_NE(order, nullptr);
  Pairs pairs;
  std::uint64_t loads = 0;
  play(order, 0, 3, pairs, loads);
  EXPECT_EQ(pairs, (Pairs{{0, 1}, {2, 5}, {3, 9}, {0, 9}}));
  changeover_loadorder_close(order);
  options.against = 4;
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  EXPECT_EQ(changeover_loadorder_open_with(10, 3, &options, error, sizeof error), nullptr);
  EXPECT_NE(std::string(error).find("give one of"), std::string::npos);
}

TEST(COptions, PairsWithinGroupsAreComputed) {
  const std::vector<std::uint32_t> items{0, 1, 2, 7, 2, 3, 1, 4};
  const std::vector<std::size_t> sizes{3, 1, 0, 3, 1};
  changeover_loadorder_options options = some_options();
  options.group_items = items.data();
  options.group_sizes = sizes.data();
  options.group_count = sizes.size();
  options.with_pairs = 1;
  changeover_loadorder* order = changeover_loadorder_open_with(10, 3, &options, nullptr, 0);
  ASSERT_NE(order, nullptr);
  Pairs pairs;
  std::uint64_t loads = 0;
  play(order, 0, 3, pairs, loads);
  EXPECT_EQ(pairs, (Pairs{{0, 1}, {0, 2}, {1, 2}, {2, 3}, {1, 3}}));
  changeover_loadorder_close(order);
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  const auto refused = [&] {
    EXPECT_EQ(changeover_loadorder_open_with(10, 3, &options, error, sizeof error), nullptr);
    return std::string(error);
  };
  options.done_items = 4;
  EXPECT_NE(refused().find("give one of"), std::string::npos);
  options.done_items = 0;
  options.group_count = 0;
  EXPECT_NE(refused().find("no pair is in a group"), std::string::npos);
  options.group_sizes = nullptr;
  EXPECT_NE(refused().find("group_sizes is NULL"), std::string::npos);
  // A program that does not know of groups.
  options.size = offsetof(changeover_loadorder_options, group_items);
  order = changeover_loadorder_open_with(10, 3, &options, error, sizeof error);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(changeover_loadorder_worker_pairs(order, 0), 45U);
  changeover_loadorder_close(order);
}

TEST(COptions, CostsAreSpreadAndMayBeWrong) {
  changeover_loadorder_options options = some_options();
  options.workers = 2;
  double each = 1;
  options.data = &each;
  options.pair_cost = [](std::uint32_t item, std::uint32_t, void* data) {
    return item == 0 ? 50.0 : *static_cast<double*>(data);
  };
  changeover_loadorder* order = changeover_loadorder_open_with(24, 8, &options, nullptr, 0);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(
      changeover_loadorder_worker_pairs(order, 0) + changeover_loadorder_worker_pairs(order, 1),
      276U);
  changeover_loadorder_close(order);
  each = -1;
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  EXPECT_EQ(changeover_loadorder_open_with(24, 8, &options, error, sizeof error), nullptr);
  EXPECT_NE(std::string(error).find("give 0 or more"), std::string::npos);
}

TEST(COptions, ASearchIsGivenUpWhenTheProgramWantsThat) {
  changeover_loadorder_options options = some_options();
  options.seconds = 1e9;
  options.cancelled = [](void*) { return 1; };
  char error[CHANGEOVER_LOADORDER_ERROR_SIZE];
  EXPECT_EQ(changeover_loadorder_open_with(60, 9, &options, error, sizeof error), nullptr);
  EXPECT_EQ(std::string(error), "cancelled");
}

TEST(COptions, ReadingBeginsAtAnyStep) {
  changeover_loadorder* order = changeover_loadorder_open(40, 7, nullptr, 0);
  ASSERT_NE(order, nullptr);
  std::set<std::uint32_t> memory;
  changeover_loadorder_step step;
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(changeover_loadorder_next(order, &step), CHANGEOVER_LOADORDER_STEP);
    for (std::size_t e = 0; e < step.evict_count; ++e) {
      memory.erase(step.evict[e]);
    }
    memory.insert(step.load, step.load + step.load_count);
  }
  ASSERT_EQ(changeover_loadorder_seek(order, 20), CHANGEOVER_LOADORDER_END);
  ASSERT_EQ(changeover_loadorder_next(order, &step), CHANGEOVER_LOADORDER_STEP);
  EXPECT_EQ(step.number, 20U);
  EXPECT_EQ(std::set<std::uint32_t>(step.load, step.load + step.load_count), memory);
  EXPECT_EQ(changeover_loadorder_seek(order, 0), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_EQ(changeover_loadorder_seek(order, changeover_loadorder_steps(order) + 1),
            CHANGEOVER_LOADORDER_ERROR);
  changeover_loadorder_close(order);
}

// Programs that know less of the options, or none.
TEST(COptions, MayBeShorter) {
  changeover_loadorder_options options = some_options();
  options.workers = 2;
  options.against = 1000;
  options.size = offsetof(changeover_loadorder_options, pairs);
  changeover_loadorder* order = changeover_loadorder_open_with(20, 5, &options, nullptr, 0);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(changeover_loadorder_workers(order), 2U);
  EXPECT_LT(changeover_loadorder_loads(order), 1000U);
  changeover_loadorder_close(order);
  order = changeover_loadorder_open_with(20, 5, nullptr, nullptr, 0);
  EXPECT_EQ(changeover_loadorder_workers(order), 1U);
  changeover_loadorder_close(order);
  EXPECT_EQ(changeover_loadorder_workers(nullptr), 0U);
  EXPECT_EQ(changeover_loadorder_worker_loads(nullptr, 0), 0U);
}

}  // namespace
}  // namespace changeover::test::c_interface_test
