#include "answer/known/known_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/construct/standard_catalog.hpp"
#include "cli/cli.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

std::string text_of(const Range& range) { return fmt::format("{}..{}", range.from, range.to); }

// The range that was asked for in these words. @throws UsageError if it is too large.
CellRange cell_range_of(const TableRange& asked, const std::string& k, const std::string& v) {
  if (asked.k.from < 2) {
    throw UsageError{fmt::format("--k {}: blocks have at least 2 elements; give 2 or more", k)};
  }
  if (asked.v.from < 2 || asked.v.to > largest_v_of_a_range) {
    throw UsageError{fmt::format("--v {}: a table goes from v = 2 to v = {}; give a range within",
                                 v, largest_v_of_a_range)};
  }
  if (asked.change < 1) {
    throw UsageError{"--change 0: consecutive blocks differ in at least 1 element; give 1 or more"};
  }
  if (asked.k.to - asked.k.from >= most_cells_of_a_range / 2 / (asked.v.to - asked.v.from + 1)) {
    throw UsageError{
        fmt::format("--k {} --v {}: the range has more than {} cells; give a smaller one", k, v,
                    most_cells_of_a_range)};
  }
  return {.v_from = asked.v.from,
          .v_to = asked.v.to,
          .k_from = asked.k.from,
          .k_to = asked.k.to,
          .change = asked.change,
          .kind = asked.kind};
}

}  // namespace

Cells KnownTable::cells(Kind kind) const {
  Cells cells;
  for (std::uint64_t k = asked_.k.from; k <= asked_.k.to; ++k) {
    for (std::uint64_t v = asked_.v.from; v <= asked_.v.to; ++v) {
      cells.push_back(&table_.at({.v = v, .k = k, .change = asked_.change, .kind = kind}));
    }
  }
  return cells;
}

TableRange table_range(const std::string& k, const std::string& v,
                       std::optional<std::uint64_t> change) {
  TableRange range{.k = range_of("--k", k, 2), .v = {}, .change = change.value_or(2)};
  range.v = range_of("--v", v, range.k.from);
  static_cast<void>(cell_range_of(range, k, v));
  return range;
}

void check_table(const TableRange& asked) {
  static_cast<void>(cell_range_of(asked, text_of(asked.k), text_of(asked.v)));
}

KnownTable known_table(const TableRange& asked, Stored stored) {
  return {asked,
          best_known_table(Registry::standard(),
                           cell_range_of(asked, text_of(asked.k), text_of(asked.v)), stored)};
}

std::string table_json(const Cells& cells, bool with_labels) {
  JsonWriter json;
  json.begin_array();
  for (const KnownCell* cell : cells) {
    const Parameters& p = cell->parameters;
    json.begin_object().key("v").value(p.v).key("k").value(p.k).key("change").value(p.change);
    json.key("kind").value(to_string(p.kind)).key("b");
    cell->best ? json.value(cell->best->b) : json.null();
    json.key("lower_bound");
    cell->impossible ? json.null() : json.value(cell->bound.blocks);
    json.key("status").value(cell->status()).key("construction");
    cell->best ? json.value(cell->best->recipe.construction) : json.null();
    if (with_labels) {
      const std::string label = cell->best ? label_of(*cell->best) : "";
      json.key("label");
      label.empty() ? json.null() : json.value(label);
    }
    json.end_object();
  }
  json.end_array();
  return json.take();
}

std::string label_of(const Offer& offer) {
  const Recipe& recipe = offer.recipe;
  if (recipe.construction == "found" && recipe.inputs.empty()) {
    return recipe.provenance;
  }
  // A label names blocks: other designs with as many blocks have others. The same recipe makes the
  // same blocks.
  const auto known = standard_catalog().fewest(recipe.parameters);
  if (!known || known->b != offer.b) {
    return "";
  }
  for (const CatalogEntry& entry : standard_catalog().cell(recipe.parameters)) {
    if (entry.b == offer.b && entry.retracted.empty() && entry.recipe == recipe) {
      return entry.label();
    }
  }
  return "";
}

}  // namespace changeover::cli
