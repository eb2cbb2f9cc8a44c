// Points of several orbits, and blocks of them as they are written in lists that searches found.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace changeover {

/// An element of Z × {0, …, g−1}, or a fixed point.
struct OrbitPoint {
  std::int64_t residue = 0;  ///< an integer; that it is taken modulo n comes later
  std::uint64_t orbit = 0;

  bool operator==(const OrbitPoint&) const = default;
};

using OrbitBlock = std::vector<OrbitPoint>;

/// "0a 2a 0b, -3a 0a 0b": "-3b" is the residue −3 of orbit 1; a comma ends a block.
[[nodiscard]] std::vector<OrbitBlock> orbit_blocks(std::string_view written);

}  // namespace changeover
