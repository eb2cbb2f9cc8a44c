// Looking entries up in one database.
//
//     Shelf shelf(Database::open("mine.db", Access::read));
//     for (Statement& rows = shelf.cell(p); rows.step();) {
//       CatalogEntry entry = shelf.read(rows);
//     }
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "catalog/store/database.hpp"
#include "catalog/store/kinds.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"

namespace changeover {

inline constexpr std::string_view entry_columns =
    "design.label, design.line, credit.json, v, k, change, kind, strength, b, lower_bound, "
    "carries_blocks, construction, date FROM design LEFT JOIN credit ON "
    "credit.id = design.credit ";
inline constexpr std::string_view of_cell =
    "WHERE k = ? AND v = ? AND change = ? AND kind = ? AND strength = ? ";
// Fewest blocks first; among equals those with a recipe.
inline constexpr std::string_view as_ranked = "ORDER BY b, carries_blocks, label";

// The statements that look entries up in one database, prepared once.
class Shelf {
 public:
  explicit Shelf(Database database)
      : database_(std::move(database)),
        cell_(database_.prepare(fmt::format("SELECT {}{}{}", entry_columns, of_cell, as_ranked))),
        counts_(database_.prepare(fmt::format(
            "SELECT label, b, carries_blocks FROM design {}ORDER BY b, label", of_cell))),
        label_(database_.prepare(fmt::format("SELECT {}WHERE label = ?", entry_columns))),
        has_(database_.prepare("SELECT 1 FROM design WHERE label = ?")),
        begins_(database_.prepare(
            "SELECT label FROM design WHERE label >= ?1 AND label < ?1 || '~' ORDER BY label")),
        alias_(database_.prepare("SELECT label FROM alias WHERE alias = ?")),
        retraction_(database_.prepare("SELECT why FROM retraction WHERE label = ?")) {}

  [[nodiscard]] const Database& database() const { return database_; }

  Statement& cell(const Parameters& p) { return of(cell_, p); }
  Statement& counts(const Parameters& p) { return of(counts_, p); }
  Statement& entry(std::string_view label) { return label_.with(label); }
  Statement& begins(std::string_view text) { return begins_.with(text); }
  [[nodiscard]] bool has(std::string_view label) {
    const ResetLater later(has_);
    return has_.with(label).step();
  }
  [[nodiscard]] std::optional<std::string> alias(std::string_view text) {
    return word(alias_, text);
  }
  [[nodiscard]] std::optional<std::string> retraction(std::string_view label) {
    return word(retraction_, label);
  }

  /// The entry of a row of entry_columns. @throws BadInput if it is damaged, or contradicts its
  /// row.
  [[nodiscard]] CatalogEntry read(const Statement& row) const {
    const std::string& name = database_.name();
    try {
      const Credit credit = shared_from_header(row.view(2), name);
      CatalogEntry entry = entry_from_line(row.view(1), name, 1, credit);
      if (entry.label() != row.view(0)) {
        throw BadInput("its line is the one of " + entry.label());
      }
      const Parameters& p = entry.parameters;
      if (std::array{p.v, p.k, p.change, code_of(p.kind), std::uint64_t{p.strength}, entry.b} !=
          std::array{row.integer(3), row.integer(4), row.integer(5), row.integer(6), row.integer(7),
                     row.integer(8)}) {
        throw BadInput("it is in the place of a design with other parameters or blocks");
      }
      if (std::array{entry.lower_bound, std::uint64_t{entry.carries_blocks() ? 1U : 0U}} !=
              std::array{row.integer(9), row.integer(10)} ||
          entry.recipe.construction != row.view(11) || entry.credit.date != row.view(12)) {
        throw BadInput("its row has another bound, construction or day than its line");
      }
      return entry;
    } catch (const BadInput& fault) {
      throw BadInput(fmt::format("{}: the entry {} is damaged ({}); restore a copy", name,
                                 row.view(0), fault.what()));
    }
  }

 private:
  static std::optional<std::string> word(Statement& statement, std::string_view key) {
    const ResetLater later(statement);
    return statement.with(key).step() ? std::optional(statement.text(0)) : std::nullopt;
  }

  static Statement& of(Statement& statement, const Parameters& p) {
    return statement.with(p.k, p.v, p.change, code_of(p.kind), std::uint64_t{p.strength});
  }

  Database database_;
  Statement cell_, counts_, label_, has_, begins_, alias_, retraction_;
};

}  // namespace changeover
