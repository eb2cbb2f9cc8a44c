// The works of docs/references.bib, which is in the library: as BibTeX, and in the words in which
// pages, dossiers and pictures name them.
#pragma once

#include <string>
#include <vector>

namespace changeover {

/// How people name a work. web/references.json has all; `./dev web build` makes it of the
/// bibliography, and the pages read it, too.
struct Work {
  std::string name;  ///< "Chafee and Stevens 2025"; of more than three authors the first, "et al."
  std::string text;  ///< a line of a list of references, with its note if it has no title
  std::string url;   ///< its DOI, its preprint or its page; empty if none is known
};

/// The work of a key; null if there is none. O(log works)
[[nodiscard]] const Work* find_work(const std::string& key);

/// The text of docs/references.bib from "@" to its end for a key; empty if there is none.
[[nodiscard]] std::string bibtex_of(const std::string& key);

/// Adds the keys that a sentence cites in brackets, "[ChafeeStevens2025, Theorem 2]", each once, if
/// they are in docs/references.bib.
void add_keys(const std::string& sentence, std::vector<std::string>& keys);

}  // namespace changeover
