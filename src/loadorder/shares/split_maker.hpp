// Internal: makes splits, from stretches or shares, and assigns their pairs to workers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/pairs/held/held_blocks.hpp"
#include "loadorder/shares/groups/group_shares.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

class SplitMaker {
 public:
  /// Cut so that loads are even, or numbers of steps or of new pairs where all steps are alike.
  /// Needs an order of at most so many items, not in lockstep (split_order() checks that).
  static WorkerSplit stretches(LoadOrder order, std::uint64_t items, std::uint64_t room,
                               std::uint64_t workers, bool even_pairs = false);
  static WorkerSplit shares(GroupShares shares, std::uint64_t items, std::uint64_t room,
                            std::uint64_t workers);
  /// For two sets: like `other`, but one block per worker.
  static WorkerSplit blocks(HeldBlocks blocks, const WorkerSplit& other);
  /// Like `other`, but with these steps of each worker.
  static WorkerSplit lists(const WorkerSplit& other, const std::vector<std::vector<Move>>& moves,
                           const std::string& method, const std::string& explanation);
  /// The same steps for these wanted pairs only, without items that are in none of them.
  static WorkerSplit for_fewer_pairs(WorkerSplit split, const WantedPairs& wanted,
                                     const LoadBound& bound, const LoadBound& makespan_bound);

  /// Assigns pairs to workers, as far as that is possible without the steps of other workers, and
  /// leaves out needless loads.
  static void give_pairs(WorkerSplit& split, const LoadOrderOptions& options);
  /// The same, pair by pair, if there are few; pairs or items that were `computed` before are left
  /// out. @throws BadInput if some were, and there are too many pairs for that
  static void spread(WorkerSplit& split, const std::function<bool(Element, Element)>& computed = {},
                     const std::function<double(Element, Element)>& cost = {},
                     bool first_holder = false);
  /// The steps of each worker, made of the pairs that it computes; (x,x) for an item in no pair.
  using OwnOrder = std::function<std::vector<std::vector<Move>>(
      const std::vector<std::vector<ItemPair>>& pairs)>;
  /// Gives each worker its own order for the pairs that it computes.
  static void own_orders(WorkerSplit& split, const OwnOrder& make);
  /// Two levels: each worker has the pairs of a split of one level, with its own order for
  /// them. `levels` has both rooms, or sizes, and the bounds.
  static WorkerSplit two_levels(WorkerSplit split, const LoadOrderFacts& levels,
                                const LoadOrderOptions& options);
  /// Two levels: loads start as early as memory has room.
  static void start_early(WorkerSplit& split);
  /// Repeats the shares of one epoch.
  static void repeat(WorkerSplit& split, std::uint64_t epochs);
  /// Reads all steps; for few items also what is computed. @throws InternalError
  static void verify(WorkerSplit& split, const LoadOrderOptions& options);

 private:
  static bool are_few(const WorkerSplit& split);
  static void leave_out_unneeded(WorkerSplit& split);
  static void weigh(WorkerSplit& split);
  static void put_in_words(WorkerSplit& split);
  static void take_steps(WorkerSplit& split, std::shared_ptr<const WorkerSteps> steps);
  static std::string certify(const GroupShares& shares);
};

}  // namespace changeover
