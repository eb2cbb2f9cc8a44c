// Checks whether to stop in loops with short iterations.
#pragma once

#include <cstdint>

#include "changeover/run/control.hpp"

namespace changeover {

/// Reads the clock once enough work was done, since reading it costs as much as dozens of steps.
class Listener {
 public:
  explicit Listener(RunControl& control) : control_(&control) {}

  /// Whether to stop, after this much more work: roughly in nanoseconds, within a factor of ten.
  /// Once true, always true.
  [[nodiscard]] bool stop_wanted(std::uint64_t work) {
    constexpr std::uint64_t enough = 10'000;
    done_ += work;
    if (done_ >= enough) {
      done_ = 0;
      stopped_ = stopped_ || control_->stop_wanted();
    }
    return stopped_;
  }

 private:
  RunControl* control_;
  std::uint64_t done_ = 0;
  bool stopped_ = false;
};

}  // namespace changeover
