// Parts come a whole number of times: what splits the program of Theorem 18 into two.
#include <algorithm>
#include <cmath>
#include <limits>

#include "plan/search/bounds/step_program.hpp"

namespace changeover {

std::optional<StepProgram::Broken> StepProgram::broken() const {
  constexpr double whole_enough = 1e-3;
  std::optional<Broken> found;
  double most = 0;
  const auto look_at = [&](std::vector<std::size_t> parts) {
    double all = 0;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (const std::size_t x : parts) {
      all += times(x);
      least = std::min(least, costs_[x]);
    }
    const double beyond = all - std::floor(all);
    const double off = std::min(beyond, 1 - beyond);
    if (off > whole_enough && off * static_cast<double>(least) > most) {
      most = off * static_cast<double>(least);
      found = Broken{std::move(parts), all};
    }
  };
  if (counted_.groups().size() == 1) {
    return std::nullopt;  // where all parts are one group, that proves next to nothing more
  }
  for (const PartGroup& group : counted_.groups()) {
    look_at(group.parts);
  }
  const bool whole_groups = !found;
  for (std::size_t x = 0; x < v_ && whole_groups; ++x) {
    look_at({x});
  }
  return found;
}

void StepProgram::come_at_most(const std::vector<std::size_t>& parts, std::uint64_t times) {
  LeastSum::Row row;
  for (const std::size_t x : parts) {
    row.push_back({x, -1});
  }
  add(std::move(row), -static_cast<std::int64_t>(times));
}

void StepProgram::come_at_least(const std::vector<std::size_t>& parts, std::uint64_t times) {
  LeastSum::Row row;
  for (const std::size_t x : parts) {
    row.push_back({x, 1});
  }
  add(std::move(row), static_cast<std::int64_t>(times));
}

}  // namespace changeover
