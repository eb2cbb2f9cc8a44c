// Designs into the catalog and out of it: added, exchanged with others, audited, improved.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

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

// Catalogs on their way: written to a file, read from a stranger's, and compared.
//
//     OutputFile file("all.jsonl");
//     write_entries(catalog, {.best_only = false}, file);
//     file.commit();
//
//     const auto input = open_input("theirs.jsonl");
//     import_foreign(*input, catalog).added;           // how many; each was built and verified
//
// A file is as catalog/entry.hpp says. What a stranger's file says of a design is not believed: its recipe is built, its blocks are
// verified, its lower bound and the reason are computed anew.
//
// Bound by: building and verifying, about a millisecond an entry for v ≤ 100.

/// Writes a first line and what the filter lets through, a line each, by change number, strength, kind, k, v, b; those that are
/// retracted after all others, unless the filter names a status. Returns the number of entries. @throws as Sink::write().
std::uint64_t write_entries(const Catalog& catalog, const CatalogFilter& filter, Sink& sink);

/// What is taken from a stranger.
struct ForeignLimits {
  std::size_t line = std::size_t{8} << 20;  ///< bytes
  std::uint64_t entries = 1'000'000;
  std::uint64_t v = 2000;
  std::uint64_t b = 1'000'000;
  std::chrono::duration<double> time_each{30};  ///< for building and verifying one design
  std::uint64_t memory_each = std::uint64_t{128}
                              << 20;  ///< for the blocks of a design that is looked at as a whole
  bool skip_bad = false;  ///< leave out entries that are not what they say, and name them
};

/// What came of a stranger's file.
struct Foreign {
  std::vector<CatalogEntry> entries;       ///< not in the catalog yet, in the order of the file
  std::uint64_t known = 0;                 ///< are in the catalog already
  std::vector<std::string> left_out = {};  ///< a line each: where, which, why
};

/// Reads and verifies. Listens to the scope of this thread (run/control.hpp), and tells it.
/// @throws BadInput with file and line for the first entry that is not what it says, or beyond the limits, unless `skip_bad`; for a
/// file that is no catalog in any case. Stopped.
[[nodiscard]] Foreign read_foreign(Input& input, const Catalog& catalog,
                                   const ForeignLimits& limits = {});

/// What came of a file that was imported.
struct Imported {
  std::uint64_t added = 0;
  std::uint64_t improved = 0;   ///< of those: better than all that was known of their cells
  std::uint64_t known = 0;      ///< are in the catalog already, or twice in the file
  std::uint64_t not_added = 0;  ///< were verified, but the control said stop; import the file again
  std::vector<std::string> left_out = {};  ///< as Foreign
};

/// read_foreign() and Catalog::add() for files of any length. Entries that were verified wait on
/// the disk, so nothing is added before the whole file is known to be good (but for what `skip_bad`
/// leaves out); then they are added `batch` at a time, and other processes write in between. A
/// process that is killed leaves whole entries; importing the file again adds the rest. O(n log s)
/// for n entries and a catalog of s, besides building and verifying; memory for one batch. @throws
/// as read_foreign(), Catalog::add(); Stopped before anything is added.
[[nodiscard]] Imported import_foreign(Input& input, Catalog& catalog,
                                      const ForeignLimits& limits = {}, std::size_t batch = 1000);

// Two catalogs, cell by cell.
//
//     BestOfCells before = best_of_cells(*open_input("before.jsonl"));
//     for (const CellChange& change : compare_cells(before, best_of_cells(catalog))) {
//       change.after;                       // fewest blocks now
//     }

/// Fewest blocks of each cell, retracted entries left out.
using BestOfCells = std::map<Parameters, std::uint64_t>;

/// Of a file, which is read and not verified. @throws BadInput as entry_from_line().
[[nodiscard]] BestOfCells best_of_cells(Input& input);
[[nodiscard]] BestOfCells best_of_cells(const Catalog& catalog);

/// A cell in which two catalogs differ; 0 blocks where one has nothing.
struct CellChange {
  Parameters parameters;
  std::uint64_t before = 0;
  std::uint64_t after = 0;

  /// "new", "gone", "better" or "worse".
  [[nodiscard]] std::string_view kind() const;
};

/// By parameters. O(cells).
[[nodiscard]] std::vector<CellChange> compare_cells(const BestOfCells& before,
                                                    const BestOfCells& after);

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

// Searches where the catalog is weakest, and what of the user's is better than what comes with the program.
//
//     RunControl control({.time = std::chrono::seconds(2)});
//     const auto finds = improve_catalog(catalog, {.v_to = 9, .k_to = 4}, control);
//     const Submission submission = write_submission(catalog, sink);   // lines for those who keep the catalog
//
// Every find is verified and in the user's file before the next cell is looked at: whatever ends the search, no more is lost than what is
// under way.
//
// Bound by: the local search (search/local_search.hpp); a cell costs up to a second before its first move, in which the closure rules
// look for its best recipe.

struct CatalogSearch {
  /// For a cell in the first pass over all of them, twice as long in each pass after it; nothing: a fiftieth of the time that is left, but
  /// 1 to 60 s.
  std::optional<std::chrono::duration<double>> each = {};
  Introduction introduction = {};  ///< of what is found; program and command are filled in
};

/// A cell that became better.
struct CatalogFind {
  std::string label;
  Parameters parameters;
  std::uint64_t before = 0;
  std::uint64_t b = 0;
  std::string how;  ///< one line
};

/// Looks for better designs of the cells that the filter lets through and whose best is above its bound, again and again until the
/// control says stop: those whose gap is largest against their number of blocks first, of equal ones the smaller, whose designs are the
/// beginning of more others. Calls found() for each find once it is in the user's file. @throws as Catalog::add(); BadInput as newcomer_of().
[[nodiscard]] std::vector<CatalogFind> improve_catalog(
    Catalog& catalog, const CatalogFilter& filter, RunControl& control,
    const CatalogSearch& search = {}, const std::function<void(const CatalogFind&)>& found = {});

/// What the user has that is better than all that comes with the program, the best of each cell.
struct Submission {
  std::vector<std::string> labels;    ///< of the entries, in order
  std::vector<std::string> left_out;  ///< not as they say: label and why, a line each
};

/// Writes it as write_entries() does, each entry built and verified before. An entry is better if it has fewer blocks than
/// any of its cell that comes with the program and than a construction that needs no catalog. @throws as Sink::write().
[[nodiscard]] Submission write_submission(const Catalog& catalog, Sink& sink);

}  // namespace changeover
