#include "construct/tools/concatenation/slopes.hpp"

#include <span>
#include <string_view>

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

namespace {

// Two digits for each a: the elements of groups 1 and 2.
constexpr std::string_view of_six[] = {
    "253004134251", "542540011332", "021145345023", "413453200215",
    "314312552400", "035221403514", "100533225144",
};

constexpr std::string_view of_ten[] = {
    "00471876299385346152", "86115728703994450263", "95802267387149561304", "59968133074872602415",
    "73699082441758013526", "68740991835527124630", "37087519928466235041", "14253640516203778998",
    "21324354650610889779", "42536405162031997887",
};

std::span<const std::string_view> classes_of(std::uint64_t g) {
  if (g == 6) {
    return of_six;
  }
  return g == 10 ? std::span<const std::string_view>(of_ten) : std::span<const std::string_view>();
}

}  // namespace

std::uint64_t written_class_count(std::uint64_t g) { return classes_of(g).size(); }

std::uint64_t in_written_class(std::uint64_t g, std::uint64_t index, std::uint64_t i,
                               std::uint64_t a) {
  if (i == 0) {
    return a;
  }
  const std::string_view digits = classes_of(g)[static_cast<std::size_t>(index)];
  return static_cast<std::uint64_t>(digits[static_cast<std::size_t>(2 * a + i - 1)] - '0');
}

}  // namespace changeover
