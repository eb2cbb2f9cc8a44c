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
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"

namespace changeover {

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

/// Reads and verifies. Listens to the scope of this thread (run/scope.hpp), and tells it.
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

}  // namespace changeover
