// Costs, kept exactly: whole millionths of a unit of money.
//
//     const Amount test = parse_amount("1.25");
//     to_string(test * 12 + parse_amount("0.5"));        // "15.50"
//     to_string(parse_amount("3"));                      // "3"
//
// Sums and products refuse to overflow, so a total is exact or it is not given.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace changeover {

/// An amount of money, never negative.
struct Amount {
  std::uint64_t millionths = 0;

  auto operator<=>(const Amount&) const = default;
};

/// The exact sum. @throws ImpossibleParameters if it exceeds 2⁶³ − 1 millionths, about 9.2·10¹² units.
[[nodiscard]] Amount operator+(Amount a, Amount b);
/// The amount so many times. @throws as the sum.
[[nodiscard]] Amount operator*(Amount a, std::uint64_t times);
/// Adds b. @throws as the sum; a is then as it was.
inline Amount& operator+=(Amount& a, Amount b) { return a = a + b; }

/// a − b for b ≤ a. @throws InternalError if b is larger.
[[nodiscard]] Amount operator-(Amount a, Amount b);

/// Reads "12", "12.5", "0.000001", ".5": digits with at most one point and at most six decimals.
/// @throws BadInput with one line (without a place) for anything else, negative numbers included;
/// ImpossibleParameters if it is too large.
[[nodiscard]] Amount parse_amount(std::string_view text);

/// How many decimals show an amount as money: none, two, or as many up to six as it needs.
[[nodiscard]] unsigned decimals_needed(Amount amount);

/// The amount with decimals_needed() decimals, or with more if asked for.
[[nodiscard]] std::string to_string(Amount amount, unsigned at_least_decimals = 0);

}  // namespace changeover
