#include "paper/print/formula.hpp"

#include <fmt/format.h>

#include <cctype>
#include <limits>
#include <numeric>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

std::int64_t checked(bool overflow, std::int64_t result) {
  if (overflow ||
      result == std::numeric_limits<std::int64_t>::min()) {  // its negative is too large
    throw ImpossibleParameters(
        "these parameters are too large, a count exceeds 64 bits; give smaller ones");
  }
  return result;
}

std::int64_t product(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  const bool overflow = __builtin_mul_overflow(a, b, &result);
  return checked(overflow, result);
}

std::int64_t sum(std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  const bool overflow = __builtin_add_overflow(a, b, &result);
  return checked(overflow, result);
}

std::int64_t whole(std::uint64_t number) {
  return checked(number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()),
                 static_cast<std::int64_t>(number));
}

Fraction reduced(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
  return {numerator / divisor, denominator / divisor};
}

Fraction operator+(const Fraction& a, const Fraction& b) {
  return reduced(sum(product(a.numerator, b.denominator), product(b.numerator, a.denominator)),
                 product(a.denominator, b.denominator));
}

Fraction operator*(const Fraction& a, const Fraction& b) {
  return reduced(product(a.numerator, b.numerator), product(a.denominator, b.denominator));
}

// One pass from left to right: sum, product, power, atom.
class Reader {
 public:
  Reader(std::string_view formula, const Values& values) : formula_(formula), values_(values) {}

  Fraction read() {
    const Fraction value = read_sum();
    if (!at_end()) {
      refuse("nothing is expected here");
    }
    return value;
  }

 private:
  [[noreturn]] void refuse(std::string_view why) const {
    throw BadInput(fmt::format("formula \"{}\", character {}: {}", formula_, position_ + 1, why));
  }

  bool at_end() {
    while (position_ < formula_.size() && formula_[position_] == ' ') {
      ++position_;
    }
    return position_ == formula_.size();
  }

  bool take(std::string_view token) {
    if (at_end() || !formula_.substr(position_).starts_with(token)) {
      return false;
    }
    position_ += token.size();
    return true;
  }

  Fraction divided(const Fraction& a, const Fraction& b) const {
    if (b.numerator == 0) {
      refuse("a division by zero");
    }
    return a * reduced(b.denominator, b.numerator);
  }

  Fraction read_sum() {
    const Fraction minus{-1, 1};
    Fraction value = take("-") ? minus * read_product() : read_product();
    while (true) {
      if (take("+")) {
        value = value + read_product();
      } else if (take("-")) {
        value = value + minus * read_product();
      } else {
        return value;
      }
    }
  }

  Fraction read_product() {
    Fraction value = read_power();
    while (!at_end()) {
      const char next = formula_[position_];
      if (take("/")) {
        value = divided(value, read_power());
      } else if (next == '(' || next == '\\' || next == '{' || is_letter(next) || is_digit(next)) {
        value = value * read_power();
      } else {
        return value;
      }
    }
    return value;
  }

  Fraction read_power() {
    const Fraction base = read_atom();
    if (!take("^")) {
      return base;
    }
    const std::optional<std::uint64_t> exponent = read_atom().count();
    if (!exponent || *exponent > 64) {
      refuse("an exponent is a small whole number");
    }
    Fraction value{1, 1};
    for (std::uint64_t i = 0; i < *exponent; ++i) {
      value = value * base;
    }
    return value;
  }

  Fraction read_atom() {
    if (take("\\frac")) {
      const Fraction above = read_group('{', "}");
      return divided(above, read_group('{', "}"));
    }
    if (take("\\binom")) {
      const auto n = read_group('{', "}").count();
      const auto r = read_group('{', "}").count();
      if (!n || !r) {
        refuse("a binomial coefficient takes whole numbers");
      }
      return {whole(binomial(*n, *r)), 1};
    }
    if (take("\\ceiling")) {
      return {read_group('{', "}").ceiling(), 1};
    }
    if (at_end()) {
      refuse("it ends here");
    }
    const char first = formula_[position_];
    if (first == '(') {
      return read_group('(', ")");
    }
    if (first == '{') {
      return read_group('{', "}");
    }
    if (is_digit(first)) {
      Fraction number;
      for (; position_ < formula_.size() && is_digit(formula_[position_]); ++position_) {
        number.numerator = sum(product(number.numerator, 10), formula_[position_] - '0');
      }
      return number;
    }
    const auto value = values_.find(first);
    if (value == values_.end()) {
      refuse("no value is known for this");
    }
    ++position_;
    return {whole(value->second), 1};
  }

  Fraction read_group(char opening, std::string_view closing) {
    if (at_end() || formula_[position_] != opening) {
      refuse(fmt::format("{} is missing", opening));
    }
    ++position_;
    if (++depth_ > 100) {
      refuse("nested too deeply");
    }
    const Fraction value = read_sum();
    --depth_;
    if (!take(closing)) {
      refuse(fmt::format("{} is missing", closing));
    }
    return value;
  }

  static bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
  static bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

  std::string_view formula_;
  const Values& values_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string Fraction::to_string() const {
  return denominator == 1 ? fmt::format("{}", numerator)
                          : fmt::format("{}/{}", numerator, denominator);
}

std::optional<std::uint64_t> Fraction::count() const {
  if (denominator != 1 || numerator < 0) {
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(numerator);
}

std::int64_t Fraction::ceiling() const {
  return numerator / denominator + (numerator > 0 && numerator % denominator != 0 ? 1 : 0);
}

Fraction value_of(std::string_view formula, const Values& values) {
  return Reader(formula, values).read();
}

}  // namespace changeover
