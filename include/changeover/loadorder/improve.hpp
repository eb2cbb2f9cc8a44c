// Local search as what improves load orders.
//
//     RunControl control({.time = std::chrono::seconds(60)});
//     LoadOrderOptions options;
//     options.improve = improve_by_search(control);
//     LoadOrder order = plan_load_order(37, 9, options);     // 93 loads or fewer after a few seconds
//
// See search/local_search.hpp for what it does with the time.
#pragma once

#include <functional>
#include <optional>

#include "changeover/core/design.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// For LoadOrderOptions::improve. The control must outlive what is returned; a search that it has
/// stopped before is not begun.
[[nodiscard]] std::function<std::optional<Design>(const Design& start, std::uint64_t least_blocks)>
improve_by_search(RunControl& control);

}  // namespace changeover
