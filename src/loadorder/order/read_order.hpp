// Internal: an order is read before it is handed out.
#pragma once

#include <string>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// More loads are not read: that would take longer than a minute.
inline constexpr std::uint64_t most_loads_read = 200'000'000;

/// Where all pairs meet; of few items also what StepWork says is computed there, each pair once,
/// which costs more than all else. Orders that are read anew with their pairs when these are shown
/// need no more, and neither do those that ask not to `compute`. @throws InternalError if the steps
/// are wrong; `what` says whose.
[[nodiscard]] ScheduleVerdict read_order(const LoadOrder::Maker& maker, ScheduleRules rules,
                                         const std::string& what, bool compute = true);

/// What such a verdict says of all pairs: "6 pairs computed on the accelerator, each once".
[[nodiscard]] std::string pairs_read(const ScheduleVerdict& verdict, std::uint64_t all,
                                     const std::string& where = "");

}  // namespace changeover
