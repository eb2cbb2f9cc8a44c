// Entries of the catalog that are what they say.
#pragma once

#include <optional>
#include <string>

#include "changeover/catalog/catalog.hpp"

namespace changeover {

/// The entry of that label. Those that come with the program are held by its tests; one of the
/// user's is built and verified the first time it is asked for, and left out of account from then
/// on, with what is wrong as Catalog::problem(), if it is not what it says.
[[nodiscard]] std::optional<CatalogEntry> trusted_entry(const Catalog& catalog,
                                                        const std::string& label);

/// Why the design of an entry is not what the entry says, in one line; empty if it is. Builds it,
/// O(bk²).
[[nodiscard]] std::string entry_defect(const CatalogEntry& entry);

}  // namespace changeover
