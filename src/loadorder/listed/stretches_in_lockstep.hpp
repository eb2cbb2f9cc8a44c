// Internal: an order of one worker, cut into stretches for workers that never hold one item twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/listed/lockstep_events.hpp"
#include "loadorder/pairs/closing.hpp"

namespace changeover {

/// What an order does, job by job: a job is the pairs that meet with one load. A worker has
/// consecutive jobs. It loads what its next job lacks, keeps an item from one job that needs it to
/// the next as the order does, and waits for an item that another worker holds.
class StretchesInLockstep {
 public:
  StretchesInLockstep(const PairGraph& graph, const std::vector<LoadMove>& moves);
  StretchesInLockstep(const PairGraph& graph, const std::vector<Move>& moves);

  [[nodiscard]] std::size_t jobs() const { return jobs_.size(); }

  /// The first jobs of workers that have about equally many.
  [[nodiscard]] std::vector<std::size_t> even_cut(std::uint64_t workers) const;

  /// Plays the workers, whose first jobs are `begins`; the first of these is 0. An item that
  /// another worker needs is taken from one that has more than `patience` jobs to do before it
  /// needs it again, or if no worker could go on; that one loads it again. Nullopt if it takes more
  /// than `most_steps`. O(loads · workers)
  [[nodiscard]] std::optional<LockstepEvents> play(const std::vector<std::size_t>& begins,
                                                   std::size_t patience,
                                                   std::uint64_t most_steps) const;
  /// The same for several patiences; calls visit() for each that does not take too long.
  void play_each(const std::vector<std::size_t>& begins, std::uint64_t most_steps,
                 const std::function<void(LockstepEvents)>& visit) const;

 private:
  struct Stay {
    Element item = 0;
    std::vector<std::size_t> jobs;  // that need it
  };
  class Play;

  std::size_t items_;
  std::vector<Stay> stays_;
  std::vector<std::vector<std::size_t>> jobs_;  // the stays that each needs
};

}  // namespace changeover
