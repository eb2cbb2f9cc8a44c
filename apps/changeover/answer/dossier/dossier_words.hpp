// Sentences of the library as a dossier writes them: theorems of the program are cited like works,
// commands stand between backticks, formulas are not broken.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace changeover::cli {

/// The key of the program's own theorems, as docs/references.bib has keys of works.
inline constexpr std::string_view own_key = "ChangeoverTheorems";

/// A sentence with "[ChangeoverTheorems, Theorem 5]" in the place of "docs/theorems.md, Theorem 5",
/// in whichever brackets that stands, and with backticks around commands of the program. O(length)
///
///     for_paper("so few (docs/theorems.md, Theorem 5)")  // so few [ChangeoverTheorems, Theorem 5]
[[nodiscard]] std::string for_paper(std::string_view sentence);

/// A theorem that a dossier rests on.
struct QuotedTheorem {
  std::string number;
  std::string title;
  std::string statement;  ///< Markdown without links
};

/// The theorems of the program that these sentences cite, by number, each once.
[[nodiscard]] std::vector<QuotedTheorem> cited_theorems(const std::vector<std::string>& sentences);

/// BibTeX of the program's theorems.
[[nodiscard]] std::string own_theorems_bibtex();

/// What is between backticks, and what is not: the second of a pair says which. O(length)
[[nodiscard]] std::vector<std::pair<std::string, bool>> pieces_of(std::string_view text);

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
