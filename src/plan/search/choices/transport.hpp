// The most profitable flow from sources to drains.
#pragma once

#include <cstdint>
#include <vector>

namespace changeover {

/// The largest Σ profit[i][j]·x_ij with x_ij ≥ 0, Σ_j x_ij ≤ room[i] and Σ_i x_ij ≤ room[j]: twice
/// a fractional matching. By shortest augmenting paths. Stopped if the scope of this thread
/// (run/control.hpp) requests it: the flow so far is a lower bound. Saturates at 2⁶³ − 1.
[[nodiscard]] std::uint64_t most_profit(const std::vector<std::vector<std::uint64_t>>& profit,
                                        const std::vector<std::uint64_t>& room);

}  // namespace changeover
