#include "changeover/proof/proof.hpp"

#include <algorithm>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// The cubes that agree with `literal`, without it.
std::vector<Cube> within(const std::vector<Cube>& cubes, std::int32_t literal) {
  std::vector<Cube> rest;
  for (const Cube& cube : cubes) {
    if (std::find(cube.begin(), cube.end(), -literal) != cube.end()) {
      continue;
    }
    Cube& shorter = rest.emplace_back();
    std::copy_if(cube.begin(), cube.end(), std::back_inserter(shorter),
                 [&](std::int32_t other) { return other != literal; });
  }
  return rest;
}

bool cover(const std::vector<Cube>& cubes) {
  const auto shortest = std::min_element(
      cubes.begin(), cubes.end(), [](const Cube& a, const Cube& b) { return a.size() < b.size(); });
  if (shortest == cubes.end() || shortest->empty()) {
    return shortest != cubes.end();
  }
  const std::int32_t literal = shortest->front();
  return cover(within(cubes, literal)) && cover(within(cubes, -literal));
}

}  // namespace

bool cubes_cover_everything(const std::vector<Cube>& cubes) {
  for (const Cube& cube : cubes) {
    for (const std::int32_t literal : cube) {
      if (literal == 0 || std::find(cube.begin(), cube.end(), -literal) != cube.end()) {
        throw BadInput("a cube has the literal 0 or both a literal and its negation");
      }
    }
  }
  return cover(cubes);
}

}  // namespace changeover
