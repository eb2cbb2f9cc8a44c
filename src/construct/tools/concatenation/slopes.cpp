#include "construct/tools/concatenation/slopes.hpp"

#include <vector>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

struct PrimePower {
  std::uint64_t prime, power;
};

std::vector<PrimePower> prime_powers(std::uint64_t g) {
  std::vector<PrimePower> powers;
  for (std::uint64_t p = 2; g > 1; ++p) {
    if (p * p > g) {
      p = g;
    }
    std::uint64_t power = 1;
    for (; g % p == 0; g /= p) {
      power *= p;
    }
    if (power > 1) {
      powers.push_back({p, power});
    }
  }
  return powers;
}

}  // namespace

bool Slopes::known(std::uint64_t g, std::uint64_t m) {
  for (const auto& [prime, power] : prime_powers(g)) {
    if (power < m) {
      return false;
    }
  }
  return g > 0;
}

Slopes::Slopes(std::uint64_t g, std::uint64_t m) {
  const std::vector<PrimePower> powers = prime_powers(g);
  if (!powers.empty() && powers.front().prime >= m) {
    factors_.push_back({.size = g, .base = g});
    return;
  }
  for (const auto& [prime, power] : powers) {
    Factor factor{.size = power, .base = prime < m ? prime : power};
    while (prime < m && !factor.separates(m)) {
      if (++factor.tail == factor.size) {
        throw InternalError("no ring for lines through groups");
      }
    }
    factors_.push_back(factor);
  }
}

std::uint64_t Slopes::at(std::uint64_t i, std::uint64_t d, std::uint64_t a) const {
  std::uint64_t sum = 0;
  std::uint64_t unit = 1;
  for (const Factor& factor : factors_) {
    const std::uint64_t here = factor.product(i, d / unit % factor.size);
    sum += unit * factor.plus(a / unit % factor.size, here, 1);
    unit *= factor.size;
  }
  return sum;
}

// x + times·y, digit by digit.
std::uint64_t Slopes::Factor::plus(std::uint64_t x, std::uint64_t y, std::uint64_t times) const {
  std::uint64_t sum = 0;
  for (std::uint64_t unit = 1; unit < size; unit *= base) {
    sum += unit * ((x / unit % base + times * (y / unit % base)) % base);
  }
  return sum;
}

std::uint64_t Slopes::Factor::product(std::uint64_t x, std::uint64_t y) const {
  std::uint64_t result = 0;
  for (std::uint64_t unit = size / base; unit > 0; unit /= base) {
    const std::uint64_t leading = result / (size / base);
    result = plus(result % (size / base) * base, tail, base - leading);
    result = plus(result, y, x / unit % base);
  }
  return result;
}

bool Slopes::Factor::separates(std::uint64_t m) const {
  for (std::uint64_t j = 1; j < m; ++j) {
    for (std::uint64_t i = 0; i < j; ++i) {
      for (std::uint64_t x = 1; x < size; ++x) {
        if (product(plus(j, i, base - 1), x) == 0) {
          return false;
        }
      }
    }
  }
  return true;
}

}  // namespace changeover
