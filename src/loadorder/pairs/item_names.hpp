// Internal: the rules for rows and names of items, the same in every list of load orders.
//
//     as_number("+01.0")                  // "1": written like a number, in another way
//     check_item_name(rows, field)        // refuses what cannot be seen, 256 bytes
//     each_item_row(rows, notes, is_heading, take)
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

/// How rows of items are read.
[[nodiscard]] RowOptions item_row_options();

/// Leaves out empty fields, and splits a row that is one word between blanks at these.
void take_fields(Row& row, const RowReader& rows);

/// Notes that the first row was read as names of columns, with its place; nothing if `notes` is
/// null.
void note_heading(const RowReader& rows, const Row& heading, std::vector<std::string>* notes);

/// Notes that the first row was read as a pair of items, with its place; nothing if `notes` is
/// null.
void note_first_pair(const RowReader& rows, const Row& row, std::vector<std::string>* notes);

/// Calls `take` with each row that has fields, but not with a first one that is a heading, which is
/// noted.
template <typename IsHeading, typename Take>
void each_item_row(RowReader& rows, std::vector<std::string>* notes, const IsHeading& is_heading,
                   const Take& take) {
  Row row;
  for (bool first = true; rows.next_line();) {
    if (!rows.split(row)) {
      continue;
    }
    take_fields(row, rows);
    if (row.empty()) {
      continue;
    }
    if (std::exchange(first, false) && !rows.is_given() && is_heading(row)) {
      note_heading(rows, row, notes);
    } else {
      take(row);
    }
  }
}

/// The items of a graph by their names; nothing without a graph, or names.
[[nodiscard]] std::unordered_map<std::string, Element> items_by_name(const PairGraph* graph);

/// The number of a plain decimal below most_items; nullopt otherwise.
[[nodiscard]] std::optional<Element> item_number(const Field& field);

/// The canonical form of a word that is written like a number: digits, possibly with a sign,
/// leading zeros or a point. Nullopt for all other words.
[[nodiscard]] std::optional<std::string> as_number(std::string_view word);

/// @throws BadInput with the place of a name that is too long, or has an invisible character.
void check_item_name(const RowReader& rows, const Field& field);

/// @throws BadInput with the place of a number that is not written like the whole numbers before.
void check_written_plainly(const RowReader& rows, const Field& field);

/// Names that are numbers: each number must be written in one way.
class WrittenNumbers {
 public:
  /// @throws BadInput with its place for a name that is the same number as another name.
  void add(const RowReader& rows, const Field& field);
  void clear() { names_.clear(); }

 private:
  std::unordered_map<std::string, std::string> names_;  // by the number
};

}  // namespace changeover
