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
// Nothing is trusted: newcomer_of() verifies the blocks and computes the lower bound. It keeps the
// recipe that came with the blocks if it makes the same blocks and names no design that only this
// user has; otherwise it keeps the blocks. If the provenance names the program and command that
// made them, so does the credit. Names of elements are not kept.

/// Statements about a new design by the person who adds it.
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

/// Verifies a design and makes its entry. @throws BadInput if a statement is not a plain line of
/// text, or the entry is too long for a line of a catalog; InternalError if a valid design has
/// fewer blocks than a bound allows.
[[nodiscard]] Newcomer newcomer_of(const Design& design, const Introduction& introduction);

/// Finds designs that are the same up to names of elements, rotation and reversal. It builds each
/// entry of the catalog and its canonical form (isomorphism/isomorphism.hpp) at most once, when
/// needed: comparing n designs with a cell of c takes time in proportion to n + c, not n·c.
/// The catalog must outlive this.
class SameDesigns {
 public:
  explicit SameDesigns(const Catalog& catalog) : catalog_(&catalog) {}

  /// The label of an entry of the same cell with as many blocks that is the same design and has
  /// another label; nullopt if v or b exceed `largest_compared`. Retracted entries count. It uses
  /// the state of the catalog at the first call for a design of that cell.
  [[nodiscard]] std::optional<std::string> find(const CatalogEntry& entry);

  /// Counts an entry that will be added soon as one of the catalog.
  void remember(const CatalogEntry& entry);

 private:
  struct Class {
    std::vector<CatalogEntry> waiting;                     // not yet compared, last first
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
  /// number of blocks that the registry offered; nothing if it had none
  std::optional<std::uint64_t> before;
};

/// The cells that become better by one closure rule applied to an entry; call it before the entry
/// is added. The designs are built and verified. Empty if v or b exceed `largest_compared`.
[[nodiscard]] std::vector<Gain> gains_of(const CatalogEntry& entry);

// Exchange of catalogs: writing files, reading files from elsewhere, and comparing them.
//
//     OutputFile file("all.jsonl");
//     write_entries(catalog, {.best_only = false}, file);
//     file.commit();
//
//     const auto input = open_input("theirs.jsonl");
//     import_foreign(*input, catalog).added;           // how many; each was built and verified
//
// catalog/entry.hpp describes files. Claims of a file from elsewhere are not trusted: reading
// builds the recipe, verifies the blocks, and computes the lower bound and its reason again.
//
// Cost: building and verifying, about a millisecond per entry for v ≤ 100.

/// Writes a first line and one line for each entry that the filter lets through, by change number,
/// strength, kind, k, v, b; retracted ones after all others, unless the filter names a status.
/// Returns the number of entries. @throws as Sink::write().
std::uint64_t write_entries(const Catalog& catalog, const CatalogFilter& filter, Sink& sink);

/// Limits on what is read from a file.
struct ForeignLimits {
  std::size_t line = std::size_t{8} << 20;  ///< bytes
  std::uint64_t entries = 1'000'000;
  std::uint64_t v = 2000;
  std::uint64_t b = 1'000'000;
  std::chrono::duration<double> time_each{30};  ///< for building and verifying one design
  std::uint64_t memory_each = std::uint64_t{128}
                              << 20;  ///< for the blocks of a design that is looked at as a whole
  bool skip_bad = false;              ///< leave out entries with false claims, and report them
};

/// The result of reading a file.
struct Foreign {
  std::vector<CatalogEntry> entries;       ///< not in the catalog yet, in the order of the file
  std::uint64_t known = 0;                 ///< number of those in the catalog already
  std::vector<std::string> left_out = {};  ///< one line each: where, which, why
};

/// Reads and verifies. Stops with the scope of this thread (run/control.hpp), and reports progress
/// to it. @throws BadInput with file and line for the first entry with a false claim or beyond the
/// limits, unless `skip_bad`; for a file that is not a catalog in any case. Stopped.
[[nodiscard]] Foreign read_foreign(Input& input, const Catalog& catalog,
                                   const ForeignLimits& limits = {});

/// The result of importing a file.
struct Imported {
  std::uint64_t added = 0;
  std::uint64_t improved = 0;  ///< of those: better than all that was known of their cells
  std::uint64_t known = 0;     ///< number of those in the catalog already, or twice in the file
  /// verified but not added because the control stopped; import the file again
  std::uint64_t not_added = 0;
  std::vector<std::string> left_out = {};  ///< as Foreign
};

/// read_foreign() and Catalog::add() for files of any length. Verified entries wait on the disk, so
/// nothing is added before the whole file is known to be good (except for what `skip_bad` leaves
/// out); then they are added `batch` at a time, and other processes can write in between. A process
/// that is killed leaves whole entries; importing the file again adds the rest. O(n log s) for n
/// entries and a catalog of s, besides building and verifying; memory for one batch. @throws as
/// read_foreign(), Catalog::add(); Stopped before anything is added.
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

/// The fewest blocks of each cell in a file or in a catalog. A file is read but not verified.
/// @throws BadInput as entry_from_line().
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

// Audit: builds every entry of the catalog and compares it with its claims.
//
//     RunControl control({.threads = 2});
//     const Audit audit = audit_catalog(catalog, {.v_to = 20, .best_only = false}, control);
//     audit.faults.empty();                                 // or what is wrong, entry by entry
//
// It reads the whole user's file: rows that contradict their lines and aliases that lead nowhere
// are faults. For each entry it builds the recipe, verifies the blocks, compares their checksum,
// and computes the lower bound again: an entry that claims a larger one claims more than is known.
//
// Cost: SHA-256 (a fifth), building, verifying, bounds and reading lines: 3,700 entries per second
// and thread of those that come with the program.

/// The result of an audit.
struct Audit {
  std::uint64_t entries = 0;  ///< that the filter lets through
  std::uint64_t checked = 0;  ///< this time
  struct Fault {
    std::string label;
    std::string what;
  };
  std::vector<Fault> faults;  ///< by label

  /// Whether everything was checked.
  [[nodiscard]] bool complete(std::uint64_t done_before = 0) const {
    return checked + done_before == entries;
  }
};

/// The labels that a filter lets through, and a checksum of all claims of their entries; the faults
/// of the user's file itself (Catalog::faults()), for every filter.
struct AuditScope {
  std::vector<std::string> labels;
  std::vector<Audit::Fault> faults;
  std::string checksum;
};
[[nodiscard]] AuditScope audit_scope(const Catalog& catalog, const CatalogFilter& filter);

/// Checks the entries of a scope on the control's threads, except for those in `done`; calls
/// good(label) for each entry whose claims are true, never twice at once. Stops with the control:
/// Audit::complete() is then false.
[[nodiscard]] Audit audit_entries(const Catalog& catalog, const AuditScope& scope,
                                  RunControl& control, const std::set<std::string>& done = {},
                                  const std::function<void(const std::string&)>& good = {});
/// Verifies again all entries that a filter lets through.
[[nodiscard]] inline Audit audit_catalog(const Catalog& catalog, const CatalogFilter& filter,
                                         RunControl& control) {
  return audit_entries(catalog, audit_scope(catalog, filter), control);
}

/// What is wrong with one entry; empty if it is valid. A RunControl scope of the calling thread can
/// stop it.
[[nodiscard]] std::string fault_of_entry(const CatalogEntry& entry);

// Searches where the catalog is weakest, and submission of the user's designs that are better than
// those of the program.
//
//     RunControl control({.time = std::chrono::seconds(2)});
//     const auto finds = improve_catalog(catalog, {.v_to = 9, .k_to = 4}, control);
//     const Submission submission = write_submission(catalog, sink);   // lines for the maintainers
//
// Every find is verified and in the user's file before the search goes to the next cell: if the
// search is killed, only the current cell is lost.
//
// Cost: that of the local search (search/local_search.hpp), and up to a second per cell, in which
// the closure rules find its best recipe.

struct CatalogSearch {
  /// The time for a cell in the first pass over all cells; each later pass doubles it. If not
  /// given, a fiftieth of the remaining time, at least 1 s and at most 60 s.
  std::optional<std::chrono::duration<double>> each = {};
  Introduction introduction = {};  ///< of the finds; program and command are filled in
};

/// A cell that became better.
struct CatalogFind {
  std::string label;
  Parameters parameters;
  std::uint64_t before = 0;
  std::uint64_t b = 0;
  std::string how;  ///< one line
};

/// Searches for better designs of the cells that the filter lets through and whose best design has
/// more blocks than the lower bound. It passes over these cells again and again until the control
/// stops. Cells whose gap is largest relative to their number of blocks come first; among equals
/// the smaller ones, because more designs are made from those. Calls found() for each find after it
/// is in the user's file. @throws as Catalog::add(); BadInput as newcomer_of().
[[nodiscard]] std::vector<CatalogFind> improve_catalog(
    Catalog& catalog, const CatalogFilter& filter, RunControl& control,
    const CatalogSearch& search = {}, const std::function<void(const CatalogFind&)>& found = {});

/// The user's designs that are better than all that come with the program, the best of each cell.
struct Submission {
  std::vector<std::string> labels;    ///< of the entries, in order
  std::vector<std::string> left_out;  ///< entries with false claims: label and why, one line each
};

/// Writes them as write_entries() does, after building and verifying each. An entry is better if it
/// has fewer blocks than every design of its cell that comes with the program and than
/// constructions that need no catalog. @throws as Sink::write().
[[nodiscard]] Submission write_submission(const Catalog& catalog, Sink& sink);

}  // namespace changeover
