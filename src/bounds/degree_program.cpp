#include "bounds/degree_program.hpp"

#include <algorithm>

#include "changeover/run/scope.hpp"

namespace changeover {
namespace {

using Number = std::int64_t;

Number ceil_div_signed(Number a, Number b) { return a >= 0 ? (a + b - 1) / b : -(-a / b); }

struct Program {
  Number n = 0;  // elements that are not in every block
  Number i_sum = 0;
  Number r_sum = 0;
  Number r_most = 0;  // r_x ≤ r_most − i_x
  Number degree = 0;  // i_x(k−1) + m(r_x − i_x) ≥ degree
  Number k = 0;
  Number m = 0;

  [[nodiscard]] Number least_r(Number i) const {
    return std::max(i, ceil_div_signed(degree - i * (k - 1 - m), m));
  }
  [[nodiscard]] bool allowed(Number i) const { return i >= 1 && least_r(i) <= r_most - i; }

  /// The least Σ r_x with `left` elements at the values i, …, last and Σ i_x = sum; −1 if impossible.
  [[nodiscard]] Number least_sum(Number i, Number last, Number left, Number sum) const {
    if (left == 0) {
      return sum == 0 ? 0 : -1;
    }
    if (i > last || sum < i * left || sum > last * left) {
      return -1;
    }
    if (i == last) {
      return allowed(i) ? left * least_r(i) : -1;
    }
    if (i + 1 == last) {  // two unknowns, two equations
      const Number upper = sum - i * left;
      const Number lower = left - upper;
      if ((upper > 0 && !allowed(last)) || (lower > 0 && !allowed(i))) {
        return -1;
      }
      return upper * least_r(last) + lower * least_r(i);
    }
    Number best = -1;
    const Number most = allowed(i) ? left : 0;
    for (Number count = 0; count <= most; ++count) {
      if (i + 2 < last) {
        stop_if_asked();
      }
      const Number rest = least_sum(i + 1, last, left - count, sum - count * i);
      if (rest >= 0 && (best < 0 || rest + count * least_r(i) < best)) {
        best = rest + count * least_r(i);
      }
    }
    return best;
  }

  [[nodiscard]] bool feasible() const {
    if (i_sum < n || r_sum > n * r_most - i_sum) {
      return false;
    }
    const Number middle = i_sum / n;
    for (Number low = std::max<Number>(1, middle - m); low <= middle; ++low) {
      stop_if_asked();
      const Number least = least_sum(low, low + m, n, i_sum);
      if (least >= 0 && least <= r_sum) {
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
  Program program{.n = v, .i_sum = 0, .r_sum = 0, .r_most = 0, .degree = v - 1, .k = k, .m = m};
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
