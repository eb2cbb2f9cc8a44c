// Internal: makes splits, of stretches or of shares, and gives their pairs to workers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/pairs/held_blocks.hpp"
#include "loadorder/shares/group_shares.hpp"

namespace changeover {

class SplitMaker {
 public:
  /// Cut so that loads are even, or numbers of steps or of new pairs where all steps are alike.
  /// @throws as split_order()
  static WorkerSplit stretches(LoadOrder order, std::uint64_t items, std::uint64_t room,
                               std::uint64_t workers, bool even_pairs);
  static WorkerSplit shares(GroupShares shares, std::uint64_t items, std::uint64_t room,
                            std::uint64_t workers);
  /// For two sets: as `other`, but one block per worker.
  static WorkerSplit blocks(HeldBlocks blocks, const WorkerSplit& other);
  /// The same steps, of which only these pairs are wanted, and no item that is in none of them.
  static WorkerSplit for_fewer_pairs(WorkerSplit split, const WantedPairs& wanted,
                                     const LoadBound& bound, const LoadBound& makespan_bound);

  /// Says who computes what, as far as that can be said without the steps of others, and leaves out
  /// what brings nothing.
  static void give_pairs(WorkerSplit& split, const LoadOrderOptions& options);
  /// The same one by one, as far as there are few: what was `computed` before, pairs or items with
  /// themselves, is left out. @throws BadInput if something was, and there are more than can be
  /// given one by one
  static void spread(WorkerSplit& split, const std::function<bool(Element, Element)>& computed = {},
                     const std::function<double(Element, Element)>& cost = {});
  /// Epochs of the shares, of one so far.
  static void repeat(WorkerSplit& split, std::uint64_t epochs);
  /// Reads all steps; of few items also what is computed. @throws InternalError
  static void verify(WorkerSplit& split, const LoadOrderOptions& options);

 private:
  static bool are_few(const WorkerSplit& split);
  static void leave_out_unneeded(WorkerSplit& split);
  static void put_in_words(WorkerSplit& split);
  static void take_steps(WorkerSplit& split, std::shared_ptr<const WorkerSteps> steps);
  static std::string certify(const GroupShares& shares);
};

}  // namespace changeover
