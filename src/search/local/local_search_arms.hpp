// Chooses the next attempt of local search.
//
// An arm is one kind of attempt. It aims at a number of blocks below the best so far, by `step` in
// its own units, and doubles its budget whenever it fails at the nearest aim. The arm of least cost
// comes next. The cost is the time for the moves made so far and those of the next attempt, times
// (1 + the number missed by the last attempt)². An arm is left out while its counters would take
// more memory than an attempt may.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "search/local/anneal.hpp"
#include "search/local/checkpoint.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

/// The task of one attempt.
struct Attempt {
  std::size_t arm = 0;
  std::uint64_t number = 0;   ///< of the attempt, from 0
  std::uint64_t aim = 0;      ///< blocks; base blocks of an imposed automorphism
  std::uint64_t promise = 0;  ///< the most blocks of a design from a successful attempt
  std::uint64_t moves = 0;
  bool nearest = false;  ///< the aim is the nearest one
};

class SearchArms {
 public:
  struct Kinds {
    bool imposed = true;  ///< automorphisms
    bool opened = false;  ///< a circular design is known for a linear one
  };

  /// Arms for p; `goal` blocks are enough. `bytes` limits the memory of an attempt; nullopt: no
  /// limit.
  SearchArms(const Parameters& p, std::uint64_t goal, const Kinds& kinds, const WorkShare& share,
             std::optional<std::uint64_t> most_bytes = {});

  [[nodiscard]] const std::vector<SearchArm>& arms() const { return arms_; }
  /// Continues with the costs and results of arms of the same kinds from a checkpoint.
  void restore(const std::vector<SearchArm>& arms);

  /// Leaves out an arm for which memory was too small.
  void leave_out(std::size_t arm) { no_memory_[arm] = true; }

  /// If arms with an aim are left out, the least memory that one of them needs; 0 if none is.
  [[nodiscard]] std::uint64_t bytes_left_out(std::uint64_t best) const;

  /// The next attempt to find a design of fewer than `best` blocks; nullopt if no arm has an aim.
  /// Its moves count as made.
  [[nodiscard]] std::optional<Attempt> next(std::uint64_t best);

  /// Reports the end of an attempt: the number of things missed, 0 if it succeeded, and whether it
  /// gave a better design (`improved`).
  void report(const Attempt& attempt, std::uint64_t missed, bool improved);

  [[nodiscard]] Parameters parameters_of(const SearchArm& arm) const;

 private:
  // The number of blocks or base blocks that an arm tries next; the nearest to `best` if step is 1.
  [[nodiscard]] std::optional<std::uint64_t> aim(const SearchArm& arm, std::uint64_t best,
                                                 std::uint64_t step) const;

  [[nodiscard]] std::uint64_t bytes(const SearchArm& arm, std::uint64_t aim) const;
  [[nodiscard]] bool is_left_out(std::size_t arm, std::uint64_t aim) const {
    return no_memory_[arm] || (most_bytes_ && bytes(arms_[arm], aim) > *most_bytes_);
  }

  Parameters parameters_;
  std::uint64_t goal_;
  std::optional<std::uint64_t> most_bytes_;
  std::uint64_t allowance_ = 0;  // number of blocks that a cut may save
  std::vector<SearchArm> arms_;
  std::vector<std::uint64_t> fewest_;  // base blocks of each arm, by counting
  std::vector<bool> no_memory_;        // by arm
};

// Anneals a list of blocks with counters of the right type.

struct Annealed {
  std::optional<Design> design;   ///< if nothing is missing; not verified
  std::vector<LockedPart> parts;  ///< where they are in it
  AnnealOutcome outcome;
};

/// The memory for annealing so many blocks, at most; the largest number if that exceeds 64 bits.
[[nodiscard]] std::uint64_t annealing_bytes(const Parameters& p, std::uint64_t blocks);

/// Anneals all blocks but the first `frozen`; what is locked stays (strength 2).
/// While it starts, the scope of this thread can stop it. @throws MissingResource if the counters
/// would need more memory than `control` allows.
[[nodiscard]] Annealed anneal_blocks(const Design& start, std::size_t frozen,
                                     const AnnealSchedule& schedule, Random& random,
                                     RunControl& control, const AnnealWatch& watch = {},
                                     const Locks& locks = {});

}  // namespace changeover
