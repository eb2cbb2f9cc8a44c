// Internal: stretches of an order, of groups of items perhaps: one a worker, each beginning with
// what is in memory then.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/owners/group_owners.hpp"

namespace changeover {

/// Balanced pairs of groups, of stretches of so many steps each.
[[nodiscard]] std::shared_ptr<const GroupOwners> owners_of_stretches(
    const LoadOrder& order, const std::vector<WorkerFacts>& workers, std::uint64_t items);

/// What the steps of an order hold and load, in items; a transfer to an accelerator counts, too, if
/// it has a weight.
class StepSizes {
 public:
  StepSizes(const LoadOrder& order, std::uint64_t items, std::uint64_t load = 1,
            std::uint64_t transfer = 0);

  [[nodiscard]] std::uint64_t steps() const { return held_.size(); }
  /// The loads of a worker whose share begins with step `first`, counted from 0: what is in memory
  /// then, and all after it.
  [[nodiscard]] std::uint64_t loads(std::uint64_t first, std::uint64_t count) const {
    return held_[first] + loaded_[first + count] - loaded_[first + 1];
  }
  /// The number of steps of each share, of so many workers, whose largest has as few loads as can
  /// be: with contiguous shares, by bisection.
  [[nodiscard]] std::vector<std::uint64_t> best_shares(std::uint64_t workers) const;

 private:
  [[nodiscard]] std::uint64_t fitting(std::uint64_t first, std::uint64_t most) const;
  [[nodiscard]] std::vector<std::uint64_t> shares(std::uint64_t most) const;

  std::vector<std::uint64_t> held_;    // after each step
  std::vector<std::uint64_t> loaded_;  // before each step
};

}  // namespace changeover
