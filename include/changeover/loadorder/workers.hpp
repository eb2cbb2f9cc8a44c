// A load order for several workers, each with room of its own.
//
//     WorkerSplit split = split_load_order(64, 16, 4);
//     split.facts().makespan;                  // loads of the busiest worker
//     for (std::uint64_t w = 0; w < 4; ++w) {
//       auto steps = split.stream(w);          // its steps, numbered from 1; the first loads a full memory
//     }
//
// *How.* An order is cut into W stretches of equally many steps; each worker begins by loading what
// is in memory at its first step. A stretch costs what its steps load and C − (what its first step
// loads) more, so the makespan is about L/W + C. The items of that order may be groups of items: P
// items in G groups, room for C·G/P groups. For many workers and little room for saving, small
// first memories pay: all G and all rooms up to C are compared by makespan, then by all loads.
//
// *The bound on the makespan.* A worker that loads ℓ items brings at most C(ℓ,2) pairs together if
// ℓ ≤ C, and C(C,2) + (ℓ−C)(C−1) otherwise. W workers with at most ℓ loads bring all C(P,2)
// together only if W times that is enough, and all items are loaded somewhere: ℓ ≥ ⌈P/W⌉. And
// whatever several workers load, end to end, is a list of sets in which all pairs meet: W·ℓ ≥
// (s+1)P − (s²−s+1)C for every s [docs/theorems.md, Theorem 5].
//
// *Verified.* For P ≤ 65,535 all workers' steps are read, and the pairs that met with any of them
// are all pairs. Above that the stretches are those of an order that is certified by its structure.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// No split is for more.
inline constexpr std::uint64_t most_workers = 65'536;

/// What one worker does.
struct WorkerFacts {
  std::uint64_t first_step = 0;  ///< of the common order, from 1; 0 if the worker has nothing to do
  std::uint64_t steps = 0;
  std::uint64_t loads = 0;
};

struct SplitFacts {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t groups = 0;      ///< G; equal to items if they are not grouped
  std::uint64_t group_room = 0;  ///< groups that are in memory at once
  std::uint64_t loads = 0;       ///< of all workers
  std::uint64_t makespan = 0;    ///< of the busiest one
  std::uint64_t transfers = 0;   ///< to the accelerators of all workers, of two levels
  LoadBound makespan_bound;      ///< no split has a smaller makespan
  std::string explanation;       ///< how the common order is made; says so if it is one of groups
  std::string
      certificate;  ///< one line: how it was verified; counts pairs of items, or says of what
  bool cut_by_loads = false;  ///< shares have even loads; otherwise even numbers of steps
  std::vector<WorkerFacts> workers;
};

class OrderRelay;

class WorkerSplit {
 public:
  [[nodiscard]] const SplitFacts& facts() const { return facts_; }

  /// The order of groups that was cut.
  [[nodiscard]] const LoadOrder& order() const { return order_; }

  /// The steps of a worker, 0 ≤ worker < W. Steps of the order before its own are skipped by
  /// reading them, once for all workers if these are read in their order, each stream to its end.
  /// @throws BadInput if there is no such worker.
  [[nodiscard]] std::unique_ptr<StepSource> stream(std::uint64_t worker) const;

  /// The steps of all workers, one worker after another. It may not outlive this.
  [[nodiscard]] std::unique_ptr<StepSource> stream() const;

 private:
  friend WorkerSplit split_order(LoadOrder, std::uint64_t, std::uint64_t, std::uint64_t);
  friend WorkerSplit split_load_order(std::uint64_t, std::uint64_t, std::uint64_t,
                                      const LoadOrderOptions&);
  friend WorkerSplit split_load_order(const WantedPairs&, std::uint64_t, std::uint64_t,
                                      const LoadOrderOptions&);
  friend WorkerSplit split_two_levels(std::uint64_t, std::uint64_t, std::uint64_t, std::uint64_t);
  WorkerSplit(SplitFacts facts, LoadOrder order);

  SplitFacts facts_;
  LoadOrder order_;
  std::shared_ptr<OrderRelay> relay_;
};

/// The makespan that no split goes below. @throws as load_lower_bound(), BadInput if workers = 0.
[[nodiscard]] LoadBound makespan_lower_bound(std::uint64_t items, std::uint64_t room,
                                             std::uint64_t workers);

[[nodiscard]] LoadBound makespan_lower_bound(const WantedPairs& wanted, std::uint64_t room,
                                             std::uint64_t workers);

/// Cuts an order of `groups` things into stretches for P items in as many groups, of ⌊P/G⌋ or ⌈P/G⌉
/// items with consecutive numbers. Nothing is verified. @throws BadInput if workers = 0 or exceeds
/// 65,536, or if there are more groups than items.
[[nodiscard]] WorkerSplit split_order(LoadOrder order, std::uint64_t items, std::uint64_t room,
                                      std::uint64_t workers);

/// The best split that is known, verified. @throws as plan_load_order() and split_order().
[[nodiscard]] WorkerSplit split_load_order(std::uint64_t items, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// An order for two levels (loadorder/two_levels.hpp) in stretches, each worker with memory and an
/// accelerator of its own: what both levels of the busiest worker move is as little as stretches
/// allow. Verified. @throws as plan_two_levels() and split_order().
[[nodiscard]] WorkerSplit split_two_levels(std::uint64_t items, std::uint64_t room,
                                           std::uint64_t fast_room, std::uint64_t workers);

/// The same for some pairs, whose items are not grouped. Two sets may be cut instead: then each
/// worker has a part of one with a part of the other.
[[nodiscard]] WorkerSplit split_load_order(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

}  // namespace changeover
