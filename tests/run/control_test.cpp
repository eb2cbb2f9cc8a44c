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

TEST(RunControl, KnowsThatAPartOfItHadTooLittleTime) {
  RunControl whole({.time = std::chrono::hours(1), .seed = 5});
  RunControl part(whole, seconds(1));
  EXPECT_FALSE(part.stop_wanted());
  EXPECT_FALSE(whole.time_was_up());
  RunControl within(part, seconds(0), 9);
  EXPECT_EQ(within.seed(), 9U);
  EXPECT_EQ(part.seed(), 5U);
  EXPECT_TRUE(within.stop_wanted());
  EXPECT_TRUE(part.time_was_up());
  EXPECT_TRUE(whole.time_was_up());
  EXPECT_FALSE(whole.stop_wanted());
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

TEST(RunControl, StopsAfterSoManyQuestions) {
  RunControl whole({});
  RunControl part(whole, Questions{3});
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(part.stop_wanted());
  }
  EXPECT_TRUE(part.stop_wanted());
  EXPECT_TRUE(part.stop_wanted());
  EXPECT_EQ(part.why_stopped(), WhyStopped::step_limit);
  EXPECT_FALSE(whole.stop_wanted());
  // Questions of a part count for the whole.
  RunControl few(whole, Questions{2});
  RunControl many(few, Questions{100});
  EXPECT_FALSE(many.stop_wanted());
  EXPECT_FALSE(many.stop_wanted());
  EXPECT_TRUE(many.stop_wanted());
  EXPECT_EQ(many.why_stopped(), WhyStopped::step_limit);
}

TEST(RunControl, GoesOnBeyondTheLimitOfItsParentAlone) {
  std::atomic<bool> interrupted = false;
  RunControl whole({.interrupted = &interrupted});
  RunControl outer(whole, seconds(1000));
  RunControl timed(outer, seconds(0));
  RunControl counted(outer, Questions{0});
  const auto beyond_time = RunControl::beyond_limit(timed);
  const auto beyond_count = RunControl::beyond_limit(counted);
  EXPECT_FALSE(beyond_time->stop_wanted());
  EXPECT_TRUE(timed.stop_wanted());
  EXPECT_FALSE(beyond_time->stop_wanted());
  EXPECT_FALSE(beyond_count->stop_wanted());
  EXPECT_TRUE(counted.stop_wanted());
  EXPECT_FALSE(beyond_count->stop_wanted());
  RunControl below(*beyond_time, seconds(1000));
  EXPECT_FALSE(below.stop_wanted());
  interrupted = true;
  EXPECT_TRUE(below.stop_wanted());
  EXPECT_TRUE(beyond_time->stop_wanted());
  EXPECT_TRUE(beyond_count->stop_wanted());
  // What is above the parent counts.
  RunControl over({.time = seconds(0)});
  RunControl within(over, seconds(1000));
  EXPECT_TRUE(RunControl::beyond_limit(within)->stop_wanted());
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
