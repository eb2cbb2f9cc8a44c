// Local searches for a job: several annealings, over the threads that there are, with the same result for
// any number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/anneal.hpp"
#include "plan/search/starts.hpp"

namespace changeover {

inline constexpr const char* search_name = "local search";

class Attempts {
 public:
  Attempts(const Job& job, const CostBound& bound, RunControl& control)
      : job_(&job), bound_(&bound), control_(&control) {}

  /// Moves of an annealing that take some seconds at most for a list like this one.
  [[nodiscard]] std::uint64_t suitable_steps(const Candidate& like) const;

  /// A covering with few set-ups, found from this list, in a cheap order.
  [[nodiscard]] Start covering(const Candidate& from, std::uint64_t steps);

  /// The cheapest list found from `best` and from others; `best` itself if there is nothing cheaper.
  [[nodiscard]] Start cheaper_than(const Candidate& best, const std::vector<Candidate>& others,
                                   std::uint64_t steps, unsigned attempts, unsigned round);

  /// The list within the budget that tests most pairs, no fewer than `best`, which is within it.
  [[nodiscard]] Start within(Amount budget, const Candidate& best, std::uint64_t steps,
                             unsigned attempts);

  /// Moves so far.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  const Job* job_;
  const CostBound* bound_;
  RunControl* control_;
  std::atomic<std::uint64_t> steps_{0};
};

}  // namespace changeover
