#include "loadorder/shares/groups/planes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

// The prime of which q is a power; 0 if there is none.
std::uint32_t prime_of(std::uint32_t q) {
  std::uint32_t p = 2;
  while (p * p <= q && q % p != 0) {
    ++p;
  }
  p = q % p == 0 ? p : q;
  while (q > 1 && q % p == 0) {
    q /= p;
  }
  return q == 1 ? p : 0;
}

using Digits = std::vector<std::uint32_t>;

Digits digits_of(std::uint32_t number, std::uint32_t p, std::size_t count) {
  Digits digits(count);
  for (std::uint32_t& digit : digits) {
    digit = number % p;
    number /= p;
  }
  return digits;
}

std::uint32_t number_of(const Digits& digits, std::uint32_t p) {
  std::uint32_t number = 0;
  for (std::size_t i = digits.size(); i > 0; --i) {
    number = number * p + digits[i - 1];
  }
  return number;
}

// The powers of x modulo x^d = −(low coefficients): all q − 1 of them are different if and only if
// x generates the field.
std::vector<std::uint32_t> powers_of_x(const Digits& low, std::uint32_t p, std::uint32_t q) {
  Digits power(low.size(), 0);
  power[0] = 1;
  std::vector<std::uint32_t> all;
  std::vector<bool> seen(q, false);
  for (std::uint32_t i = 0; i + 1 < q; ++i) {
    const std::uint32_t number = number_of(power, p);
    if (number == 0 || seen[number]) {
      return {};
    }
    seen[number] = true;
    all.push_back(number);
    const std::uint32_t top = power.back();
    std::rotate(power.rbegin(), power.rbegin() + 1, power.rend());
    power[0] = 0;
    for (std::size_t j = 0; j < low.size(); ++j) {
      power[j] = (power[j] + (p - low[j] % p) * top) % p;
    }
  }
  return all;
}

}  // namespace

std::optional<FiniteField> FiniteField::of_order(std::uint64_t order) {
  constexpr std::uint64_t largest = 256;
  const auto q = static_cast<std::uint32_t>(std::min(order, largest + 1));
  const std::uint32_t p = q < 2 || q > largest ? 0 : prime_of(q);
  if (p == 0) {
    return std::nullopt;
  }
  std::size_t degree = 0;
  for (std::uint32_t rest = q; rest > 1; rest /= p) {
    ++degree;
  }
  FiniteField field;
  field.q_ = q;
  field.sums_.resize(std::size_t{q} * q);
  field.negatives_.resize(q);
  for (std::uint32_t a = 0; a < q; ++a) {
    const Digits x = digits_of(a, p, degree);
    for (std::uint32_t b = 0; b < q; ++b) {
      Digits sum = digits_of(b, p, degree);
      for (std::size_t i = 0; i < degree; ++i) {
        sum[i] = (sum[i] + x[i]) % p;
      }
      const std::uint32_t number = number_of(sum, p);
      field.sums_[std::size_t{a} * q + b] = number;
      if (number == 0) {
        field.negatives_[a] = b;
      }
    }
  }
  // There is a primitive polynomial of every degree; one of degree 1 is x minus a generator.
  std::vector<std::uint32_t> powers;
  for (std::uint32_t low = 1; powers.empty(); ++low) {
    powers = powers_of_x(digits_of(low, p, degree), p, q);
  }
  field.logs_.assign(q, 0);
  for (std::uint32_t i = 0; i < powers.size(); ++i) {
    field.logs_[powers[i]] = i;
  }
  field.powers_ = powers;
  field.powers_.insert(field.powers_.end(), powers.begin(), powers.end());
  return field;
}

Plane::Plane(std::uint64_t q, bool affine) : q_(q), affine_(affine) {
  auto field = FiniteField::of_order(q);
  if (!field) {
    throw BadInput(fmt::format(
        "there is no field with {} elements, or it is too large; give a prime power", q));
  }
  field_ = std::move(*field);
  place_of_.resize(static_cast<std::size_t>(points()));
  point_at_.resize(place_of_.size());
  Random random(1);
  for (std::uint32_t i = 0; i < place_of_.size(); ++i) {
    const std::uint32_t j = random.below(i + 1);
    place_of_[i] = place_of_[j];
    place_of_[j] = i;
  }
  for (std::uint32_t point = 0; point < place_of_.size(); ++point) {
    point_at_[place_of_[point]] = point;
  }
}

Plane::Triple Plane::triple(std::uint64_t number) const {
  if (number < q_ * q_) {
    return {1, static_cast<std::uint32_t>(number / q_), static_cast<std::uint32_t>(number % q_)};
  }
  if (number < q_ * q_ + q_) {
    return {0, 1, static_cast<std::uint32_t>(number - q_ * q_)};
  }
  return {0, 0, 1};
}

std::uint64_t Plane::number(const Triple& of) const {
  const auto part = [&](std::uint32_t x, std::uint32_t by) {
    return field_.multiply(x, field_.inverse(by));
  };
  if (of.x != 0) {
    return std::uint64_t{part(of.y, of.x)} * q_ + part(of.z, of.x);
  }
  return of.y != 0 ? q_ * q_ + part(of.z, of.y) : q_ * q_ + q_;
}

Plane::Triple Plane::across(const Triple& a, const Triple& b) const {
  const auto minor = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) {
    return field_.add(field_.multiply(p, q), field_.negative(field_.multiply(r, s)));
  };
  return {minor(a.y, b.z, a.z, b.y), minor(a.z, b.x, a.x, b.z), minor(a.x, b.y, a.y, b.x)};
}

Plane::Triple Plane::beside(const Triple& of, std::uint32_t i) const {
  const auto over = [&](std::uint32_t x, std::uint32_t by) {
    return field_.multiply(field_.negative(x), field_.inverse(by));
  };
  const bool last = i == q_;
  if (of.z != 0) {
    return last ? Triple{0, 1, over(of.y, of.z)}
                : Triple{1, i, over(field_.add(of.x, field_.multiply(of.y, i)), of.z)};
  }
  if (last) {
    return {0, 0, 1};
  }
  return of.y != 0 ? Triple{1, over(of.x, of.y), i} : Triple{0, 1, i};
}

std::vector<Element> Plane::points_of(std::uint64_t line) const {
  const Triple of = triple(line + (affine_ ? 1 : 0));
  std::vector<Element> points;
  for (std::uint32_t i = 0; i <= q_; ++i) {
    const Triple point = beside(of, i);
    if (!affine_ || point.x != 0) {
      points.push_back(point_at_[static_cast<std::size_t>(number(point))]);
    }
  }
  std::ranges::sort(points);
  return points;
}

std::uint64_t Plane::line_of(std::uint64_t point, std::uint64_t other) const {
  const auto at = [&](std::uint64_t of) { return triple(place_of_[static_cast<std::size_t>(of)]); };
  return number(across(at(point), at(other))) - (affine_ ? 1 : 0);
}

std::uint64_t Plane::line_through(std::uint64_t point, std::uint64_t i) const {
  const Triple at = triple(place_of_[static_cast<std::size_t>(point)]);
  return number(beside(at, static_cast<std::uint32_t>(i))) - (affine_ ? 1 : 0);
}

GroupShares plane_shares(std::uint64_t q, bool affine) {
  const Plane plane(q, affine);
  GroupShares shares;
  shares.groups = plane.points();
  shares.plane_order = q;
  shares.method = affine ? "affine plane" : "projective plane";
  shares.explanation = fmt::format(
      "the points of the {} plane of order {}; each of {} workers has the {} "
      "points of a line, so any two groups are together at one worker.",
      affine ? "affine" : "projective", q, plane.lines(), plane.on_a_line());
  for (std::uint64_t line = 0; line < plane.lines(); ++line) {
    shares.workers.push_back({plane.points_of(line), {}});
  }
  return shares;
}

GroupShares streamed_plane_shares(std::uint64_t q, bool affine) {
  GroupShares shares = plane_shares(q, affine);
  shares.plane_order = 0;
  shares.explanation.pop_back();
  shares.explanation += "; each worker streams one group of its line.";
  std::vector<std::uint64_t> streamed(static_cast<std::size_t>(shares.groups), 0);
  for (GroupShare& share : shares.workers) {
    const auto least =
        std::ranges::min_element(share.held, {}, [&](Element group) { return streamed[group]; });
    ++streamed[*least];
    share.streamed = {*least};
    share.held.erase(least);
  }
  return shares;
}

}  // namespace changeover
