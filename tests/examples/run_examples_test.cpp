// The examples of the headers of run/, as they stand there.
#include <iostream>

#include "example_support.hpp"

namespace changeover::test::run_examples_test {
namespace {

using changeover::Outcome;  // not that of a program that was run

TEST(RunExamples, Control) {
  int taken = 0;
  const auto take_steps = [&](RunControl& control) {
    control.tell({.phase = "taking steps"}, true);
    if (++taken == 3) {
      control.stop(WhyStopped::found);
    }
  };
  testing::internal::CaptureStderr();
  RunControl control({.time = std::chrono::seconds(60),
                      .threads = 2,
                      .seed = 7,
                      .on_progress = [](const Progress& p) { std::cerr << p.phase << '\n'; }});
  while (!control.stop_wanted()) {  // what a search does with it
    take_steps(control);
  }
  EXPECT_EQ(control.why_stopped(), WhyStopped::found);
  EXPECT_EQ(taken, 3);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::StartsWith("taking steps\n"));
}

TEST(RunExamples, ControlOfTime) {
  RunControl control({.time = std::chrono::seconds(0)});
  EXPECT_TRUE(control.stop_wanted());
  EXPECT_EQ(control.why_stopped(), WhyStopped::time_limit);
}

TEST(RunExamples, Outcome) { EXPECT_EQ(to_string(Outcome::none), "none"); }

TEST(RunExamples, Scope) {
  const Parameters p{.v = 8, .k = 5, .kind = Kind::circular};
  RunControl control({});
  {
    RunScope scope(control);             // for this thread, until the end of the block
    const Bound bound = lower_bound(p);  // stops with the control, and tells it where it is
    EXPECT_GT(bound.blocks, 0U);
    control.stop(WhyStopped::interrupted);
    EXPECT_THROW(stop_if_asked(), Stopped);
  }
  EXPECT_NO_THROW(stop_if_asked());
}

}  // namespace
}  // namespace changeover::test::run_examples_test
