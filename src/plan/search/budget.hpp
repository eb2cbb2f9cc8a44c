// What a search of plans may use, which all planners share: its time, its moves, its rounds; and
// what stays when it is over.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// For a part of a search: a control that has this share of the time that is left; where there is
/// no limit, that of the whole search.
class ShareOfTime {
 public:
  ShareOfTime(RunControl& whole, double share);

  [[nodiscard]] RunControl& control() { return part_ ? *part_ : *whole_; }

 private:
  RunControl* whole_;
  std::optional<RunControl> part_;
};

/// What an attempt has of this share of the time left, if the attempts before it are over by now;
/// nothing without a limit.
[[nodiscard]] std::optional<std::chrono::duration<double>> time_of_attempt(
    const RunControl& control, std::size_t attempt, std::size_t attempts, double share);

/// The rounds of a search, each from the best so far: until it is stopped, if it has a time to use;
/// one, if its moves are given; else a few, as long as they help.
class Rounds {
 public:
  struct Limits {
    unsigned most = 4;
    unsigned most_idle = 1;  ///< without anything better, one after another
    unsigned least = 1;      ///< are made even if they are idle
  };

  explicit Rounds(const PlanOptions& options) : options_(&options) {}

  /// The number of the round under way, from 0.
  [[nodiscard]] unsigned now() const { return round_; }

  /// The round is over, and found something better or not: whether there is another one.
  [[nodiscard]] bool go_on(bool better, const Limits& limits);

 private:
  const PlanOptions* options_;
  unsigned round_ = 0;
  unsigned idle_ = 0;
};

/// Why a search is over. A clock that stopped a part of it counts as the time limit; `proved` says
/// that nothing better is possible.
[[nodiscard]] WhyStopped why_it_ended(const RunControl& control, bool proved);

/// Does what may go on for long, or want more than there is: what there is by then stays, and
/// `shortage` says what was missing; `no_memory` does so if it was memory for the next step.
void keep_what_there_is(std::optional<std::string>& shortage, const std::function<void()>& work,
                        const std::function<std::string()>& no_memory);

}  // namespace changeover
