// What was meant by a word that is not known.
//
//     nearest_word("H-100", {"A100", "H100"})   // H100
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace changeover {

/// The known word that is nearest, by letters to insert, drop, replace or swap; nothing if none is
/// near enough: one letter may differ of two or more, and a third of the letters of longer words.
/// A word of more than 40 bytes is no misspelling. O(known words times the square of their length).
[[nodiscard]] std::optional<std::string> nearest_word(const std::string& word,
                                                      const std::vector<std::string>& known);

}  // namespace changeover
