// Local searches for a job: several annealing runs on all threads, with the same result for any
// number of threads.
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

  /// Whether lists are so short that many annealing runs, most of them from the best so far, find
  /// more than a long one.
  [[nodiscard]] bool are_short(const Candidate& like) const;

  /// Moves of a first annealing run of a list like this: about a second for some hundred places,
  /// ten for some thousand.
  [[nodiscard]] std::uint64_t suitable_steps(const Candidate& like) const;

  /// Moves that an annealing run on one thread makes in this time, based on those so far.
  [[nodiscard]] std::uint64_t steps_until(std::chrono::duration<double> left) const;

  /// A covering with few set-ups, found from this list, in a cheap order; nullopt if a small part
  /// of the remaining time is too short for such a list.
  [[nodiscard]] std::optional<Start> covering(const Candidate& from, std::uint64_t steps);

  /// The cheapest list found from `best` and from others; `best` itself if none is cheaper.
  [[nodiscard]] Start cheaper_than(const Candidate& best, const std::vector<Candidate>& others,
                                   std::uint64_t steps, unsigned attempts, unsigned round);

  /// The list within the budget that tests most pairs, at least as many as `best`, which is within
  /// it.
  [[nodiscard]] Start within(Amount budget, const Candidate& best, std::uint64_t steps,
                             unsigned attempts);

  /// The number of moves so far.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }

 private:
  const Job* job_;
  const CostBound* bound_;
  RunControl* control_;
  std::atomic<std::uint64_t> steps_{0};
  std::uint64_t annealed_ = 0;  // moves of the timed runs
  double busy_ = 0;             // seconds of these runs, each on its thread
};

}  // namespace changeover
