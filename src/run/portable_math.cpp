#include "run/portable_math.hpp"

#include <cmath>
#include <cstddef>

namespace changeover {
namespace {

constexpr double ln_2 = 0.693147180559945309417;

double rounded(double value) {
  constexpr double steps = 1 << 20;
  return std::round(value * steps) / steps;
}

// 2^(−i/256), rounded.
const std::array<double, 256>& root_table() {
  static const auto table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] =
          rounded(power_of_two(-static_cast<double>(i) / static_cast<double>(values.size())));
    }
    return values;
  }();
  return table;
}

}  // namespace

// x = 2^e·m with m near 1, and ln m = 2·artanh((m − 1)/(m + 1)).
double natural_log(double x) {
  constexpr double root_half = 0.70710678118654752440;
  constexpr int terms = 12;
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < root_half) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1);
  const double square = s * s;
  double sum = 0;
  for (int i = terms; i >= 0; --i) {
    sum = sum * square + 1.0 / (2 * i + 1);
  }
  return 2 * s * sum + exponent * ln_2;
}

// The whole part is exact; the rest is e^r with |r| ≤ ln 2 / 2.
double power_of_two(double x) {
  constexpr int terms = 18;
  const double whole = std::round(x);
  const double r = (x - whole) * ln_2;
  double sum = 1;
  for (int i = terms; i > 0; --i) {
    sum = 1 + sum * r / i;
  }
  return std::ldexp(sum, static_cast<int>(whole));
}

const std::array<double, 4096>& log_table() {
  static const auto table = [] {
    std::array<double, 4096> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = rounded(
          -natural_log((static_cast<double>(i) + 0.5) / static_cast<double>(values.size())));
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
