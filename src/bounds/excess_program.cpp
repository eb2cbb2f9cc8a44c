#include "bounds/excess_program.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace changeover {
namespace {

using Number = std::int64_t;

// The least Σ e_x.
struct LeastSum {
  using Value = Number;
  Number most = 0;
  static constexpr Value none = std::numeric_limits<Number>::max();

  [[nodiscard]] static Value of(Number e) { return e; }
  [[nodiscard]] Value both(Value a, Value b) const { return a + b <= most ? a + b : none; }
  [[nodiscard]] static Value either(Value a, Value b) { return std::min(a, b); }
  [[nodiscard]] bool good(Value a) const { return a <= most; }
};

// All possible Σ e_x up to the wanted one, as bits.
struct EverySum {
  using Value = std::uint64_t;
  Number wanted = 0;
  static constexpr Value none = 0;

  [[nodiscard]] static Value of(Number e) { return Value{1} << e; }
  [[nodiscard]] Value both(Value a, Value b) const {
    Value sums = 0;
    for (; b != 0; b &= b - 1) {
      sums |= a << std::countr_zero(b);
    }
    return sums & ((Value{2} << wanted) - 1);
  }
  [[nodiscard]] static Value either(Value a, Value b) { return a | b; }
  [[nodiscard]] bool good(Value a) const { return (a >> wanted & 1) != 0; }
};

// What sums of e_x are possible for so many elements, by the sum of their i_x. Elements in the
// right order have sums near the mean everywhere, so only sums near it are kept: with all i_x
// among m + 1 neighbouring numbers, a part of s elements that is off by d has a part of about half
// as many that is off by at most 2d/3 + m; so no part need be off by more than 3m.
template <typename Rule>
class Sums {
 public:
  using Value = typename Rule::Value;

  Sums(const ExcessProgram& program, Rule rule)
      : program_(program), rule_(rule), width_(3 * program.m + 2) {}

  void add(Number i, Number e) { values_.emplace_back(i, Rule::of(e)); }

  [[nodiscard]] bool good() const {
    return rule_.good(at(both_of(program_.n).first, program_.n, program_.i_sum));
  }

 private:
  using Row = std::vector<Value>;

  [[nodiscard]] Number start(Number count) const {
    return count * program_.i_sum / program_.n - width_;
  }
  [[nodiscard]] Value at(const Row& row, Number count, Number sum) const {
    const Number place = sum - start(count);
    return place < 0 || place > 2 * width_ ? Rule::none : row[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] Row nothing() const {
    return Row(static_cast<std::size_t>(2 * width_ + 1), Rule::none);
  }

  [[nodiscard]] Row one() const {
    Row row = nothing();
    for (const auto& [i, value] : values_) {
      if (const Number place = i - start(1); place >= 0 && place <= 2 * width_) {
        Value& held = row[static_cast<std::size_t>(place)];
        held = Rule::either(held, value);
      }
    }
    return row;
  }

  [[nodiscard]] Row joined(const Row& a, Number in_a, const Row& b, Number in_b) const {
    Row row = nothing();
    for (Number x = start(in_a); x <= start(in_a) + 2 * width_; ++x) {
      const Value of_x = at(a, in_a, x);
      if (of_x == Rule::none) {
        continue;
      }
      const Number from = start(in_a + in_b) - x;
      for (Number y = std::max(from, start(in_b));
           y <= std::min(from + 2 * width_, start(in_b) + 2 * width_); ++y) {
        const Value of_y = at(b, in_b, y);
        if (of_y != Rule::none) {
          Value& held = row[static_cast<std::size_t>(y - from)];
          held = Rule::either(held, rule_.both(of_x, of_y));
        }
      }
    }
    return row;
  }

  // The rows for count and count + 1 elements.
  [[nodiscard]] std::pair<Row, Row> both_of(Number count) const {
    if (count == 1) {
      return {one(), joined(one(), 1, one(), 1)};
    }
    const Number half = count / 2;
    const auto [low, high] = both_of(half);
    Row between = joined(low, half, high, half + 1);
    return count % 2 == 0 ? std::pair{joined(low, half, low, half), std::move(between)}
                          : std::pair{std::move(between), joined(high, half + 1, high, half + 1)};
  }

  const ExcessProgram& program_;
  Rule rule_;
  Number width_;
  std::vector<std::pair<Number, Value>> values_;
};

// The least e for an element with i introductions; none if it would be in too many blocks, or if
// it would have to stay where nothing does.
std::optional<Number> least_excess(const ExcessProgram& p, Number i) {
  const Number surplus = i * (p.k - 1) - (p.n - 1);
  const Number stays = surplus >= 0 ? 0 : (-surplus + p.m - 1) / p.m;
  if ((p.k == p.m && stays > 0) || 2 * i + stays > p.r_most) {
    return std::nullopt;
  }
  return surplus + stays * p.m;
}

struct Choice {
  Number i = 0;
  Number e = 0;
};

// What elements can be: m + 1 neighbouring numbers of introductions are enough, about the mean.
std::vector<Choice> choices(const ExcessProgram& p) {
  std::vector<Choice> all;
  const Number middle = p.i_sum / p.n;
  for (Number i = std::max<Number>(1, middle - p.m); i <= middle + p.m; ++i) {
    const std::optional<Number> e = least_excess(p, i);
    if (e && 2 * *e <= p.twice_excess) {
      all.push_back({i, *e});
    }
  }
  return all;
}

// What the elements do that are all of one of two kinds, or would, with fractions: no mixture of
// more kinds has a smaller sum than the best of these. nullopt if that leaves it open.
std::optional<bool> feasible_by_two_kinds(const ExcessProgram& p, const std::vector<Choice>& all) {
  bool hopeful = false;
  for (const Choice& low : all) {
    for (const Choice& high : all) {
      // So many times `between` elements are of each kind; one kind by itself is at the mean.
      const bool same = high.i == low.i;
      const Number between = same ? 1 : high.i - low.i;
      const Number of_high = p.i_sum - low.i * p.n;
      const Number of_low = same ? p.n : high.i * p.n - p.i_sum;
      if (between < 0 || of_high < 0 || of_low < 0 || (same && of_high > 0)) {
        continue;
      }
      const Number sum = low.e * of_low + high.e * of_high;
      if (sum > between * p.twice_excess) {
        continue;
      }
      hopeful = true;
      const bool exact = sum == between * p.twice_excess || p.twice_excess >= 2 * p.m;
      if (exact && of_high % between == 0) {
        return true;
      }
    }
  }
  return hopeful ? std::nullopt : std::optional(false);
}

template <typename Rule>
bool feasible_by(const ExcessProgram& p, const std::vector<Choice>& all, Rule rule) {
  Sums<Rule> sums(p, rule);
  for (const auto& [i, e] : all) {
    sums.add(i, e);
  }
  return sums.good();
}

}  // namespace

bool ExcessProgram::feasible() const {
  if (twice_excess < 0 || i_sum < n) {
    return false;
  }
  const std::vector<Choice> all = choices(*this);
  if (const std::optional<bool> answer = feasible_by_two_kinds(*this, all)) {
    return *answer;
  }
  // If E < m, then e_x ≤ E says that each e_x is the least for its i_x.
  return twice_excess < 2 * m ? feasible_by(*this, all, EverySum{twice_excess})
                              : feasible_by(*this, all, LeastSum{twice_excess});
}

}  // namespace changeover
