#include "construct/tools/orbit_points.hpp"

namespace changeover {

std::vector<OrbitBlock> orbit_blocks(std::string_view written) {
  std::vector<OrbitBlock> blocks(1);
  bool negative = false;
  std::int64_t number = 0;
  for (const char c : written) {
    if (c == ',') {
      blocks.emplace_back();
    } else if (c == '-') {
      negative = true;
    } else if (c >= '0' && c <= '9') {
      number = 10 * number + (c - '0');
    } else if (c != ' ') {
      blocks.back().push_back({negative ? -number : number, static_cast<std::uint64_t>(c - 'a')});
      negative = false;
      number = 0;
    }
  }
  return blocks;
}

}  // namespace changeover
