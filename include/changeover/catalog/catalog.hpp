// The catalog of known designs: those that come with the program and those of its user, looked up
// together.
//
//     Catalog catalog({.shipped = {}, .user = "mine.db"});     // only what is in a file, here
//     catalog.add(entry);
//     catalog.best(entry.parameters)->b;                       // fewest blocks
//     catalog.find(entry.label());  // by label, or by the beginning of one
//
// The designs of the program are a read-only database in memory (construct/registry.hpp).
// The designs of a user are in a file, an SQLite database of version `catalog_schema_version`,
// which is opened when it is first needed and made when it is first written. Looking up an entry
// costs a few microseconds; rows are read only when they are needed.
//
// A file that is damaged, of a newer version or of another program is never written to; one line
// says what it is and how to correct it. Before a file of an older version is converted, a copy of
// it is kept beside it. Writing is all or nothing, even if the process, the disk or the machine
// fails; several processes may write at once, each waits for the others.
//
// Thread-safe. The time goes into SQLite's look-up and the parsing of a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/catalog/entry.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

// Reported designs: numbers of blocks that publications state without blocks.
//
//     const Parameters p{.v = 26, .k = 6, .change = 1, .kind = Kind::linear};
//     reported_below(p, 64)->blocks;                // 63 [Bean2026]
//     reported_below(p, 63).has_value();            // false: it is not better
//
// Reported is not verified. A catalog holds blocks, which are verified; a report is only a number
// and its source. It is not a bound, and no other answer depends on it.

/// A design that a publication counts.
struct Reported {
  std::string_view cites;  ///< a key of docs/references.bib
  Parameters parameters;
  std::uint64_t blocks = 0;
};

/// All of them.
[[nodiscard]] std::span<const Reported> reported_designs();

/// The one with the fewest blocks for exactly these parameters, if that is fewer than `held`, the
/// number of blocks of the best design at hand; nullopt otherwise. Linear in the number of reports.
[[nodiscard]] std::optional<Reported> reported_below(const Parameters& p,
                                                     std::optional<std::uint64_t> held);

/// The publications that report a design with exactly these parameters and number of blocks, as
/// keys of docs/references.bib. Linear in the number of reports.
[[nodiscard]] std::vector<std::string> reporters_of(const Parameters& p, std::uint64_t blocks);

/// The version of a user's file that this program reads and writes.
inline constexpr int catalog_schema_version = 1;

/// How a cell came to its best design: one line of its history.
struct Improvement {
  std::string label;  ///< of the design
  std::uint64_t b = 0;
  std::string date;  ///< when it came in
  /// its source: citation, or the command that found it, and its credit, in one line
  std::string how;
};

/// A filter of entries; an empty one lets everything through.
struct CatalogFilter {
  std::optional<std::uint64_t> v_from = {}, v_to = {}, k_from = {}, k_to = {}, change = {};
  std::optional<Kind> kind = {};
  std::optional<std::uint32_t> strength = {};
  std::string status =
      {};  ///< "minimum", "best-known" or "retracted"; any that is not retracted if empty
  std::string construction = {};          ///< the name at the root of the recipe
  std::string since = {};                 ///< credited on this day or later
  std::optional<std::uint64_t> gap = {};  ///< at least this many blocks over the bound
  bool best_only = true;                  ///< only the best of each cell
  bool users_only = false;                ///< only those of the user
};

/// The result of adding an entry.
enum class Added : std::uint8_t { improved, added, already_there };

class Catalog {
 public:
  struct Files {
    std::span<const std::byte> shipped =
        {};                 ///< an image that make_catalog() made; must outlive this
    std::string user = {};  ///< path; none if empty
  };

  explicit Catalog(Files files);
  ~Catalog();
  Catalog(const Catalog&) = delete;
  Catalog& operator=(const Catalog&) = delete;

  /// The known design for p with the fewest blocks that is not retracted; ties go to the one that
  /// comes with the program, then to one that does not carry its blocks, then to the smaller label.
  /// @throws BadInput if the entry is damaged.
  [[nodiscard]] std::optional<CatalogEntry> best(const Parameters& p) const;

  /// The size of what best() returns, without reading it; `carries_blocks`: only among entries that
  /// carry their blocks.
  struct Known {
    std::string label;
    std::uint64_t b = 0;
    bool shipped = false;  ///< with the program; otherwise the user's
  };
  [[nodiscard]] std::optional<Known> fewest(const Parameters& p, bool carries_blocks = false) const;

  /// The entry of a label or an alias, or the only entry whose label begins with this text, which
  /// must have at least a whole cell. @throws BadInput if several labels begin so.
  [[nodiscard]] std::optional<CatalogEntry> find(std::string_view label) const;

  /// All entries of a cell, retracted ones too, fewest blocks first.
  [[nodiscard]] std::vector<CatalogEntry> cell(const Parameters& p) const;

  /// Calls take(entry) for each entry that the filter lets through, by change number, strength,
  /// kind, k, v, and within a cell in the order of best(), until take() returns false.
  void each(const CatalogFilter& filter,
            const std::function<bool(const CatalogEntry&)>& take) const;

  /// How the best of a cell became better, oldest first.
  [[nodiscard]] std::vector<Improvement> history(const Parameters& p) const;

  /// How many designs and cells there are, retracted ones too, and the last day on which one was
  /// credited. Without reading the entries.
  struct Size {
    std::uint64_t designs = 0;
    std::uint64_t cells = 0;
    std::string latest;
  };
  [[nodiscard]] Size size() const;

  /// Whether there are entries of the user's own, and the greatest v among them.
  [[nodiscard]] std::optional<std::uint64_t> largest_users_v() const;

  /// Why the user's file could not be read; empty if it could, or if there is none. Look-ups then
  /// go on without it.
  [[nodiscard]] std::string problem() const;

  /// A warning about the user's file, empty if there is none: an alias that was looked up but not
  /// used, because it reads as a label.
  [[nodiscard]] std::string remark() const;

  /// Ignores an entry from now on, in this process, because it is not the design that it claims.
  /// problem() reports it.
  void distrust(const std::string& label, const std::string& why) const;

  /// Whether the entry comes with the program.
  [[nodiscard]] bool is_shipped(std::string_view label) const;

  /// Adds entries to the user's file: all of them or, if it throws, none. It trusts them: for
  /// entries from elsewhere see curator/curator.hpp. Returns the result of each.
  /// @throws MissingResource if there is no user's file or it cannot be written.
  std::vector<Added> add(std::span<const CatalogEntry> entries);
  Added add(const CatalogEntry& entry) { return add(std::span(&entry, 1)).front(); }

  /// Adds the lists that next() returns until one is empty, each in a transaction; between two of
  /// them other processes can write. The file is checked once. Calls done() after each. What was
  /// added stays if a later list is refused. O(n log s) for n entries and a file of s.
  void add_lists(const std::function<std::vector<CatalogEntry>()>& next,
                 const std::function<void(std::span<const Added>)>& done);

  /// Marks an entry as retracted, with the reason; it stays in the catalog. The mark is in the
  /// user's file, also for an entry that comes with the program. @throws BadInput if no entry has
  /// that label; as add().
  void retract(std::string_view label, std::string_view why);

  /// Makes `alias` a name of the entry with that label. @throws BadInput if the alias reads as a
  /// label (catalog/entry.hpp) or leads to another design; as add().
  void alias(std::string_view alias, std::string_view label);

  /// Removes an alias of the user and returns the label that it led to. @throws BadInput if there
  /// is no such alias; as add().
  std::string remove_alias(std::string_view alias);

  /// The faults of the user's file itself: rows that contradict their lines, aliases that lead
  /// nowhere or read as labels, an index that misses rows. (curator/curator.hpp checks that entries
  /// are designs.) Empty if there is no file. Reads all of it.
  struct Fault {
    std::string label;  ///< or the alias, or "your own catalog"
    std::string what;
  };
  [[nodiscard]] std::vector<Fault> faults() const;

  /// The path of the user's file; empty if there is none.
  [[nodiscard]] const std::string& user_path() const;

 private:
  class Store;
  std::unique_ptr<Store> store_;
};

/// The image of a database with these entries, for Catalog::Files::shipped. Deterministic.
[[nodiscard]] std::vector<std::byte> make_catalog(std::span<const CatalogEntry> entries);

// The number of all designs with given parameters, up to names of elements, where exhaustive search
// has counted them.
//
//     const auto all = classified({.v = 9, .k = 4, .change = 1, .kind = Kind::circular}, 12);
//     all->classes;                    // 2 [McSorley1999]
//     all->groups;                     // "1:1 3:1"
//
// The counts are those of classify_designs() (search/enumeration.hpp), for designs with as few
// blocks as possible; that takes up to some seconds for each, here they are stored. Linear in the
// number of counts.

/// The counts for a number of blocks.
struct Classified {
  Parameters parameters;
  std::uint64_t b = 0;
  std::uint64_t standard_forms = 0;  ///< up to names of elements
  std::uint64_t classes = 0;         ///< up to rotation too, if circular
  std::uint64_t tight = 0;           ///< of the classes
  std::string_view groups = {};      ///< the number of classes for each order of a group
};

/// The count for exactly these parameters and blocks; nullopt if there is none.
[[nodiscard]] std::optional<Classified> classified(const Parameters& p, std::uint64_t b);

/// All counts.
[[nodiscard]] std::span<const Classified> classified_cells();

}  // namespace changeover
