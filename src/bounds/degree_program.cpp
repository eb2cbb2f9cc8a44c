#include "bounds/degree_program.hpp"

#include <algorithm>
#include <vector>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

using Number = std::int64_t;

Number ceil_div_signed(Number a, Number b) { return a >= 0 ? (a + b - 1) / b : -(-a / b); }

using Counts = std::vector<Number>;

struct Program {
  Number n = 0;  // elements that are not in every block
  Number i_sum = 0;
  Number r_sum = 0;
  Number r_most = 0;  // r_x ≤ r_most − i_x
  Number degree = 0;  // i_x(k−1) + m(r_x − i_x) ≥ degree
  Number k = 0;
  Number m = 0;
  Number fixed = 0;  // elements that are in every block
  Number cut =
      0;  // stays that cutting a circular design open adds, but for those of fixed elements

  [[nodiscard]] Number least_r(Number i) const {
    return std::max(i, ceil_div_signed(degree - i * (k - 1 - m), m));
  }
  [[nodiscard]] bool allowed(Number i) const { return i >= 1 && least_r(i) <= r_most - i; }

  /// Whether the inequality of stays holds for every s, with counts[j] elements of i_x = low + j.
  [[nodiscard]] bool stays_fit(Number low, const Counts& counts) const {
    const auto values = static_cast<Number>(counts.size());
    // Beyond these s every element counts, and the left side grows more slowly than the right one.
    const Number last = std::max(low + values, (n + fixed) / (2 * k) + 1);
    for (Number s = 1; s <= last; ++s) {
      Number sum = fixed * s - cut;
      for (Number j = 0; j < values; ++j) {
        sum += counts[static_cast<std::size_t>(j)] * std::max<Number>(0, s + 1 - low - j);
      }
      if (sum > (s * s - s + 1) * k) {
        return false;
      }
    }
    return true;
  }

  /// Whether `left` elements can have the values low + j, …, low + m with Σ i_x = sum and Σ
  /// r_x ≤ r, where counts[0], …, counts[j−1] elements have the lower values.
  [[nodiscard]] bool possible(Number low, Number j, Number left, Number sum, Number r,
                              Counts& counts) const {
    const Number i = low + j;
    if (r < 0 || sum < i * left || sum > (low + m) * left) {
      return false;
    }
    Number least = 0;
    Number most = left;
    if (j == m) {
      least = left;
    } else if (j + 1 == m) {  // two unknowns, two equations
      least = most = left - (sum - i * left);
    }
    if (!allowed(i)) {
      most = 0;
    }
    for (Number count = least; count <= most; ++count) {
      if (j + 2 < m) {
        stop_if_asked();
      }
      counts[static_cast<std::size_t>(j)] = count;
      if (j == m) {
        return count * least_r(i) <= r && stays_fit(low, counts);
      }
      if (possible(low, j + 1, left - count, sum - count * i, r - count * least_r(i), counts)) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool feasible() const {
    if (i_sum < n || r_sum > n * r_most - i_sum) {
      return false;
    }
    const Number middle = i_sum / n;
    for (Number low = std::max<Number>(1, middle - m); low <= middle; ++low) {
      stop_if_asked();
      Counts counts(static_cast<std::size_t>(m + 1), 0);
      if (possible(low, 0, n, i_sum, r_sum, counts)) {
        return true;
      }
    }
    return false;
  }
};

bool counts_exist(const Parameters& p, Number b) {
  const auto v = static_cast<Number>(p.v);
  const auto k = static_cast<Number>(p.k);
  const auto m = static_cast<Number>(p.change);
  Program program{.n = v, .degree = v - 1, .k = k, .m = m};
  if (p.kind == Kind::linear) {
    program.i_sum = k + m * (b - 1);
    program.r_sum = k * b;
    program.r_most = b + 1;
    return program.feasible();
  }
  for (Number f = 0; f <= k - m && f < v; ++f) {
    program.n = v - f;
    program.i_sum = m * b;
    program.r_sum = (k - f) * b;
    program.r_most = b;
    program.fixed = f;
    program.cut = k - m - f;
    if ((f == 0 || m * b >= v - f) && program.feasible()) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<std::uint64_t> degree_program(const Parameters& p, std::uint64_t from) {
  constexpr std::uint64_t largest_v = 2000;
  constexpr std::uint64_t largest_m = 3;
  constexpr std::uint64_t most_tries = 10'000;
  if (p.strength != 2 || p.v == p.k || p.v > largest_v || p.change > largest_m) {
    return std::nullopt;
  }
  for (std::uint64_t b = from; b <= from + most_tries; ++b) {
    if (counts_exist(p, static_cast<Number>(b))) {
      return b;
    }
  }
  return std::nullopt;
}

}  // namespace changeover
