// Local searches for a job: several annealings, over the threads that there are, with the same
// result for any number of threads.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/anneal/anneal.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

inline constexpr const char* search_name = "local search";

class Attempts {
 public:
  Attempts(const Job& job, const CostBound& bound, RunControl& control)
      : job_(&job), bound_(&bound), control_(&control) {}

  /// Whether lists are so short that many annealings, most of them from the best so far, find more
  /// than a long one.
  [[nodiscard]] bool are_short(const Candidate& like) const;

  /// Moves of a first annealing of a list like this one: a second for some hundred places, ten for
  /// some thousand.
  [[nodiscard]] std::uint64_t suitable_steps(const Candidate& like) const;

  /// Moves that an annealing on one thread makes in this time, going by those so far.
  [[nodiscard]] std::uint64_t steps_until(std::chrono::duration<double> left) const;

  /// A covering with few set-ups, found from this list, in a cheap order; nothing if a small share
  /// of the time that is left is too short for a list like this.
  [[nodiscard]] std::optional<Start> covering(const Candidate& from, std::uint64_t steps);

  /// The cheapest list found from `best` and from others; `best` itself if there is nothing
  /// cheaper.
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
  std::uint64_t annealed_ = 0;  // moves of those that were timed
  double busy_ = 0;             // seconds that they took, each on its thread
};

}  // namespace changeover
