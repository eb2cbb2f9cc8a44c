#include "changeover/run/control.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace changeover::control_test {
namespace {

using std::chrono::seconds;

TEST(RunControl, RunsUntilItIsStopped) {
  RunControl control({});
  EXPECT_FALSE(control.stop_wanted());
  EXPECT_EQ(control.why_stopped(), WhyStopped::running);
  control.stop(WhyStopped::found);
  control.stop(WhyStopped::exhausted);  // Too late.
  EXPECT_TRUE(control.stop_wanted());
  EXPECT_EQ(control.why_stopped(), WhyStopped::found);
}

TEST(RunControl, StopsWhenTheTimeIsUp) {
  RunControl control({.time = seconds(0)});
  EXPECT_TRUE(control.stop_wanted());
  EXPECT_EQ(control.why_stopped(), WhyStopped::time_limit);
  EXPECT_EQ(control.time_left()->count(), 0.0);
}

TEST(RunControl, TakesALimitBeyondTheClockForNone) {
  RunControl control({.time = std::chrono::duration<double>(1e300)});
  EXPECT_FALSE(control.stop_wanted());
  EXPECT_FALSE(control.time_left().has_value());
}

TEST(RunControl, StopsWhenTheUserSaysSo) {
  std::atomic<bool> interrupted = false;
  RunControl control({.interrupted = &interrupted});
  EXPECT_FALSE(control.stop_wanted());
  interrupted = true;
  EXPECT_TRUE(control.stop_wanted());
  EXPECT_EQ(control.why_stopped(), WhyStopped::interrupted);
}

TEST(RunControl, StopsWhenAnotherProcessFoundIt) {
  RunControl control({.found_elsewhere = [] { return true; }});
  EXPECT_TRUE(control.stop_wanted());
  EXPECT_EQ(control.why_stopped(), WhyStopped::elsewhere);
}

TEST(RunControl, EndsAPhaseWithoutEndingTheWhole) {
  RunControl whole({});
  RunControl phase(whole, seconds(0));
  EXPECT_TRUE(phase.stop_wanted());
  EXPECT_EQ(phase.why_stopped(), WhyStopped::time_limit);
  EXPECT_FALSE(whole.stop_wanted());
  RunControl next(whole, seconds(1000));
  EXPECT_FALSE(next.stop_wanted());
  whole.stop(WhyStopped::interrupted);
  EXPECT_TRUE(next.stop_wanted());
  EXPECT_EQ(next.why_stopped(), WhyStopped::interrupted);
}

TEST(RunControl, TellsFromOneThreadAtATime) {
  std::atomic<int> inside = 0;
  std::atomic<int> told = 0;
  std::atomic<bool> overlapped = false;
  RunControl control({.on_progress =
                          [&](const Progress& progress) {
                            overlapped = overlapped || ++inside > 1;
                            EXPECT_GE(progress.elapsed.count(), 0.0);
                            ++told;
                            --inside;
                          },
                      .progress_interval = std::chrono::duration<double>(0)});
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int j = 0; j < 100; ++j) {
        control.tell({.phase = "testing"});
      }
    });
  }
  threads.clear();
  EXPECT_FALSE(overlapped);
  EXPECT_GT(told, 0);
}

}  // namespace
}  // namespace changeover::control_test
