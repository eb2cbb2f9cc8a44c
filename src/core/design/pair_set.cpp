#include "changeover/core/pair_set.hpp"

#include "core/bit_scan.hpp"
#include "core/checked.hpp"

namespace changeover {

PairSet::PairSet(std::uint64_t v)
    : v_(v), pairs_(binomial(v, 2)), words_(static_cast<std::size_t>(ceil_div(pairs_, 64)), 0) {}

void PairSet::insert_below(Element x, std::span<const std::uint64_t> below) {
  if (x > 0) {
    or_bits(words_, rank(0, x), below, x);
  }
}

std::uint64_t PairSet::size() const { return count_bits(words_); }

std::uint64_t PairSet::missing() const { return pairs_ - size(); }

std::uint64_t PairSet::next(std::uint64_t r, std::uint64_t flip) const {
  return next_bit(words_, r, flip);
}

}  // namespace changeover
