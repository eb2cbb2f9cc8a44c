// Internal: how an order is searched for, for every door.
//
//     RunControl control({.threads = 2});
//     const LoadOrder order = plan_load_order(20, 5, searched(30, 1, control));
#pragma once

#include <cstdint>
#include <functional>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// Calls a search with a control that has the time of the request.
using Searching = std::function<void(const std::function<void(RunControl&)>& search)>;

/// Options of an order that is searched for. Each search has `seconds` from its beginning. With 0
/// there is no search, but what is stopped ends with the best so far.
[[nodiscard]] LoadOrderOptions searched(double seconds, std::uint64_t seed,
                                        const Searching& searching);

/// The same with searches that are parts of the work of this control, which must outlive them.
[[nodiscard]] LoadOrderOptions searched(double seconds, std::uint64_t seed, RunControl& control);

}  // namespace changeover
