// Sets of at most 64 elements as words.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace changeover {

using Mask = std::uint64_t;

/// The set of x alone, below 64.
inline Mask bit(std::size_t x) { return Mask{1} << x; }
/// The least element; 64 of the empty set.
inline std::size_t lowest(Mask mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }
/// The number of elements.
inline std::size_t count(Mask mask) { return static_cast<std::size_t>(std::popcount(mask)); }

}  // namespace changeover
