// Tables of designs: the range that a verb names, planned.
//
//     const TableRange range = table_range("3..6", "..30", {});
//     const Plan plan = planned(range);
//     for (const PlannedCell* cell : cells_of(plan, range, Kind::linear)) { … }
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/planner.hpp"
#include "request/range.hpp"

namespace changeover::cli {

struct TableRange {
  Range k;
  Range v;
  std::uint64_t change = 2;
};

/// As --k, --v and --change say it. @throws UsageError.
[[nodiscard]] TableRange table_range(const std::string& k, const std::string& v,
                                     std::optional<std::uint64_t> change);

/// The range and what is around it, planned: designs beyond the range help inside it.
[[nodiscard]] Plan planned(const TableRange& range);

/// The cells of one kind by k and v; the plan must live as long as they do.
[[nodiscard]] std::vector<const PlannedCell*> cells_of(const Plan& plan, const TableRange& range,
                                                       Kind kind);

}  // namespace changeover::cli
