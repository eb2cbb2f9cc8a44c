// Which attempt of local search comes next.
//
// An arm is one kind of attempt; it aims at a number of blocks below the best so far, by `step` in
// its own units, and doubles its budget whenever it fails at the nearest aim. The arm of least cost
// comes next: moves spent and about to be spent, in the time that they take, times (1 + what the
// last attempt missed)².
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/parameters.hpp"
#include "changeover/search/checkpoint.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/segment_orbits.hpp"

namespace changeover {

/// What one attempt is to do.
struct Attempt {
  std::size_t arm = 0;
  std::uint64_t number = 0;   ///< of the attempt, from 0
  std::uint64_t aim = 0;      ///< blocks; base blocks of an imposed automorphism
  std::uint64_t promise = 0;  ///< blocks of the design that may come of it, at least
  std::uint64_t moves = 0;
  bool nearest = false;  ///< the aim is the nearest one
};

class SearchArms {
 public:
  /// Arms for p; `goal` blocks are enough.
  SearchArms(const Parameters& p, std::uint64_t goal, bool imposed, const WorkShare& share);

  [[nodiscard]] const std::vector<SearchArm>& arms() const { return arms_; }
  /// Takes the place of the arms, from a checkpoint.
  void restore(std::vector<SearchArm> arms) { arms_ = std::move(arms); }

  /// The next attempt to find a design of fewer than `best` blocks; nullopt if no arm has an aim.
  /// Its moves are taken for spent.
  [[nodiscard]] std::optional<Attempt> next(std::uint64_t best);

  /// Tells how an attempt ended: with `missed` uncovered, 0 if it succeeded. `improved`: a better
  /// design came of it.
  void report(const Attempt& attempt, std::uint64_t missed, bool improved);

  [[nodiscard]] Parameters parameters_of(const SearchArm& arm) const;

 private:
  // The number of blocks or base blocks that an arm is to try, the nearest to `best` first if step
  // is 1.
  [[nodiscard]] std::optional<std::uint64_t> aim(const SearchArm& arm, std::uint64_t best,
                                                 std::uint64_t step) const;

  Parameters parameters_;
  std::uint64_t goal_;
  std::uint64_t allowance_ = 0;  // blocks that a cut may save
  std::vector<SearchArm> arms_;
  std::vector<std::uint64_t> fewest_;  // base blocks of each arm, by counting
};

}  // namespace changeover
