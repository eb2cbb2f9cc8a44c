// The catalog that everybody asks: the designs that come with the program, and the user's own.
//
//     if (const auto entry = standard_catalog().best({.v = 20, .k = 6, .change = 1})) {
//       entry->label();                                         // "20.6.1.linear.37.…"
//     }
//
// The user's file is $CHANGEOVER_CATALOG if that is set (empty: none), else changeover/catalog.db
// in $XDG_DATA_HOME, else in ~/.local/share. It is looked at when the catalog is first asked for
// anything.
#pragma once

#include <string>

#include "changeover/catalog/catalog.hpp"

namespace changeover {

/// Names another file for the user's designs, before the catalog is first asked; empty for none.
/// @throws InternalError if it was asked already.
void choose_catalog(std::string path);

/// The user's file, whether it is there or not; empty for none.
[[nodiscard]] std::string standard_catalog_file();

/// Whether the catalog that comes with the program has the best design of p that was known to all
/// constructions, closure rules and searches when it was made: strength 2, m = 1, 2, 3, and 3 ≤ k ≤
/// 40 and v ≤ 160.
[[nodiscard]] bool is_stored_cell(const Parameters& p);

/// What is wrong with the user's file, as Catalog::problem(); empty if the catalog was not asked
/// for anything.
[[nodiscard]] std::string standard_catalog_problem();

/// What else is to be said of it, as Catalog::remark(); empty if the catalog was not asked for
/// anything.
[[nodiscard]] std::string standard_catalog_remark();

/// The one catalog of this process.
[[nodiscard]] Catalog& standard_catalog();

}  // namespace changeover
