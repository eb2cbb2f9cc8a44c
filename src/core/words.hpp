// Numbers in sentences, and letters and digits in words.
//
//     count_of(1, "block")               // 1 block
//     count_of(7, "block")               // 7 blocks
//     count_of(2, "class", "classes")    // 2 classes
//     all_of(7, "pair")                 // all 7 pairs; of one: the pair
//     change_name(2)                     // double-change
//     leading_defect({"no file; name one", …})  // no file (and 2 more like this); name one
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace changeover {

/// A number and the word for what it counts. The plural ends in s unless it is given.
[[nodiscard]] std::string count_of(std::uint64_t n, std::string_view one,
                                   std::string_view many = {});

/// All of so many: "all 7 pairs", "the pair".
[[nodiscard]] std::string all_of(std::uint64_t n, std::string_view one);

/// One message for several defects, one at least: the first, and how many more there are, said
/// before its remedy: "no room for both (and 2 more like this); keep fewer parts mounted".
[[nodiscard]] std::string leading_defect(const std::vector<std::string>& messages);

/// The name for m changes: single-change, double-change, 3-change.
[[nodiscard]] std::string change_name(std::uint64_t m);

/// The value that to_string() calls by this name; nullopt if there is none.
template <typename Value>
[[nodiscard]] std::optional<Value> named(std::string_view name, std::initializer_list<Value> all) {
  const auto found = std::ranges::find(all, name, [](Value each) { return to_string(each); });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

/// True for 0 to 9, whatever the locale.
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// True for A to Z and a to z, whatever the locale.
[[nodiscard]] constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// True for letters and digits, as above.
[[nodiscard]] constexpr bool is_alphanumeric(char c) { return is_letter(c) || is_digit(c); }

/// Whether a word stands where a number is missing or is none, in any case and with any sign: nan,
/// inf, NA, none, null, "?", nothing. No column has such a name.
[[nodiscard]] bool is_missing_number(std::string_view word);

/// With A to Z as a to z, whatever the locale.
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace changeover
