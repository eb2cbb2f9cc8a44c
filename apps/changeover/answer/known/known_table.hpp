// The best known design for every v and k of a range, as `table` shows it.
//
//     const KnownTable table = known_table({.k = {3, 8}, .v = {3, 40}, .change = 2});
//     table_json(table.cells(Kind::linear));
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/best_known.hpp"
#include "request/range.hpp"

namespace changeover::cli {

struct TableRange {
  Range k;
  Range v;
  std::uint64_t change = 2;
  std::optional<Kind> kind = {};  ///< only the cells of this kind; nullopt: both
};

/// As --k, --v and --change say it, where it is not too large. @throws UsageError.
[[nodiscard]] TableRange table_range(const std::string& k, const std::string& v,
                                     std::optional<std::uint64_t> change);

using Cells = std::vector<const KnownCell*>;

class KnownTable {
 public:
  KnownTable(const TableRange& asked, BestKnownTable table)
      : asked_(asked), table_(std::move(table)) {}

  [[nodiscard]] const TableRange& range() const { return asked_; }

  /// The cells of one kind, by k, then v. They live as long as the table.
  [[nodiscard]] Cells cells(Kind kind) const;

 private:
  TableRange asked_;
  BestKnownTable table_;
};

/// @throws UsageError if the range is too large. Takes no time.
void check_table(const TableRange& asked);

/// @throws as check_table() and best_known_table().
[[nodiscard]] KnownTable known_table(const TableRange& asked, Stored stored = Stored::as_shipped);

/// The document of `table --json`; `with_labels`: each cell has "label" too, of its design in the
/// catalog, or null.
[[nodiscard]] std::string table_json(const Cells& cells, bool with_labels = false);

/// The label in the catalog of the design that is offered; empty if it is not there.
[[nodiscard]] std::string label_of(const Offer& offer);

}  // namespace changeover::cli
