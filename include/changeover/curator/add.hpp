// A design from outside becomes an entry of the catalog.
//
//     const Design design = read_design("mine.txt");
//     const Newcomer newcomer = newcomer_of(design, {.note = "found by hand"});
//     if (newcomer.entry && !same_in_catalog(catalog, *newcomer.entry)) {
//       catalog.add(*newcomer.entry);
//     }
//
// Nothing is believed: the blocks are verified, the lower bound is computed. The recipe that came with the blocks is kept if it
// makes the same blocks and names no design that only this user has; if not, the blocks are.
// Where its provenance says which program made them and how, the credit does too. Names of elements are not kept.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

/// What is said of a design by whoever brings it.
struct Introduction {
  Credit credit = {};
  std::vector<std::string> cites = {};
  std::string note = {};
};

/// An entry, or why there is none.
struct Newcomer {
  std::optional<CatalogEntry> entry;
  std::string
      refused;  ///< "3 steps do not change exactly 2 elements, the first from block 4 to block 5"
};

/// Verifies a design, with recipe or without. @throws BadInput if what is said of it is no plain line of text, or the entry is longer
/// than a line of a catalog may be; InternalError if a valid design has fewer blocks than a bound allows.
[[nodiscard]] Newcomer newcomer_of(const Design& design, const Introduction& introduction);

/// The label of an entry of the same cell with as many blocks that is the same design up to names of elements, rotation and reversal,
/// and has another label; not looked for if v or b exceed `largest_compared`. Retracted ones count.
[[nodiscard]] std::optional<std::string> same_in_catalog(const Catalog& catalog,
                                                         const CatalogEntry& entry);
inline constexpr std::uint64_t largest_compared = 1000;

/// A cell that becomes better by a new design.
struct Gain {
  std::string rule;  ///< "cut", "fix", "truncate", "blow-up": of construct/closure.hpp
  Parameters parameters;
  std::uint64_t b = 0;
  std::optional<std::uint64_t> before;  ///< what the registry offered; nothing if there was none
};

/// What one closure rule makes of an entry, where that is better than what the registry offers: to be asked before it is added. Built and
/// verified. Not looked for if v or b exceed `largest_compared`.
[[nodiscard]] std::vector<Gain> gains_of(const CatalogEntry& entry);

}  // namespace changeover
