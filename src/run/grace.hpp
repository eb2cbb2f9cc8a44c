// A little more time than the control allows, for work that must be finished when it stops.
//
//     RunGrace grace(control, std::chrono::seconds(1));
//     finish(design);  // stop_if_asked() throws one second later
//
//     RunGrace answer(control);            // never throws: for writing an answer, say
//
// A search that is stopped while it verifies a better design should still hand it out, and one
// whose time was up before it began should still say what is known, if that is quick. Memory limit
// and progress are those of the control. A second Ctrl-C still ends the process: the code that owns
// the signals sees to that.
#pragma once

#include <chrono>
#include <optional>

#include "changeover/run/control.hpp"

namespace changeover {

/// Time to build, shorten and verify a design that is already known or found.
inline constexpr std::chrono::seconds usual_grace{1};

/// The scope of this thread until the end of the block. The control must outlive it.
class RunGrace {
 public:
  /// Stops so long after `control` wants to; without a time it never stops.
  explicit RunGrace(RunControl& control,
                    std::optional<std::chrono::duration<double>> time = std::nullopt);

  RunGrace(const RunGrace&) = delete;
  RunGrace& operator=(const RunGrace&) = delete;

  [[nodiscard]] RunControl& control() { return own_; }

 private:
  [[nodiscard]] RunControl::Settings settings(RunControl& control);
  [[nodiscard]] bool over();

  RunControl& outer_;
  std::optional<std::chrono::duration<double>> time_;
  std::optional<RunControl::Clock::time_point> asked_;  // when the control first wanted to stop
  RunControl own_;
  RunScope scope_;
};

}  // namespace changeover
