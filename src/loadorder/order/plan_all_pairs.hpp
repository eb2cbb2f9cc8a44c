// Internal: orders for all pairs, on which those for some are built.
#pragma once

#include <cstdint>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// The best that is known, as plan_load_order(). @throws as it
[[nodiscard]] LoadOrder plan_all_pairs(std::uint64_t items, std::uint64_t room,
                                       const LoadOrderOptions& options);

}  // namespace changeover
