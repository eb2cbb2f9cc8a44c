// What the verbs of the catalog share: whose catalog, and which of its entries.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "cli/cli.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"

namespace changeover::cli {

/// [--catalog FILE].
struct CatalogRequest {
  std::string path;

  /// Must live as long as the verb.
  void add_to(Verb& verb);

  /// The catalog: what comes with the program, and the user's designs in FILE if one was named.
  /// What is wrong with that file is said by Program::run(), once the verb has answered; what is
  /// thrown instead ends with left_out().
  [[nodiscard]] Catalog& open() const;

  /// The same for a verb that changes the user's designs: not before its answer has a place.
  /// @throws MissingResource if `output` cannot be written.
  [[nodiscard]] Catalog& open_to_change(const OutputRequest& output) const;
};

/// Answer::done_before of such a verb.
inline constexpr const char* catalog_was_changed = "the catalog was changed as asked";

/// For a label, or its beginning, that leads nowhere: that the catalog has no such design, and
/// where to look; in one line.
[[nodiscard]] std::string has_no_design(const std::string& label);

/// What V [K] or LABEL names: cells, or a design.
struct CellsOrEntry {
  std::vector<Parameters> cells;
  std::optional<CatalogEntry> entry;  ///< then there are no cells
};

/// `what` is V, a label of a cell or of a design, or the beginning of one; with `k` it is V.
/// Nothing if the catalog has no such design: has_no_design(). @throws UsageError
[[nodiscard]] std::optional<CellsOrEntry> cells_or_entry(const Catalog& catalog,
                                                         const ParameterRequest& asked,
                                                         const std::string& what,
                                                         const std::string& k);

/// "; your own catalog was left out: …", where that is so: for a fault that comes instead of an
/// answer.
[[nodiscard]] std::string left_out();

/// [--k A..B] [--v C..D] [--change M] [--circular | --linear] [--strength T] [--status WORD] [--gap
/// N] [--construction NAME] [--since DATE] [--all | --best] [--users].
struct FilterRequest {
  std::string k, v, status, construction, since;
  std::optional<std::uint64_t> change, strength, gap;
  std::optional<Kind> kind;
  bool all = false;
  bool users = false;

  /// When all designs of a cell are meant, and not the best only.
  enum class Unless : std::uint8_t { all_is_not_asked_for, best_is_asked_for };
  void add_to(Verb& verb, Unless unless = Unless::all_is_not_asked_for);

  /// @throws UsageError
  [[nodiscard]] CatalogFilter filter() const;
};

}  // namespace changeover::cli
