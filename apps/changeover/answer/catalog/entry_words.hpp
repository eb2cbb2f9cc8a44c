// Entries of the catalog in words and as JSON.
#pragma once

#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

/// {"label","v","k","change","kind",["strength",]"b","lower_bound","reason","status","construction","credit","cites","hash",…}.
void write_entry(JsonWriter& json, const CatalogEntry& entry);

/// "changeover search 20 5 …; The Changeover developers; changeover 0.1.0; 2026-11-22".
[[nodiscard]] std::string credit_words(const Credit& credit);

/// A line of a list: label, blocks, bound, status, construction, date.
[[nodiscard]] std::string entry_row(const CatalogEntry& entry);

/// Those of docs/references.bib that the entry and the constructions of its recipe are from, each
/// once.
[[nodiscard]] std::vector<std::string> references_of(const CatalogEntry& entry);

/// The text of docs/references.bib from "@" to its end for a key; empty if there is none.
[[nodiscard]] std::string bibtex_of(const std::string& key);

/// Adds the keys that a sentence cites in brackets, "[ChafeeStevens2025, Theorem 2]", each once, if
/// they are in docs/references.bib.
void add_keys(const std::string& sentence, std::vector<std::string>& keys);

/// BibTeX of a design and of what it is from.
[[nodiscard]] std::string bibtex_of(const CatalogEntry& entry);

/// BibTeX of the catalog that comes with the program, as it is today.
[[nodiscard]] std::string bibtex_of(const Catalog& catalog);

}  // namespace changeover::cli
