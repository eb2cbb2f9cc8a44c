// Sentences of the program in LaTeX: mathematics as mathematics, references as citations.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace changeover {

/// One line of plain text as LaTeX. "b >= 3", "i_x", "Z_{15}", "ceil(a / b)" and signs such as ∪
/// and ⌈ become mathematics; "[ChafeeStevens2025, Theorem 2]" becomes
/// \cite[Theorem 2]{ChafeeStevens2025} if `keys` has that key. Letters beyond ASCII that are not
/// mathematical signs stay as they are. Needs no package. O(length · number of keys).
[[nodiscard]] std::string latex_prose(std::string_view text,
                                      const std::vector<std::string>& keys = {});

}  // namespace changeover
