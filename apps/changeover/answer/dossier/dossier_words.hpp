// Sentences of the library as a dossier writes them: theorems of the program are cited like works,
// and commands stand between backticks.
#pragma once

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

}  // namespace changeover::cli
