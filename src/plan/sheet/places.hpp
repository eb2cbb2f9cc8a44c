// The places of the parts of a run sheet: a part that stays keeps its place.
//
// A *place* of a bench holds one part at a time and, with slots, only parts of its slot. Its number
// is its name on every sheet, "slot_3" or "slot_3 disk". Parts that are mounted before the first
// test are where Job::places says; other parts of the start, and parts that are put in, take a free
// place of their slot:
//   1. the place of the part that they replace, if costs depend on that (RunStep::replaced);
//   2. otherwise the place where the part was last;
//   3. otherwise one that was emptied in this step, or the first free one.
//
// A slot has as many places as parts of it are ever mounted at a time, and those of Job::places. So
// one is always free.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The mounted part of each place.
using MountedParts = std::vector<std::optional<Element>>;

struct PlacedSheet {
  MountedParts before;              ///< before the first step
  std::vector<MountedParts> steps;  ///< after each step
};

struct PlacedSheets {
  std::vector<MountedPlace>
      places;  ///< in the order of the slots, those of no slot last; without parts
  std::vector<PlacedSheet> sheets;

  /// "slot_3", with slots "slot_3 disk".
  [[nodiscard]] std::string head(const Job& job, std::size_t place) const;
};

/// The places of the parts of some sheets, which may be of several benches with the same places.
/// O(parts + steps · places²). @throws InternalError if place_faults() finds a fault.
[[nodiscard]] PlacedSheets placed(const Job& job, const std::vector<const RunSheet*>& sheets);
/// The same with a job for each sheet; the jobs differ in the start and its places.
[[nodiscard]] PlacedSheets placed(const std::vector<const Job*>& jobs,
                                  const std::vector<const RunSheet*>& sheets);

/// The faults of places, one per line: an independent check, which shares no code with placed().
/// Faults: parts mounted that differ from the set-up, a place with a part of another slot, a part
/// that moves while it stays, or before the first step although Job::places gives its place.
[[nodiscard]] std::vector<std::string> place_faults(const Job& job,
                                                    const std::vector<const RunSheet*>& sheets,
                                                    const PlacedSheets& placed);

}  // namespace changeover
