// Words of models, shared by their readers and by all code that compares values.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace changeover {

/// The text without surrounding blanks, tabs and line ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// What is between separators, each trimmed; one empty text of an empty one.
[[nodiscard]] std::vector<std::string_view> split_values(std::string_view text, char separator);

/// The text with a to z replaced by A to Z.
[[nodiscard]] std::string in_capitals(std::string_view text);

/// Whether the words are equal, ignoring the case of A to Z.
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);

/// Parses a number: decimal, with an optional sign, point and exponent, or hexadecimal after 0x.
[[nodiscard]] std::optional<double> number_in(std::string_view text);

}  // namespace changeover
