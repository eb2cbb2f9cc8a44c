// Everything that the catalog says, held to what is built.
//
//     RunControl control({.threads = 2});
//     const Audit audit = audit_catalog(catalog, {.v_to = 20, .best_only = false}, control);
//     audit.faults.empty();                                 // or what is wrong, entry by entry
//
// The user's file is read as a whole: rows that contradict their lines and aliases that lead
// nowhere are faults.
// Of each entry the recipe is built, the blocks are verified and their checksum is compared, and the lower bound is computed anew:
// an entry that claims a larger one says more than is known.
//
// Bound by: SHA-256 (a fifth), building, verifying, bounds and the reading of lines: 3,700 entries a second and thread of what comes
// with the program.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// What came of looking.
struct Audit {
  std::uint64_t entries = 0;  ///< that the filter lets through
  std::uint64_t checked = 0;  ///< this time
  struct Fault {
    std::string label;
    std::string what;
  };
  std::vector<Fault> faults;  ///< by label

  /// Whether nothing is left to check.
  [[nodiscard]] bool complete(std::uint64_t done_before = 0) const {
    return checked + done_before == entries;
  }
};

/// The labels that a filter lets through, and a checksum of all that their entries say; what is
/// wrong in the user's file itself (Catalog::faults()), whatever the filter.
struct AuditScope {
  std::vector<std::string> labels;
  std::vector<Audit::Fault> faults;
  std::string checksum;
};
[[nodiscard]] AuditScope audit_scope(const Catalog& catalog, const CatalogFilter& filter);

/// Checks the entries of a scope on the control's threads, but for those in `done`; calls good(label) for each that is what it says,
/// never twice at once. Stops with the control: Audit::complete() is then false.
[[nodiscard]] Audit audit_entries(const Catalog& catalog, const AuditScope& scope,
                                  RunControl& control, const std::set<std::string>& done = {},
                                  const std::function<void(const std::string&)>& good = {});
/// The same for all that a filter lets through.
[[nodiscard]] inline Audit audit_catalog(const Catalog& catalog, const CatalogFilter& filter,
                                         RunControl& control) {
  return audit_entries(catalog, audit_scope(catalog, filter), control);
}

/// What is wrong with one entry; empty if nothing. Listens to the scope of this thread.
[[nodiscard]] std::string fault_of_entry(const CatalogEntry& entry);

}  // namespace changeover
