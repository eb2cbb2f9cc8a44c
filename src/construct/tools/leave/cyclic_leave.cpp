#include "construct/tools/leave/cyclic_leave.hpp"

#include <algorithm>

#include "construct/tools/cyclic.hpp"

namespace changeover {
namespace {

// Pairs of 1, …, 2c whose differences are 1, …, c, each once: a Skolem sequence of order c = 4s.
PositionPair skolem_pair(std::uint64_t c, std::uint64_t i) {
  const std::uint64_t s = c / 4;
  if (s == 1) {
    constexpr std::array<PositionPair, 4> pairs{{{1, 2}, {3, 6}, {4, 8}, {5, 7}}};
    return pairs[static_cast<std::size_t>(i)];
  }
  if (i < 2 * s) {
    return {4 * s + i, 8 * s - i};
  }
  i -= 2 * s;
  if (i < s - 2) {
    return {i + 1, 4 * s - i - 2};
  }
  i -= s - 2;
  if (i < s - 2) {
    return {s + i + 2, 3 * s - i - 1};
  }
  const std::array<PositionPair, 4> others{
      {{s - 1, 3 * s}, {s, s + 1}, {2 * s, 4 * s - 1}, {2 * s + 1, 6 * s}}};
  return others[static_cast<std::size_t>(i - (s - 2))];
}

// Pairs of 1, …, 2c−1 without c−1 whose differences are 1, …, c−1, each once; c = 4r+3.
PositionPair holed_pair(std::uint64_t c, std::uint64_t i) {
  const std::uint64_t r = c / 4;
  if (r == 0) {
    return i == 0 ? PositionPair{1, 3} : PositionPair{4, 5};
  }
  if (i < 2 * r + 1) {
    return {4 * r + 3 + i, 8 * r + 5 - i};
  }
  i -= 2 * r + 1;
  if (i < r - 1) {
    return {i + 2, 4 * r + 1 - i};
  }
  i -= r - 1;
  if (i < r - 1) {
    return {r + 3 + i, 3 * r + 2 - i};
  }
  const std::array<PositionPair, 3> others{
      {{2 * r + 3, 6 * r + 4}, {1, 2 * r + 2}, {r + 1, r + 2}}};
  return others[static_cast<std::size_t>(i - (r - 1))];
}

}  // namespace

bool CyclicLeave::serves(std::uint64_t k, const Shape& shape) {
  return k >= 4 && shape.rounds >= 1 &&
         (shape.rounds % 4 < 2 || !shape.even || 2 * shape.left + 2 >= k - 2);
}

CyclicLeave::CyclicLeave(std::uint64_t k, const Shape& shape)
    : n_(k - 2),
      step_(2 * k - 3),
      c_(shape.rounds),
      left_(shape.left),
      w_(2 * (c_ * step_ + left_) + (shape.even ? 2 : 1)),
      even_(shape.even) {}

// j of the base block with x_{−1}: how far the other element is beyond its place.
std::uint64_t CyclicLeave::beyond() const { return even_ ? (2 * left_ + 2 - n_) / 2 : left_ + 1; }

Element CyclicLeave::element(std::int64_t x) const {
  return static_cast<Element>(x < 0 ? x + static_cast<std::int64_t>(w_) : x);
}

CyclicLeave::Indices CyclicLeave::indices(std::uint64_t i) const {
  const auto c = static_cast<std::int64_t>(c_);
  const auto from = [i](PositionPair pair, std::int64_t zero) {
    return Indices{static_cast<std::int64_t>(pair.first) - zero,
                   static_cast<std::int64_t>(pair.second) - zero};
  };
  switch (c_ % 4) {
    case 0:
      return from(skolem_pair(c_, i), c + 1);
    case 1:  // With 0 left over, and −c.
      return i == c_ - 1 ? Indices{-c, 0} : from(ordinary_pair(c_, i), c);
    case 2:  // With −1 left over.
      return from(ordinary_pair(c_, i), c);
    default:
      return from(holed_pair(c_, i), c);
  }
}

// The number of the pair that contains 0.
std::uint64_t CyclicLeave::linking() const {
  switch (c_ % 4) {
    case 0:
      return c_ == 4 ? 3 : 1;
    case 1:
      return c_ - 1;
    case 2:
      return c_ == 2 ? 0 : c_ / 2 - 2;
    default:
      return c_ == 3 ? 0 : 0;
  }
}

std::array<Element, 2> CyclicLeave::points(std::uint64_t i) const {
  const std::uint64_t link = linking();
  const std::uint64_t number = i == c_ - 1 ? link : i == link ? c_ - 1 : i;
  const auto n = static_cast<std::int64_t>(n_);
  const auto step = static_cast<std::int64_t>(step_);
  std::int64_t x = 0;
  std::int64_t y = 0;
  if (number < ordinary()) {
    const Indices pair = indices(number);
    x = pair.p * step + n;
    y = pair.q * step + n;
  } else {
    x = (static_cast<std::int64_t>(c_) - 1) * step + 2 * n + static_cast<std::int64_t>(beyond());
    y = n - step;
  }
  const Element one = element(x);
  const Element two = element(y);
  return {std::min(one, two), std::max(one, two)};
}

std::vector<std::uint64_t> CyclicLeave::differences() const {
  std::vector<std::uint64_t> left;
  const auto add = [&left](std::uint64_t from, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      left.push_back(from + i);
    }
  };
  if (!holed()) {
    add(c_ * step_ + 1, left_);
    return left;
  }
  // Beside the n differences of the element beyond, and that of its base block's two elements.
  const std::uint64_t from = (c_ - 1) * step_ + n_ + 1;
  if (!even_) {
    add(from, left_);
    return left;
  }
  const std::uint64_t j = beyond();
  add(from, j);
  const std::uint64_t after = from + j + n_;
  const std::uint64_t between = n_ % 2;
  add(after, between);
  add(after + between + 1, left_ - j - between);
  return left;
}

}  // namespace changeover
