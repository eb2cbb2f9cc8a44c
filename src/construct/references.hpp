// docs/references.bib, which is in the library.
#pragma once

#include <string>
#include <vector>

namespace changeover {

/// The text of docs/references.bib from "@" to its end for a key; empty if there is none.
[[nodiscard]] std::string bibtex_of(const std::string& key);

/// "Chafee and Stevens 2025": the family names of the authors of a work, of more than three the
/// first "et al.", and its year if that is known; empty if the key is not there.
[[nodiscard]] std::string spoken_work(const std::string& key);

/// The title of a work; empty if the key is not there or its work has none.
[[nodiscard]] std::string title_of_work(const std::string& key);

/// "A. L. Chafee and B. Stevens. Recursive and Cyclic …. Journal of …, 2025": a line of a list of
/// references, with the note of a work that has no title; empty if the key is not there.
[[nodiscard]] std::string written_work(const std::string& key);

/// Where a work can be read: its DOI, its preprint or its page; empty if none is known.
[[nodiscard]] std::string address_of_work(const std::string& key);

/// Adds the keys that a sentence cites in brackets, "[ChafeeStevens2025, Theorem 2]", each once, if
/// they are in docs/references.bib.
void add_keys(const std::string& sentence, std::vector<std::string>& keys);

}  // namespace changeover
