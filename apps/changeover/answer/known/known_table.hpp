// The best known design for every v and k of a range, as `table` shows it.
//
//     const KnownTable table = known_table({.k = {3, 8}, .v = {3, 40}, .change = 2});
//     table_json(table.cells(Kind::linear));
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer/answer.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/known_documents.hpp"
#include "request/parameters.hpp"

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

// What constructions offer for parameters, and the answer where nothing serves them.

/// The best that is known of some parameters, by construct/best_known.hpp with the standard
/// registry.
[[nodiscard]] std::optional<Offer> best_known(const Parameters& p);

/// The best offer over some kinds, circular before linear among equals; `construction` is the only
/// one that is asked, or empty. @throws UsageError if no construction has that name.
[[nodiscard]] std::optional<Offer> best_offer(const std::vector<Parameters>& asked,
                                              const std::string& construction);

/// What is known of parameters that nothing serves: why no design exists, or the lower bound, what
/// is near, what would help.
[[nodiscard]] Answer decline(const std::vector<Parameters>& asked, const std::string& construction,
                             const OutputRequest& output);

}  // namespace changeover::cli
