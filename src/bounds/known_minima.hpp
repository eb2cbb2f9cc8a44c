// Bounds from checked proofs that exceed every formula here.
#pragma once

#include <cstdint>
#include <optional>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// The number of blocks below which there is no design with exactly these parameters, if it is in
/// the table. Most of these are the minimum.
[[nodiscard]] std::optional<std::uint64_t> excluded_below(const Parameters& p);

}  // namespace changeover
