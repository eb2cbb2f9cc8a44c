#include "bounds/degree_program.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "bounds/excess_program.hpp"
#include "changeover/run/control.hpp"

namespace changeover {
namespace {

using Number = std::int64_t;

Number ceil_div_signed(Number a, Number b) { return a >= 0 ? (a + b - 1) / b : -(-a / b); }
Number floor_div_signed(Number a, Number b) { return -ceil_div_signed(-a, b); }

// The least and the most of one number.
struct Range {
  Number least = 0;
  Number most = 0;
};

// a·x + b·y ≤ most.
struct HalfPlane {
  Number a = 0;
  Number b = 0;
  Number most = 0;
};

// Whole numbers x, y ≥ 0 in all of these half-planes.
class Plane {
 public:
  void add(HalfPlane h) { (h.b > 0 ? above_ : h.b < 0 ? below_ : beside_).push_back(h); }

  [[nodiscard]] bool has_point(Number largest_x) const {
    Range range{0, largest_x};
    for (const HalfPlane& h : beside_) {
      narrow(range, h.a, h.most);
    }
    // y is between two lines for a real y at all only where x is in this range.
    for (const HalfPlane& up : above_) {
      for (const HalfPlane& down : below_) {
        narrow(range, up.a * -down.b + down.a * up.b, up.most * -down.b + down.most * up.b);
      }
    }
    for (Number x = range.least; x <= range.most; ++x) {
      if (has_point_at(x)) {
        return true;
      }
    }
    return false;
  }

 private:
  // The x of the range with a·x ≤ most.
  static void narrow(Range& range, Number a, Number most) {
    if (a > 0) {
      range.most = std::min(range.most, floor_div_signed(most, a));
    } else if (a < 0) {
      range.least = std::max(range.least, ceil_div_signed(-most, -a));
    } else if (most < 0) {
      range.most = -1;
    }
  }

  [[nodiscard]] bool has_point_at(Number x) const {
    Range y{0, std::numeric_limits<Number>::max()};
    for (const HalfPlane& h : above_) {
      y.most = std::min(y.most, floor_div_signed(h.most - h.a * x, h.b));
    }
    for (const HalfPlane& h : below_) {
      y.least = std::max(y.least, ceil_div_signed(h.a * x - h.most, -h.b));
    }
    return y.least <= y.most;
  }

  std::vector<HalfPlane> above_, below_, beside_;  // b > 0, b < 0, b = 0
};

struct Program {
  Number n = 0;  // elements
  Number i_sum = 0;
  Number r_sum = 0;
  Number r_most = 0;  // r_x ≤ r_most − i_x
  Number k = 0;
  Number m = 0;
  Number cut = 0;  // stays that cutting a circular design open adds

  [[nodiscard]] Number least_r(Number i) const {
    return std::max(i, ceil_div_signed(n - 1 - i * (k - 1 - m), m));
  }
  [[nodiscard]] bool allowed(Number i) const { return i >= 1 && least_r(i) <= r_most - i; }

  [[nodiscard]] bool feasible() const {
    if (i_sum < n || r_sum > n * r_most - i_sum) {
      return false;
    }
    const Number middle = i_sum / n;
    for (Number low = std::max<Number>(1, middle - m); low <= middle; ++low) {
      stop_if_asked();
      if (feasible_from(low)) {
        return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::size_t most_values = 4;      // m + 1
  using PerValue = std::array<Number, most_values>;  // by i_x − low

  // Whether all elements can have the values low, …, low + m. The numbers c_j of elements with
  // i_x = low + j: c_0 = x and c_1 = y are free, as far as they are not the last two, which the
  // sums settle.
  [[nodiscard]] bool feasible_from(Number low) const {
    Plane plane;
    const auto require = [&](const PerValue& weight, Number most) {
      plane.add(in_free_counts(low, weight, most));
    };
    for (Number j = 0; j <= m; ++j) {
      PerValue one{};
      at(one, j) = -1;
      require(one, 0);
      if (!allowed(low + j)) {
        at(one, j) = 1;
        require(one, 0);
      }
    }
    PerValue weight{};
    for (Number j = 0; j <= m; ++j) {
      at(weight, j) = least_r(low + j);
    }
    require(weight, r_sum);
    // The inequality of stays. Beyond these s every element counts, and the left side grows more
    // slowly than the right one; before low, no element does.
    const Number last = std::max(low + m + 1, n / (2 * k) + 1);
    for (Number s = low; s <= last; ++s) {
      for (Number j = 0; j <= m; ++j) {
        at(weight, j) = std::max<Number>(0, s + 1 - low - j);
      }
      require(weight, (s * s - s + 1) * k + cut);
    }
    return plane.has_point(m > 1 ? n : 0);
  }

  static Number& at(PerValue& values, Number j) { return values[static_cast<std::size_t>(j)]; }

  // Σ weight_j·c_j ≤ most, where Σ c_j = n and Σ (low + j)·c_j = i_sum.
  [[nodiscard]] HalfPlane in_free_counts(Number low, PerValue weight, Number most) const {
    // With the last two weights taken off along the line through them, only the free ones are left.
    const Number slope = at(weight, m) - at(weight, m - 1);
    const Number start = at(weight, m) - slope * m;
    most -= start * n + slope * (i_sum - low * n);
    return {m > 1 ? at(weight, 0) - start : 0, m > 2 ? at(weight, 1) - start - slope : 0, most};
  }
};

// Numbers with the sums, the degrees and the stays; those of stays for few changes only.
bool numbers_exist(const Program& program, Number twice_excess) {
  constexpr Number largest_m_of_stays = 3;
  return ExcessProgram{.n = program.n,
                       .k = program.k,
                       .m = program.m,
                       .i_sum = program.i_sum,
                       .twice_excess = twice_excess,
                       .r_most = program.r_most}
             .feasible() &&
         (program.m > largest_m_of_stays || program.feasible());
}

bool counts_exist(const Parameters& p, Number b) {
  const auto m = static_cast<Number>(p.change);
  const bool linear = p.kind == Kind::linear;
  const Number most_fixed = linear ? 0 : static_cast<Number>(p.k - p.change);
  for (Number f = 0; f <= most_fixed; ++f) {
    // Without the f elements that are in every block, so that no element is.
    const Number n = static_cast<Number>(p.v) - f;
    const Number k = static_cast<Number>(p.k) - f;
    const Program program{.n = n,
                          .i_sum = linear ? k + m * (b - 1) : m * b,
                          .r_sum = k * b,
                          .r_most = linear ? b + 1 : b,
                          .k = k,
                          .m = m,
                          .cut = linear ? 0 : k - m};
    const Number first = linear ? k * (k - 1) : 0;
    const Number later = linear ? b - 1 : b;
    if (numbers_exist(program, first + later * m * (2 * k - m - 1) - n * (n - 1))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<std::uint64_t> degree_program(const Parameters& p, std::uint64_t from) {
  constexpr std::uint64_t largest_v = 2000;
  constexpr std::uint64_t most_tries = 10'000;
  if (p.strength != 2 || p.v == p.k || p.v > largest_v || p.change > ExcessProgram::largest_m) {
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
