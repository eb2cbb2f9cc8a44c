#include "changeover/run/control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>

#include "changeover/core/error.hpp"
#include "run/threads.hpp"

namespace changeover::scope_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(RunScope, DoesNothingWhereNoneIsOpen) {
  EXPECT_EQ(RunScope::current(), nullptr);
  EXPECT_NO_THROW(stop_if_asked());
  EXPECT_NO_THROW(require_memory(UINT64_MAX, "a table"));
  EXPECT_FALSE(progress_due());
}

TEST(RunScope, ThrowsWhatTheControlOfTheInnermostScopeWants) {
  RunControl outer({});
  RunControl inner({});
  const RunScope first(outer);
  {
    const RunScope second(inner);
    inner.stop(WhyStopped::time_limit);
    try {
      stop_if_asked();
      ADD_FAILURE() << "it did not stop";
    } catch (const Stopped& stopped) {
      EXPECT_EQ(stopped.why(), WhyStopped::time_limit);
    }
  }
  EXPECT_NO_THROW(stop_if_asked());
  EXPECT_EQ(RunScope::current(), &outer);
}

TEST(RunScope, IsOfOneThread) {
  RunControl control({});
  const RunScope scope(control);
  control.stop(WhyStopped::interrupted);
  bool went_on = false;
  std::thread([&] {
    stop_if_asked();
    went_on = true;
  }).join();
  EXPECT_TRUE(went_on);
}

TEST(RunScope, RefusesMoreMemoryThanAllowedInOneLine) {
  RunControl control({.memory_bytes = 1'000'000'000});
  const RunScope scope(control);
  EXPECT_NO_THROW(require_memory(1'000'000'000, "a table"));
  try {
    require_memory(2'500'000'000, "the formula of DCCD(60,5)");
    ADD_FAILURE() << "it was not refused";
  } catch (const MissingResource& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("the formula of DCCD(60,5) would take about 2.5 GB"));
    EXPECT_THAT(fault.what(), HasSubstr("1.0 GB allowed"));
  }
}

TEST(RunScope, TellsTheControlHowFarItIs) {
  std::string phase;
  RunControl control({.on_progress = [&](const Progress& told) { phase = told.phase; }});
  const RunScope scope(control);
  EXPECT_TRUE(progress_due());
  report_progress({.phase = "counting"});
  EXPECT_EQ(phase, "counting");
}

TEST(RunTogether, CallsEachOnceWithTheScopeOfTheControl) {
  RunControl control({.threads = 4});
  std::atomic<unsigned> sum = 0;
  std::atomic<unsigned> scoped = 0;
  run_together(control, 4, [&](unsigned i) {
    sum += 1U << i;
    scoped += RunScope::current() == &control ? 1U : 0U;
  });
  EXPECT_EQ(sum, 15U);
  EXPECT_EQ(scoped, 4U);
  EXPECT_EQ(RunScope::current(), nullptr);
}

TEST(RunTogether, StopsAllAndThrowsTheFirstFault) {
  RunControl control({.threads = 3});
  EXPECT_THROW(run_together(control, 3,
                            [&](unsigned i) {
                              if (i == 1) {
                                throw BadInput("no");
                              }
                              while (!control.stop_wanted()) {
                                std::this_thread::yield();
                              }
                            }),
               BadInput);
  EXPECT_EQ(control.why_stopped(), WhyStopped::fault);
}

TEST(RunTogether, TakesStoppedForNoFault) {
  RunControl control({.threads = 2});
  control.stop(WhyStopped::time_limit);
  EXPECT_NO_THROW(run_together(control, 2, [](unsigned) { stop_if_asked(); }));
  EXPECT_EQ(control.why_stopped(), WhyStopped::time_limit);
}

TEST(RunTogether, SaysSoWhereTheSystemHasNoRoomForTheThreads) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizers need more address space than this test leaves";
#endif
  // Each thread needs a stack; the address space is too small for so many of them.
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_AS, &old), 0);
  rlimit small = old;
  small.rlim_cur = rlim_t{1} << 30;
  ASSERT_EQ(::setrlimit(RLIMIT_AS, &small), 0);
  std::atomic<unsigned> calls = 0;
  RunControl control({});
  try {
    run_together(control, 4000, [&](unsigned) { ++calls; });
    ADD_FAILURE() << "4000 threads were started";
  } catch (const MissingResource& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("cannot start 3999 threads: "));
    EXPECT_THAT(fault.what(), EndsWith("; use fewer, or allow more"));
  }
  ::setrlimit(RLIMIT_AS, &old);
  EXPECT_EQ(calls, 0U);
}

TEST(InParallel, CallsEveryTaskOnce) {
  RunControl control({.threads = 3});
  std::array<std::atomic<unsigned>, 100> calls{};
  in_parallel(control, calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const auto& count : calls) {
    EXPECT_EQ(count, 1U);
  }
  EXPECT_NO_THROW(in_parallel(control, 0, [](std::size_t) { throw std::logic_error("none"); }));
}

TEST(RunControl, ForOneOfSeveralAttemptsIsQuietAndStopsWithItsParent) {
  unsigned told = 0;
  RunControl parent({.threads = 4, .on_progress = [&](const Progress&) { ++told; }});
  RunControl attempt(parent, 1U);
  EXPECT_EQ(attempt.threads(), 1U);
  attempt.tell({.phase = "x"}, true);
  EXPECT_EQ(told, 0U);
  attempt.stop(WhyStopped::found);
  EXPECT_FALSE(parent.stop_wanted());
  RunControl other(parent, 1U);
  parent.stop(WhyStopped::interrupted);
  EXPECT_TRUE(other.stop_wanted());
}

}  // namespace
}  // namespace changeover::scope_test
