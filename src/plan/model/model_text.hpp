// Words of models: what their readers and all that compares values share.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace changeover {

/// Without blanks, tabs and line ends around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// With A to Z for a to z.
[[nodiscard]] std::string in_capitals(std::string_view text);

/// Equal but for upper and lower case of A to Z.
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);

/// The number that a text is: decimal, perhaps with a sign, a point and an exponent, or hexadecimal
/// after 0x.
[[nodiscard]] std::optional<double> number_in(std::string_view text);

}  // namespace changeover
