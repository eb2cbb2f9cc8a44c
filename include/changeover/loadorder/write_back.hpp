// Items that change while they are held: what has to be stored, and when.
//
//     LoadOrder order = plan_load_order(24, 6);
//     StepWork work(24, 6);
//     work.start(order.stream());
//     WriteBack back(24);
//     StoreCheck check(24);
//     StoredStep stored;
//     while (work.next(stored.work)) {
//       back.read(stored);                       // now stored.store says what is stored
//       check.read({&stored, 1});
//     }
//     back.finish(stored);                       // a last step: all that is held goes
//     check.read({&stored, 1});
//     check.finish();                            // "": no change was lost, nothing stored in vain
//
// Computing a pair changes both of its items, computing an item alone changes it. What was changed is stored when it is evicted,
// before anything is loaded, and at the end. So an item is stored once for each *stay* in memory in which it is computed with.
//
// *The bound on stores* is that on loads: load_lower_bound(). For take any order with its pairs and leave out each stay in which
// nothing is computed with its item. All pairs are still computed with both items in memory, and every stay that is left has one
// load and one store. An item that belongs to no pair need not be stored, and counts for nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "changeover/loadorder/step_work.hpp"

namespace changeover {

/// A step, and which of the items that it evicts are stored.
struct StoredStep {
  WorkStep work;
  std::vector<Element> store;
};

/// Follows the steps of one worker.
class WriteBack {
 public:
  explicit WriteBack(std::uint64_t items)
      : held_(static_cast<std::size_t>(items), false), changed_(held_) {}

  /// Fills step.store: what step.work evicts and what was changed since it was loaded.
  void read(StoredStep& step);

  /// Makes the step after the last one, which evicts everything.
  void finish(StoredStep& step);

  [[nodiscard]] std::uint64_t stores() const { return stores_; }

 private:
  std::vector<bool> held_;
  std::vector<bool> changed_;
  std::uint64_t number_ = 0;
  std::uint64_t stores_ = 0;
};

/// Plays the steps of all workers with a number for each item: how often what is held, or on the disk, was changed. Trusts nothing
/// else, and does not ask which pairs are wanted or where memory ends (LoadCheck, WorkCheck, LockstepCheck do).
class StoreCheck {
 public:
  explicit StoreCheck(std::uint64_t items);

  /// A step of all workers: all store and evict, then all load, then all compute.
  void read(std::span<const StoredStep> steps);

  /// The first fault in one line: a change that was lost, an item that was stored without need or without being held, or what is
  /// still held at the end; empty if there is none.
  [[nodiscard]] std::string finish() const;

 private:
  static constexpr std::uint64_t absent = ~std::uint64_t{0};
  void fail(const StoredStep& step, const std::string& what);

  std::vector<std::uint64_t> changes_;    // by item: all
  std::vector<std::uint64_t> on_disk_;    // so many of them are on the disk
  std::vector<std::uint64_t> in_memory_;  // and in memory, or absent
  std::string fault_;
};

/// Stores that no order of these loads can go below, given the bound on loads; `alone` says that items are computed alone, too.
[[nodiscard]] LoadBound store_lower_bound(const LoadBound& loads, const WantedPairs& wanted,
                                          std::uint64_t items, bool alone);

}  // namespace changeover
