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

#include "changeover/plan/benches.hpp"

namespace changeover {

/// The mounted part of each place.
using MountedParts = std::vector<std::optional<Element>>;

/// A run sheet, the job as it is on its bench, and what else is shown of it; all must outlive it.
struct ShownSheet {
  const Job* job = nullptr;
  const RunSheet* sheet = nullptr;
  std::string bench = {};                        ///< its name; empty: there is only one
  const std::vector<StepTime>* times = nullptr;  ///< of the steps; null: sums of costs
  /// Lines on parts that go to another bench or come from one, by step; null: the table has none.
  const std::vector<std::vector<std::string>>* hand_over = nullptr;
};

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

/// The places of the parts of some sheets, which may be of several benches with the same places:
/// their jobs differ in the start and its places. O(parts + steps · places²). @throws InternalError
/// if place_faults() finds a fault.
[[nodiscard]] PlacedSheets placed(const std::vector<ShownSheet>& sheets);

/// The faults of places, one per line: an independent check, which shares no code with placed().
/// Faults: parts mounted that differ from the set-up, a place with a part of another slot, a part
/// that moves while it stays, or before the first step although Job::places gives its place.
[[nodiscard]] std::vector<std::string> place_faults(const std::vector<ShownSheet>& sheets,
                                                    const PlacedSheets& placed);

}  // namespace changeover
