// Entries of the catalog in words and as JSON.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "construct/references.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

/// {"label","v","k","change","kind",["strength",]"b","lower_bound","reason","status",
/// "construction","credit","cites","hash",…}.
void write_entry(JsonWriter& json, const CatalogEntry& entry);

/// The same beside its cell: without parameters, and without its bound and the reason if these are
/// that of the cell.
void write_entry_beside(JsonWriter& json, const CatalogEntry& entry, const Bound& of_cell);

/// "changeover search 20 5 …; The Changeover developers; changeover 1.0.0; 2026-11-22".
[[nodiscard]] std::string credit_words(const Credit& credit);

/// A line of a list: label, blocks, bound, status, construction, date.
[[nodiscard]] std::string entry_row(const CatalogEntry& entry);

/// Those of docs/references.bib that the entry and the constructions of its recipe are from, each
/// once.
[[nodiscard]] std::vector<std::string> references_of(const CatalogEntry& entry);

using changeover::bibtex_of;  // of a key of docs/references.bib

/// BibTeX of a design and of what it is from.
[[nodiscard]] std::string bibtex_of(const CatalogEntry& entry);

/// BibTeX of the catalog that comes with the program, as it is today.
[[nodiscard]] std::string bibtex_of(const Catalog& catalog);

// How much the catalog knows: cells filled, minima proved, by strength, change number, kind and
// block size.

struct Tally {
  std::uint64_t cells = 0;
  std::uint64_t minimum = 0;
  std::uint64_t v_from = ~std::uint64_t{0};
  std::uint64_t v_to = 0;
  double ratios = 0;  ///< sum of b / lower bound

  [[nodiscard]] double mean_ratio() const { return ratios / static_cast<double>(cells); }
};

/// By strength, change number, kind, k.
using Completeness = std::map<std::tuple<std::uint32_t, std::uint64_t, Kind, std::uint64_t>, Tally>;

[[nodiscard]] Completeness completeness(const Catalog& catalog, const CatalogFilter& filter);

/// The document of `catalog completeness --json`.
[[nodiscard]] std::string completeness_json(const Completeness& found);

// The day on which something is credited.

/// Today by the system's clock, in UTC: "2026-11-22".
[[nodiscard]] std::string today();

}  // namespace changeover::cli
