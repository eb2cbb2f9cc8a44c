#include "changeover/io/formats.hpp"
#include "core/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>

#include "core/words.hpp"
#include "io/read/declared.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "io/scan/text_scanner.hpp"
#include "io/write/csv_cell.hpp"

namespace changeover {
namespace {

Place place_of_field(const Field& field) { return {field.line, field.offset + 1}; }

// "element_3", "element 3", "Element3".
bool is_element_column(std::string_view name) {
  if (!name.starts_with("element")) {
    return false;
  }
  name.remove_prefix(std::string_view("element").size());
  name.remove_prefix(name.starts_with('_') || name.starts_with(' ') ? 1 : 0);
  return plain_number(name).has_value();
}

constexpr std::array<std::string_view, 6> constants = {"v",    "k",        "change",
                                                       "kind", "strength", "elements"};

// What each column of the file is.
class Columns {
 public:
  // Learns them from the first record; false if that is no list of names.
  bool learn(const Row& fields, const RowReader& rows) {
    bool names = false;
    for (const Field& field : fields) {
      const std::string name = lower_case(field.text);
      names = names || name == "block" || is_element_column(name);
    }
    if (!names) {
      return false;
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string name = lower_case(fields[i].text);
      if (is_element_column(name)) {
        elements_.push_back(i);
      }
      const auto constant = std::ranges::find(constants, name);
      if (constant != constants.end()) {
        std::optional<std::size_t>& column =
            constant_columns_[static_cast<std::size_t>(constant - constants.begin())];
        if (column) {
          rows.fail(fields[i], fmt::format("two columns {}; remove one", name));
        }
        column = i;
      }
    }
    if (elements_.empty()) {
      rows.fail(fields[0],
                "no columns element_1, element_2, …; give the columns of elements these names");
    }
    // A file without the columns of the program may have blocks alone, of elements called so.
    if (elements_.size() == fields.size()) {
      for (const Field& field : fields) {
        heads_.insert(field.text);
      }
    }
    named_ = true;
    return true;
  }

  // Adds the elements of a record to the block.
  void add_elements(const Row& fields, const RowReader& rows, Collector& collector) const {
    for (std::size_t i = 0; i < (named_ ? elements_.size() : fields.size()); ++i) {
      const std::size_t column = named_ ? elements_[i] : i;
      if (column >= fields.size() || fields[column].text.empty()) {
        continue;
      }
      const Field& field = fields[column];
      if (field.text.size() > max_token_bytes) {
        rows.fail(field,
                  fmt::format("a field of more than {} bytes; use shorter names", max_token_bytes));
      }
      if (!heads_.empty() && heads_.contains(field.text)) {
        rows.fail(field, fmt::format("{} is an element here and the name of a column in the first "
                                     "row; rename the elements",
                                     shown(field.text)));
      }
      const std::string_view word = csv_text(field.text);
      auto defect = named_ ? std::nullopt : loose_word_defect(word, i == 0);
      defect = defect ? defect : word_defect(word);
      defect = defect ? defect : collector.add(word);
      if (defect) {
        rows.fail(field, *defect);
      }
    }
  }

  // Compares the record's statements about the whole design with those of the first one.
  void check_constants(const Row& fields, const RowReader& rows, ReadOptions& found, bool& labels,
                       std::optional<Place>& place) {
    for (std::size_t i = 0; i < constants.size(); ++i) {
      const auto column = constant_columns_[i];
      if (!column || *column >= fields.size() || fields[*column].text.empty()) {
        continue;
      }
      const Field& field = fields[*column];
      if (!said_[i].empty()) {
        if (field.text != said_[i]) {
          rows.fail(field, fmt::format("{} is {} here and {} in the rows before; make them equal",
                                       constants[i], shown(field.text), shown(said_[i])));
        }
        continue;
      }
      said_[i] = field.text;
      place = place.value_or(place_of_field(field));
      if (constants[i] == "elements") {
        if (field.text != "labels" && field.text != "numbers") {
          rows.fail(field,
                    "the column elements says neither labels nor numbers; write one of them");
        }
        labels = field.text == "labels";
      } else if (const auto defect = declare(found, constants[i], field.text)) {
        rows.fail(field, *defect);
      }
    }
  }

  // The place of element `which` (from 0) of a row.
  Place place_of(const Row& fields, std::uint64_t which) const {
    for (std::size_t i = 0; i < (named_ ? elements_.size() : fields.size()); ++i) {
      const std::size_t column = named_ ? elements_[i] : i;
      if (column < fields.size() && !fields[column].text.empty() && which-- == 0) {
        return place_of_field(fields[column]);
      }
    }
    return place_of_field(fields[0]);
  }

 private:
  bool named_ = false;
  std::unordered_set<std::string> heads_;  // the first row, if it may be a block
  std::vector<std::size_t> elements_;
  std::array<std::optional<std::size_t>, constants.size()> constant_columns_;
  std::array<std::string, constants.size()> said_;
};

}  // namespace

Design read_csv(Input& input, const ReadOptions& options) {
  std::string bytes = read_to_end(input);
  if (const auto defect = table_defect(without_byte_order_mark(bytes).substr(0, 1U << 16))) {
    fail(input.name(), {}, *defect);
  }
  const auto text = input_from_text(std::move(bytes), input.name());
  RowReader rows(*text, RowOptions::of_any_length());
  const auto next_of = [](RowReader& reader, Row& row) {
    while (reader.next_line()) {
      if (reader.split(row)) {
        return true;
      }
    }
    return false;
  };
  Columns columns;
  Row fields;
  bool more = next_of(rows, fields);
  const bool header = more && columns.learn(fields, rows);
  more = header ? next_of(rows, fields) : more;

  Collector collector;
  ReadOptions found;
  bool labels = false;
  std::size_t k = 0;
  std::optional<Place> place;
  for (; more; more = next_of(rows, fields)) {
    columns.check_constants(fields, rows, found, labels, place);
    columns.add_elements(fields, rows, collector);
    k = k != 0 ? k : collector.block_size();
    if (const auto defect = collector.end_block()) {
      rows.fail(fields.back(), *defect);
    }
  }
  Collector::Context context{.name = input.name(),
                             .declared = merged(input.name(), options, found),
                             .labels = std::nullopt,
                             .labels_place = {},
                             .place = place.value_or(Place()),
                             .named = labels,
                             .place_of_word = [&](std::uint64_t word) {
                               text->rewind();
                               RowReader reader(*text, RowOptions::of_any_length());
                               Row row;
                               for (std::uint64_t i = 0; i <= word / k + (header ? 1 : 0); ++i) {
                                 static_cast<void>(next_of(reader, row));
                               }
                               return columns.place_of(row, word % k);
                             }};
  return collector.finish(context);
}

}  // namespace changeover
