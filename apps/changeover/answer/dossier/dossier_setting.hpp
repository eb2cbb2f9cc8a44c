// How a dossier sets sentences: formulas that no line breaks, letters as mathematics, statements of
// theorems.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace changeover::cli {

/// HTML in which no line ends within short brackets, "⌈(40 − 6) / 2⌉" and "{0,3,7}", nor before
/// or behind a relation; dates are in a <span>; a letter behind a number is in italics, "2x".
/// O(length)
[[nodiscard]] std::string unbroken(std::string_view html);

/// A command whose words with hyphens are in a <span> each.
[[nodiscard]] std::string unbroken_code(std::string_view html);

/// LaTeX in which small letters that stand alone, but for "a", or behind a number ("2x") are
/// mathematics.
[[nodiscard]] std::string with_letters_set(std::string_view latex);

/// A statement in Markdown as HTML; `prose` makes HTML of its sentences.
template <typename Prose>
[[nodiscard]] std::string statement_html(std::string_view markdown, const Prose& prose);

// The parts of a statement: paragraphs, and lines of formulas.
struct StatementPart {
  std::string text;
  bool formula = false;
};
[[nodiscard]] std::vector<StatementPart> statement_parts(std::string_view markdown);

template <typename Prose>
std::string statement_html(std::string_view markdown, const Prose& prose) {
  std::string html;
  for (const StatementPart& part : statement_parts(markdown)) {
    html += part.formula ? "<p class=\"formula\">" : "<p>";
    bool italic = false;
    bool bold = false;
    std::string words;
    const auto flush = [&] {
      html += prose(words);
      words.clear();
    };
    for (std::size_t i = 0; i < part.text.size(); ++i) {
      if (part.text[i] != '*') {
        words += part.text[i];
        continue;
      }
      flush();
      if (part.text.substr(i, 2) == "**") {
        html += bold ? "</strong>" : "<strong>";
        bold = !bold;
        ++i;
      } else {
        html += italic ? "</em>" : "<em>";
        italic = !italic;
      }
    }
    flush();
    html += std::string(italic ? "</em>" : "") + (bold ? "</strong>" : "") + "</p>\n";
  }
  return html;
}

}  // namespace changeover::cli
