// Where the parts of a run sheet are mounted: a part that stays keeps its place.
//
// A *place* of a bench holds one part at a time and, with slots, only parts of its slot. Its number
// is its name on every sheet, "slot_3" or "slot_3 disk". Parts that are mounted before the first
// test are where Job::places says; others at the start, and those that are put in, take a free
// place of their slot:
//   1. the place of what they replace, if costs depend on that (RunStep::replaced);
//   2. else the place where the part was last;
//   3. else one that was emptied in this step, else the first one.
// There are as many places of a slot as its parts are mounted at once at most, and those of
// Job::places. So one is always free.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// What is mounted, by place.
using MountedParts = std::vector<std::optional<Element>>;

struct PlacedSheet {
  MountedParts before;              ///< the first step
  std::vector<MountedParts> steps;  ///< after each
};

struct PlacedSheets {
  std::vector<MountedPlace>
      places;  ///< in the order of the slots, those of no slot last; without parts
  std::vector<PlacedSheet> sheets;

  /// "slot_3", with slots "slot_3 disk".
  [[nodiscard]] std::string head(const Job& job, std::size_t place) const;
};

/// The places of the parts of some sheets, which may be of several benches that have the same
/// places. O(parts + steps · places²).
/// @throws InternalError if place_faults() finds one.
[[nodiscard]] PlacedSheets placed(const Job& job, const std::vector<const RunSheet*>& sheets);
/// The same with a job for each sheet; these differ in what is mounted at the start, and where.
[[nodiscard]] PlacedSheets placed(const std::vector<const Job*>& jobs,
                                  const std::vector<const RunSheet*>& sheets);

/// What is wrong with them, a line each: the count that checks them, which shares nothing with what
/// made them. A set-up that is not mounted as it is, a place that holds a part of another slot, a
/// part that moves while it stays or while it waits for the first step where Job::places says.
[[nodiscard]] std::vector<std::string> place_faults(const Job& job,
                                                    const std::vector<const RunSheet*>& sheets,
                                                    const PlacedSheets& placed);

}  // namespace changeover
