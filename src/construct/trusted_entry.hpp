// Entries of the catalog that are what they say.
#pragma once

#include <optional>
#include <string>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

/// The entry of that label. Those that come with the program are held by its tests; one of the
/// user's is built and verified the first time it is asked for, and left out of account from then
/// on, with what is wrong as Catalog::problem(), if it is not what it says.
[[nodiscard]] std::optional<CatalogEntry> trusted_entry(const Catalog& catalog,
                                                        const std::string& label);

/// Why the design of an entry is not what the entry says, in one line; empty if it is. Builds it,
/// O(bk²).
[[nodiscard]] std::string entry_defect(const CatalogEntry& entry);

// A design in memory, of a recipe that may come from a stranger.

/// As read_all(), and listens to the scope of this thread (run/control.hpp) on the way: what a
/// recipe makes may be larger than anything that it says. @throws MissingResource if the blocks
/// need more memory than the scope allows; Stopped; as read_all().
[[nodiscard]] Design read_within_memory(BlockSource& source);

}  // namespace changeover
