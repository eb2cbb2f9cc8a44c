// A clock that runs along with a sheet whose costs are times.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "changeover/plan/job.hpp"

namespace changeover {

/// How long tests and changes of a job take together: "1:35" for an hour and 35 minutes, "1:35:20"
/// if some cost is not whole minutes.
class Clock {
 public:
  explicit Clock(const Job& job);

  /// The costs are times.
  [[nodiscard]] bool runs() const { return ticks_ > 0; }
  /// What is no whole tick is rounded up, so that a step is over when its clock says so.
  [[nodiscard]] std::string operator()(Amount so_far) const;

 private:
  std::uint64_t ticks_ = 0;  // seconds in a unit of the costs; 0: it stands still
  bool shows_seconds_ = false;
};

/// "minutes", "hours", "seconds"; "" for none.
[[nodiscard]] std::string_view word_of(CostUnit unit);

}  // namespace changeover
