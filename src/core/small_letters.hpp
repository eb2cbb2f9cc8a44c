// Texts that differ only in capitals, also beyond A to Z.
//
//     in_small_letters("Äpfel") == in_small_letters("äpfel")    // true
#pragma once

#include <string>
#include <string_view>

namespace changeover {

/// The letters of a text with small ones for the capitals of Latin, Greek and Cyrillic, as
/// spreadsheets compare the names of sheets: "Ä" and "ä" are one. U+0000 for each byte that is not
/// valid.
[[nodiscard]] std::u32string in_small_letters(std::string_view text);

}  // namespace changeover
