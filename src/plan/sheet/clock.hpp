// A clock for sheets whose costs are times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "changeover/plan/job.hpp"

namespace changeover {

/// The total duration of tests and changes: "1:35" for an hour and 35 minutes, "1:35:20" if some
/// cost is not whole minutes.
class Clock {
 public:
  explicit Clock(const Job& job);

  /// Whether the costs are times.
  [[nodiscard]] bool runs() const { return ticks_ > 0; }
  /// Rounds up to a whole tick, so that a step is over at the time shown.
  [[nodiscard]] std::string operator()(Amount so_far) const;

 private:
  std::uint64_t ticks_ = 0;  // seconds per unit of cost; 0: no clock
  bool shows_seconds_ = false;
};

/// "minutes", "hours", "seconds"; "" for none.
[[nodiscard]] std::string_view word_of(CostUnit unit);

}  // namespace changeover
