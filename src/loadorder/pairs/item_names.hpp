// Internal: the rules for names of items, the same in every list of load orders.
//
//     as_number("+01.0")                  // "1": written like a number, in another way
//     check_item_name(rows, field)        // refuses what cannot be seen, a '|', 256 bytes
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "changeover/core/block.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {

/// The number of a plain decimal below most_items; nullopt otherwise.
[[nodiscard]] std::optional<Element> item_number(const Field& field);

/// The canonical form of a word that is written like a number: digits, possibly with a sign,
/// leading zeros or a point. Nullopt for all other words.
[[nodiscard]] std::optional<std::string> as_number(std::string_view word);

/// @throws BadInput with the place of a name that is too long, or has an invisible character or a
/// '|'.
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
