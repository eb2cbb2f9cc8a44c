// Sentences of the program in LaTeX, HTML and Markdown: mathematics as mathematics, in LaTeX
// references as citations.
#pragma once

#include <cstddef>
#include <optional>
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

/// The same for a page: signs instead of ">=" and "ceil(", indices below, letters of formulas and
/// small letters that stand alone in italics. Everything else is text. Markdown, which is also read
/// as it stands, has no italics, and indices as HTML.
///
///     html_prose("b >= n_j")    // <i>b</i> ≥ <i>n</i><sub><i>j</i></sub>
[[nodiscard]] std::string html_prose(std::string_view text);
[[nodiscard]] std::string markdown_prose(std::string_view text);

// Formulas in the program's sentences, as LaTeX writes them.

/// A formula at the beginning of a text, and how many bytes of the text it is.
struct LatexFormula {
  std::string latex;  ///< between dollars
  std::size_t length = 0;
};

/// The longest formula that `text` begins with: numbers, single letters with an index ("n_j",
/// "n1"), calls such as C(12,2), brackets, ⌈ ⌉, ⌊ ⌋ and ceil( ), joined by signs, with at least one
/// sign and one letter or relation. Nothing if there is none: "12", "2026-11-21", "a file". The
/// caller looks at what stands before. O(length).
///
///     latex_formula("b >= 3 blocks")->latex    // b \geq 3
[[nodiscard]] std::optional<LatexFormula> latex_formula(std::string_view text);

/// The bytes of an index at the beginning of a text: digits, one letter, or simple words in braces;
/// 0 if there is none.
[[nodiscard]] std::size_t latex_index_length(std::string_view text);

}  // namespace changeover
