// Internal: assigns pairs to workers where shares are the lines of a plane: by coordinates, without
// a table of pairs of groups.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/groups/group_shares.hpp"
#include "loadorder/shares/groups/planes.hpp"

namespace changeover {

/// The pairs of two points belong to their line; those of one point belong to its lines in turn.
class PlaneOwners final : public PairOwners {
 public:
  PlaneOwners(Plane plane, std::uint64_t items);

  /// The number of pairs of each worker. O(items + points · q)
  [[nodiscard]] std::vector<std::uint64_t> pairs() const;

  [[nodiscard]] std::unique_ptr<const PairRule> of(std::uint64_t worker) const override;

  /// The worker that computes {x,y}, or x alone.
  [[nodiscard]] std::uint64_t owner(Element x, Element y) const;

 private:
  Plane plane_;
  ItemGroups groups_;
};

}  // namespace changeover
