// Formulas in the LaTeX of the paper, evaluated exactly, so that a formula is compared as it is
// printed.
//
//     value_of(R"(v+\frac{v}{k-2}+1)", {{'v', 7}, {'k', 3}});          // 15
//     value_of(R"(\frac{\binom{v}{2}}{2k-3})", {{'v', 8}, {'k', 6}});  // 28/9
//
// Read are numbers, letters, + - / ^, juxtaposition as a product, brackets ( ) and { }, \frac,
// \binom, \ceiling. A quotient a/b takes one factor on its right, as in v(v-1)/2.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace changeover {

/// A fraction in lowest terms, its denominator positive.
struct Fraction {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  bool operator==(const Fraction&) const = default;

  /// "15" or "28/9".
  [[nodiscard]] std::string to_string() const;

  /// The number, if it is whole and not negative.
  [[nodiscard]] std::optional<std::uint64_t> count() const;

  /// The least whole number that is not below it.
  [[nodiscard]] std::int64_t ceiling() const;
};

/// Letters and what they stand for.
using Values = std::map<char, std::uint64_t>;

/// @throws BadInput if the formula cannot be read, has a letter without a value, divides by zero,
/// or takes \binom of what is no pair of whole numbers; ImpossibleParameters if a number exceeds 64
/// bits.
[[nodiscard]] Fraction value_of(std::string_view formula, const Values& values);

}  // namespace changeover
