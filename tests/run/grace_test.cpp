#include "run/grace.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "changeover/core/error.hpp"

namespace changeover::grace_test {
namespace {

TEST(RunGrace, GoesOnForAWhileAfterTheControlWantsToStop) {
  RunControl control({});
  const RunGrace grace(control, std::chrono::milliseconds(50));
  EXPECT_NO_THROW(stop_if_asked());
  control.stop(WhyStopped::interrupted);
  EXPECT_NO_THROW(stop_if_asked());
  const auto wait = [] {
    for (;;) {
      stop_if_asked();
    }
  };
  EXPECT_THROW(wait(), Stopped);
  EXPECT_EQ(control.why_stopped(), WhyStopped::interrupted);
}

TEST(RunGrace, WithoutATimeNeverStops) {
  std::atomic<bool> interrupted = true;
  RunControl control({.time = std::chrono::seconds(0), .interrupted = &interrupted});
  EXPECT_TRUE(control.stop_wanted());
  const RunGrace grace(control);
  EXPECT_NO_THROW(stop_if_asked());
}

TEST(RunGrace, KeepsTheMemoryLimitAndTheProgress) {
  int told = 0;
  RunControl control({.memory_bytes = 1000,
                      .on_progress = [&](const Progress&) { ++told; },
                      .progress_interval = std::chrono::duration<double>(0)});
  {
    const RunGrace grace(control);
    EXPECT_THROW(require_memory(1001, "a table"), MissingResource);
    report_progress({.phase = "shortening"});
    EXPECT_EQ(told, 1);
  }
  EXPECT_EQ(RunScope::current(), nullptr);
}

}  // namespace
}  // namespace changeover::grace_test
