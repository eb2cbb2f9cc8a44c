#include "serve/http/lanes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>

namespace changeover::serve::lanes_test {
namespace {

TEST(Lanes, QuickTasksPassLongOnes) {
  Lanes lanes({.quick = 1, .slow = 1});
  std::latch slow_may_end(1);
  std::latch quick_done(10);
  std::atomic<int> slow = 0;
  for (int i = 0; i < 5; ++i) {
    lanes.add(Lane::slow, [&] {
      slow_may_end.wait();
      ++slow;
    });
  }
  for (int i = 0; i < 10; ++i) {
    lanes.add(Lane::quick, [&] { quick_done.count_down(); });
  }
  quick_done.wait();  // or this test never ends
  EXPECT_EQ(slow, 0);
  slow_may_end.count_down();
  EXPECT_TRUE(lanes.stop(std::chrono::minutes(1)));
  EXPECT_EQ(slow, 5);  // what had not begun was called by stop()
}

TEST(Lanes, StopSaysWhenSomethingDoesNotEnd) {
  std::latch may_end(1);
  std::latch begun(1);
  Lanes lanes({.quick = 1, .slow = 1});
  lanes.add(Lane::slow, [&] {
    begun.count_down();
    may_end.wait();
  });
  begun.wait();
  EXPECT_FALSE(lanes.stop(std::chrono::milliseconds(1)));
  may_end.count_down();
  EXPECT_TRUE(lanes.stop(std::chrono::minutes(1)));
  bool called = false;
  lanes.add(Lane::quick, [&] { called = true; });
  EXPECT_TRUE(called);
}

}  // namespace
}  // namespace changeover::serve::lanes_test
