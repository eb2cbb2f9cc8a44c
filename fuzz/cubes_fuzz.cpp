// Cubes: lists of literals, a byte each, between zero bytes. What is said of them is held to all
// assignments.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "changeover/proof/proof.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::cubes_fuzz {
namespace {

constexpr std::size_t most_variables_here = 12;
constexpr std::size_t most_literals_here = 400;

const Target target("cubes", [](const std::string& bytes) {
  std::vector<Cube> cubes(1);
  std::map<int, unsigned> number;  // by variable
  for (const char byte : bytes.substr(0, most_literals_here)) {
    if (byte == 0) {
      cubes.emplace_back();
      continue;
    }
    const int literal = static_cast<signed char>(byte);
    number.emplace(std::abs(literal), static_cast<unsigned>(number.size()));
    cubes.back().push_back(literal);
  }
  if (number.size() > most_variables_here) {
    return;
  }
  bool covers = false;
  if (!accepts([&] { covers = cubes_cover_everything(cubes); })) {
    return;
  }
  bool all = true;
  for (std::uint64_t values = 0; all && values < std::uint64_t{1} << number.size(); ++values) {
    all = std::ranges::any_of(cubes, [&](const Cube& cube) {
      return std::ranges::all_of(cube, [&](int literal) {
        return ((values >> number[std::abs(literal)]) & 1U) == (literal > 0 ? 1U : 0U);
      });
    });
  }
  must(covers == all, "cubes cover what they cover");
});

}  // namespace
}  // namespace changeover::fuzz::cubes_fuzz
