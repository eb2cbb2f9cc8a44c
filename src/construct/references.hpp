// docs/references.bib, which is in the library.
#pragma once

#include <string>
#include <vector>

namespace changeover {

/// The text of docs/references.bib from "@" to its end for a key; empty if there is none.
[[nodiscard]] std::string bibtex_of(const std::string& key);

/// Adds the keys that a sentence cites in brackets, "[ChafeeStevens2025, Theorem 2]", each once, if
/// they are in docs/references.bib.
void add_keys(const std::string& sentence, std::vector<std::string>& keys);

}  // namespace changeover
