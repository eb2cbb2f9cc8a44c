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
#include <map>
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

/// Which designs are the same up to names of elements, rotation and reversal. Each entry of the
/// catalog is built and brought into canonical form (isomorphism/isomorphism.hpp) at most once, and
/// not before it is needed: many designs held against a large cell cost as much as both together,
/// and not as much as all pairs. The catalog must outlive this.
class SameDesigns {
 public:
  explicit SameDesigns(const Catalog& catalog) : catalog_(&catalog) {}

  /// The label of an entry of the same cell with as many blocks that is the same design and has
  /// another label; nullopt if v or b exceed `largest_compared`. Retracted ones count. Knows the
  /// catalog as it was when a design of that cell was first asked for.
  [[nodiscard]] std::optional<std::string> find(const CatalogEntry& entry);

  /// An entry that is to be in the catalog soon, and counts from now on.
  void remember(const CatalogEntry& entry);

 private:
  struct Class {
    std::vector<CatalogEntry> waiting;                     // not yet looked at, the last first
    std::map<Checksum, std::vector<std::string>> by_form;  // of each canonical form two labels
  };
  Class& class_of(const CatalogEntry& entry);
  static void put(Class& known, const CatalogEntry& entry);

  const Catalog* catalog_;
  std::map<std::pair<Parameters, std::uint64_t>, Class> classes_;
};
inline constexpr std::uint64_t largest_compared = 1000;

/// SameDesigns for one design.
[[nodiscard]] std::optional<std::string> same_in_catalog(const Catalog& catalog,
                                                         const CatalogEntry& entry);

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
