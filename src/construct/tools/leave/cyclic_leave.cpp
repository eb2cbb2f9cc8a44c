#include "construct/tools/leave/cyclic_leave.hpp"

#include <algorithm>

#include "construct/tools/cyclic.hpp"

namespace changeover {
namespace {

// The i-th pair of 1, …, 2c−1 without c whose differences are 1, …, c−1, each once; c = 4r+4.
PositionPair pair_without_middle(std::uint64_t c, std::uint64_t i) {
  const std::uint64_t r = c / 4 - 1;
  if (i < 2 * r + 1) {
    return {4 * r + 5 + i, 8 * r + 7 - i};
  }
  i -= 2 * r + 1;
  if (i == 0) {
    return {2 * r + 3, 6 * r + 6};
  }
  if (i == 1) {
    return {r + 1, r + 2};
  }
  if (i == 2) {
    return {2 * r + 2, 4 * r + 3};
  }
  i -= 3;
  if (i < r) {
    return {i + 1, 4 * r + 2 - i};
  }
  i -= r;
  return {r + 3 + i, 3 * r + 2 - i};
}

// The same without c−1; c = 4r+3.
PositionPair pair_without_one_before(std::uint64_t c, std::uint64_t i) {
  const std::uint64_t r = c / 4;
  if (r == 0) {
    return i == 0 ? PositionPair{1, 3} : PositionPair{4, 5};
  }
  if (i < 2 * r + 1) {
    return {4 * r + 3 + i, 8 * r + 5 - i};
  }
  i -= 2 * r + 1;
  if (i == 0) {
    return {2 * r + 3, 6 * r + 4};
  }
  if (i == 1) {
    return {1, 2 * r + 2};
  }
  if (i == 2) {
    return {r + 1, r + 2};
  }
  i -= 3;
  if (i < r - 1) {
    return {i + 2, 4 * r + 1 - i};
  }
  i -= r - 1;
  return {r + 3 + i, 3 * r + 2 - i};
}

std::uint64_t elements_of(std::uint64_t k, const CyclicLeave::Shape& shape) {
  const std::uint64_t covered = 2 * (shape.rounds * (2 * k - 3) + shape.left);
  switch (shape.half) {
    case CyclicLeave::Half::none:
      return covered + 1;
    case CyclicLeave::Half::left:
      return covered + 2;
    default:
      return covered;
  }
}

}  // namespace

bool CyclicLeave::serves(std::uint64_t k, const Shape& shape) {
  if (k < 4 || shape.rounds < 1 || shape.rounds % 4 < 2) {
    return k >= 4 && shape.rounds >= 1;
  }
  switch (shape.half) {
    case Half::none:
      return true;
    case Half::left:
      return 2 * shape.left + 2 >= k - 2;
    default:
      return shape.left >= 1;
  }
}

CyclicLeave::CyclicLeave(std::uint64_t k, const Shape& shape)
    : n_(k - 2), step_(2 * k - 3), w_(elements_of(k, shape)), shape_(shape) {}

// j of the one base block that is not of a pair: how far its second element is beyond its place.
std::uint64_t CyclicLeave::beyond() const {
  const std::uint64_t left = shape_.left;
  if (lacks_zero()) {
    return shape_.half == Half::covered ? left : 0;
  }
  return shape_.half == Half::left ? (2 * left + 2 - n_) / 2 : left + 1;
}

// p and q of pair number i, 0 ≤ i < c−1: of −(c−1), …, c−1 without 0 if c ≡ 0 or 1, without −1 if
// c ≡ 2 or 3 (mod 4).
std::array<std::int64_t, 2> CyclicLeave::pair(std::uint64_t i) const {
  const std::uint64_t c = shape_.rounds;
  const PositionPair positions = c % 4 == 0   ? pair_without_middle(c, i)
                                 : c % 4 == 3 ? pair_without_one_before(c, i)
                                              : ordinary_pair(c, i);
  const auto zero = static_cast<std::int64_t>(c);
  return {static_cast<std::int64_t>(positions.first) - zero,
          static_cast<std::int64_t>(positions.second) - zero};
}

// The number of the pair that contains 0, c−1 if none does.
std::uint64_t CyclicLeave::linking() const {
  const std::uint64_t c = shape_.rounds;
  return lacks_zero() ? c - 1 : c % 4 == 3 ? 0 : link_pair(c);
}

IntervalDevelopedSource::Points CyclicLeave::all_points() const {
  return [leave = *this](std::uint64_t which, std::span<Element> points) {
    std::ranges::copy(leave.points(which), points.begin());
  };
}

std::array<Element, 2> CyclicLeave::points(std::uint64_t i) const {
  const std::uint64_t last = shape_.rounds - 1;
  const std::uint64_t link = linking();
  const std::uint64_t number = i == last ? link : i == link ? last : i;
  const auto n = static_cast<std::int64_t>(n_);
  const auto step = static_cast<std::int64_t>(step_);
  std::array<std::int64_t, 2> x{};
  if (number < last) {
    const auto [p, q] = pair(number);
    x = {p * step + n, q * step + n};
  } else {
    const std::int64_t before = static_cast<std::int64_t>(last) * step;
    const auto j = static_cast<std::int64_t>(beyond());
    x = lacks_zero() ? std::array{n, -(before + n + 1 + j)}
                     : std::array{n - step, before + 2 * n + j};
  }
  const auto element = [this](std::int64_t y) {
    return static_cast<Element>(y < 0 ? y + static_cast<std::int64_t>(w_) : y);
  };
  return {std::min(element(x[0]), element(x[1])), std::max(element(x[0]), element(x[1]))};
}

std::vector<std::uint64_t> CyclicLeave::differences() const {
  std::vector<std::uint64_t> left;
  const std::uint64_t from = (shape_.rounds - 1) * step_ + n_ + 1;  // what the pairs leave
  const auto add = [&left, from](std::uint64_t first, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      left.push_back(from + first + i);
    }
  };
  const std::uint64_t j = beyond();
  switch (shape_.half) {
    case Half::none:
    case Half::left:
      if (lacks_zero()) {
        add(n_ + 1, shape_.left);
      } else if (shape_.half == Half::none) {
        add(0, shape_.left);
      } else {
        add(0, j);
        add(j + n_, n_ % 2);
        add(j + n_ + n_ % 2 + 1, shape_.left - j - n_ % 2);
      }
      return left;
    default:
      if (lacks_zero()) {
        add(0, shape_.left);
      } else {
        add(0, shape_.left - 1);
        add(shape_.left, 1);
      }
      return left;
  }
}

}  // namespace changeover
