// One design in the catalog: a line of text.
//
//     CatalogEntry entry = entry_from_line(
//         R"({"label":"4.3.1.linear.3.fdc879cf","b":3,"lower_bound":3,"reason":"counting",)"
//         R"("recipe":{"construction":"literal","v":4,"k":3,"change":1,"kind":"linear",)"
//         R"("arguments":{},"inputs":[],"blocks":[[0,1,2],[0,1,3],[0,2,3]]},)"
//         R"("sha256":"fdc879cf58d819b2f1550061bf579ec55c0ec7cd10f723344cd6bba2b4e4cf12"})",
//         "mine.jsonl", 1, {});
//     entry.status();                        // "minimum": as many blocks as the bound
//     line_of(entry, {});                    // the same line
//
// A file consists of such lines, one JSON object each, after a first line with its format and what
// its lines share:
//
//     {"format":"changeover-catalog/1","credit":{"who":"A. Researcher","date":"2026-11-22",
//      "program":"changeover 0.1.0"}}
//
// Keys come in this order; those in brackets may be missing: label, b, lower_bound, reason, recipe,
// sha256, [cites], [note], [credit], [retracted]. The label has the parameters. A recipe is data
// (core/design.hpp): blocks ("literal"), base blocks ("developed"), or a tree of constructions
// whose leaf "found" names a design of the catalog by its label. Every program writes the same
// bytes for an entry, so that files can be compared line by line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/sha256.hpp"

namespace changeover {

/// The source of a design. Any of these may be empty.
struct Credit {
  std::string who;      ///< a person, a group, a paper's authors
  std::string date;     ///< "2026-11-22"
  std::string program;  ///< "changeover 0.1.0"
  std::string command;  ///< "changeover search 20 5 --seed 3 --time 60s"

  bool operator==(const Credit&) const = default;
};

/// A design with its bound, credit and notes.
struct CatalogEntry {
  Parameters parameters;
  std::uint64_t b = 0;            ///< number of blocks
  std::uint64_t lower_bound = 0;  ///< the one known when the entry was written
  std::string reason;             ///< of the bound, one line
  Recipe recipe;
  Checksum checksum = {};  ///< of the blocks; see design_digest()
  std::vector<std::string>
      cites;         ///< keys of docs/references.bib, if the design is from the literature
  std::string note;  ///< one line
  Credit credit;
  std::string retracted;  ///< why the entry is retracted; empty if it is not

  [[nodiscard]] std::string label() const;

  /// "minimum" if b is the bound, "best-known" if not; "retracted".
  [[nodiscard]] std::string_view status() const;

  /// Whether it carries its blocks or base blocks, instead of a tree of constructions.
  [[nodiscard]] bool carries_blocks() const;

  bool operator==(const CatalogEntry&) const = default;
};

/// The line of an entry, without a line feed. A credit that is `shared` is left out.
[[nodiscard]] std::string line_of(const CatalogEntry& entry, const Credit& shared);

/// The longest line that can be read.
inline constexpr std::size_t longest_catalog_line = std::size_t{64} << 20;

/// Reads an entry from its line; a missing credit is `shared`. Builds nothing: the caller checks
/// that the blocks are a design and have this checksum.
/// @param name of the file, and the line's number, for messages.
/// @throws BadInput with file and line if it is malformed, a key is unknown or given twice, label
/// and recipe disagree, there are no blocks or fewer than the bound, or a text has unprintable
/// characters.
[[nodiscard]] CatalogEntry entry_from_line(std::string_view line, const std::string& name,
                                           std::uint64_t number, const Credit& shared);

/// A file's first line.
[[nodiscard]] std::string header_line(const Credit& shared);

/// The credit that lines share, from the first line. @throws BadInput if it is not the first line
/// of a catalog, or of an unknown version.
[[nodiscard]] Credit shared_from_header(std::string_view line, const std::string& name);

/// Reads a catalog's text in memory.
struct CatalogText {
  Credit shared;
  std::vector<CatalogEntry> entries;
};
[[nodiscard]] CatalogText read_catalog(std::string_view text, const std::string& name);

// Labels: permanent names of cells and of designs.
//
//     const Parameters p{.v = 20, .k = 5, .change = 2, .kind = Kind::linear};
//     cell_label(p);                                             // "20.5.2.linear"
//     DesignLabel label = parse_design_label("20.5.2.linear.39.3fa9c1d2").value();
//     label.b;                                                   // 39
//
// A *cell* is v.k.m.kind, followed by .t3 if the strength is 3 instead of 2. The label of a
// *design* is its cell, its number of blocks, and the first eight digits of the SHA-256 of its
// blocks: one line per block, elements as numbers separated by one blank, in the order in which
// they are written. That is a design's text without its comments:
//
//   changeover catalog show 26.4.2.circular.65 --format text | grep -v '^#' | sha256sum
//
// So a label depends on the design only: two people who publish the same list of blocks give it the
// same label, two databases do not give one label to two designs, and there is no counter. The same
// design in another order of blocks or with other names has another label.

/// "61.4.2.circular", "6.4.1.linear.t3".
[[nodiscard]] std::string cell_label(const Parameters& p);

/// The parameters of a cell; nullopt if the text is not what cell_label() writes.
[[nodiscard]] std::optional<Parameters> parse_cell_label(std::string_view text);

/// The number of digits of a checksum in a label.
inline constexpr std::size_t label_digits = 8;

/// The parts of a design's label.
struct DesignLabel {
  Parameters parameters;
  std::uint64_t b = 0;
  std::string digits;  ///< the first eight of the checksum

  bool operator==(const DesignLabel&) const = default;
};

/// "20.5.2.linear.39.3fa9c1d2".
[[nodiscard]] std::string design_label(const Parameters& p, std::uint64_t b,
                                       const Checksum& checksum);

/// nullopt if the text is not what design_label() writes.
[[nodiscard]] std::optional<DesignLabel> parse_design_label(std::string_view text);

/// Whether a reader could take the text for a label or the beginning of one, of a cell or of a
/// design: "20", "20.5.2.linear.29". Upper and lower case and blanks make no difference. An alias
/// cannot be such a text.
[[nodiscard]] bool reads_as_label(std::string_view text);

/// Computes the checksum of blocks as they are read, and their number.
struct DesignDigest {
  Checksum checksum = {};
  std::uint64_t b = 0;
};

/// Reads the stream to its end. O(bk); constant memory. @throws as BlockSource::read().
[[nodiscard]] DesignDigest design_digest(BlockSource& source);

}  // namespace changeover
