#include "plan/search/anneal/same_everywhere.hpp"

#include <cmath>
#include <cstddef>

namespace changeover {
namespace {

// 2^(−i/256), rounded.
const std::array<double, 256>& root_table() {
  static const auto table = [] {
    std::array<double, 256> values{};
    constexpr double steps = 1 << 20;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] =
          std::round(std::exp2(-static_cast<double>(i) / static_cast<double>(values.size())) *
                     steps) /
          steps;
    }
    return values;
  }();
  return table;
}

}  // namespace

const std::array<double, 4096>& log_table() {
  static const auto table = [] {
    std::array<double, 4096> values{};
    constexpr double steps = 1 << 20;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
      values[i] = std::round(-std::log(u) * steps) / steps;
    }
    return values;
  }();
  return table;
}

double two_to_minus(double octaves) {
  const auto whole = static_cast<std::size_t>(octaves);
  const auto part = static_cast<std::size_t>((octaves - static_cast<double>(whole)) * 256.0);
  double value = root_table()[part];
  for (std::size_t i = 0; i < whole; ++i) {
    value *= 0.5;
  }
  return value;
}

}  // namespace changeover
