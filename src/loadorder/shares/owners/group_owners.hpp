// Internal: assigns pairs to workers, where items are in groups: evenly, by counting pairs of
// groups.
//
//     GroupOwners owners({1024, 16}, 16);
//     owners.add(3, 0, 5, 1);   // worker 3 has the groups 0 and 5 together, by its first step
//     owners.balance();
//     owners.pairs()[3];                   // number of pairs of items that it computes
//
// The pairs of two groups are a rectangle, those of one group a triangle. It is cut, in the order
// of its cells, among the workers that have these groups, so that all workers get the same number
// of pairs as far as possible.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/groups/group_shares.hpp"

namespace changeover {

class GroupOwners final : public PairOwners {
 public:
  GroupOwners(const ItemGroups& groups, std::uint64_t workers);

  /// The worker has both groups together (or one with itself) for the first time in this step; step
  /// 0 if they are together only once. Call it once for each worker and pair of groups.
  void add(std::uint64_t worker, Element group, Element other, std::uint64_t step);

  /// Call it when all are added; `part` as in Pouring::pour().
  void balance(double part = 1e-5);

  /// The number of pairs of each worker.
  [[nodiscard]] const std::vector<std::uint64_t>& pairs() const { return pairs_; }

  /// Calls visit(worker, pairs) for all workers that compute pairs of these groups.
  template <typename Visit>
  void each_part(Element group, Element other, Visit&& visit) const {
    std::uint64_t before = 0;
    for (std::uint64_t p = begin_of(group, other); p < begin_of(group, other, 1); ++p) {
      if (parts_[p].end > before) {
        visit(parts_[p].worker, parts_[p].end - before);
      }
      before = parts_[p].end;
    }
  }

  /// The number of pairs of groups that have pairs of items and no worker.
  [[nodiscard]] std::uint64_t missing() const { return missing_; }

  [[nodiscard]] std::unique_ptr<const PairRule> of(std::uint64_t worker) const override;

  [[nodiscard]] bool computes(std::uint64_t worker, std::uint64_t step, Element x, Element y) const;

 private:
  [[nodiscard]] std::uint64_t begin_of(Element group, Element other, std::size_t next = 0) const;

  struct Part {
    std::uint64_t step = 0;
    std::uint64_t end = 0;  // of its cells
    std::uint32_t worker = 0;
  };
  struct Added {
    std::uint64_t place = 0;
    std::uint64_t step = 0;
    std::uint32_t worker = 0;
  };

  ItemGroups groups_;
  std::vector<Added> added_;          // until they are balanced
  std::vector<std::uint64_t> begin_;  // first part of each pair of groups
  std::vector<Part> parts_;
  std::vector<std::uint64_t> pairs_;
  std::vector<std::uint32_t> group_of_;
  std::uint64_t missing_ = 0;
};

/// Owners of the pairs of groups that meet at workers with these shares, balanced.
[[nodiscard]] std::shared_ptr<const GroupOwners> owners_of(const GroupShares& shares,
                                                           std::uint64_t items, double part = 1e-5);

}  // namespace changeover
