// The inside of a Catalog: the program's shelf, the user's shelf, and what is known about them.
#pragma once

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "catalog/store/database.hpp"
#include "catalog/store/schema.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"

namespace changeover {

// Looking entries up in one database.
//
//     Shelf shelf(Database::open("mine.db", Access::read));
//     for (Statement& rows = shelf.cell(p); rows.step();) {
//       CatalogEntry entry = shelf.read(rows);
//     }

inline constexpr std::string_view entry_columns =
    "design.label, design.line, credit.json, v, k, change, kind, strength, b, lower_bound, "
    "carries_blocks, construction, date FROM design LEFT JOIN credit ON credit.id = design.credit ";
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
  [[nodiscard]] bool has_cell(const Parameters& p) {
    const ResetLater later(counts_);
    return counts(p).step();
  }
  [[nodiscard]] std::optional<std::string> alias(std::string_view text) {
    return word(alias_, text);
  }
  [[nodiscard]] std::optional<std::string> retraction(std::string_view label) {
    return word(retraction_, label);
  }

  /// The entry of a row of entry_columns. @throws BadInput if it is damaged, or contradicts its
  /// row.
  [[nodiscard]] CatalogEntry read(const Statement& row) {
    const std::string& name = database_.name();
    try {
      CatalogEntry entry = entry_from_line(row.view(1), name, 1, credit(row.view(2)));
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

  // Thousands of entries share one: it is read once for those that follow each other.
  const Credit& credit(std::string_view header) {
    if (!credit_ || header != credit_->first) {
      credit_.reset();
      Credit read = shared_from_header(header, database_.name());
      credit_.emplace(std::string(header), std::move(read));
    }
    return credit_->second;
  }

  std::optional<std::pair<std::string, Credit>> credit_;  // the header that was read last
  Database database_;
  Statement cell_, counts_, label_, has_, begins_, alias_, retraction_;
};

class Catalog::Store {
 public:
  explicit Store(Files files) : user_path(std::move(files.user)) {
    if (!files.shipped.empty()) {
      shipped.emplace(Database::of_image(files.shipped));
    }
  }

  // The user's file, if it is there and can be read.
  Shelf* users() {
    if (!user && !user_path.empty() && problem.empty() && time_to_look()) {
      try {
        if (is_file(user_path)) {
          open_user();
        }
      } catch (const Error& fault) {
        problem = fault.what();
      }
    }
    return user && problem.empty() ? &*user : nullptr;
  }

  // Reads from the user's file; if it is damaged, goes on as if it were not there.
  template <typename Result, typename Read>
  Result from_users(Result otherwise, Read&& read) {
    if (Shelf* const shelf = users()) {
      try {
        return read(*shelf);
      } catch (const InternalError&) {
        throw;
      } catch (const Error& fault) {
        if (writing) {
          throw;
        }
        problem = fault.what();  // It stays open: a caller further up may be reading from it.
      }
    }
    return otherwise;
  }

  // Why an entry is retracted, in either database; empty if it is not.
  std::string retraction(std::string_view label) {
    if (const auto place = distrusted.find(label); place != distrusted.end()) {
      return place->second;
    }
    if (shipped) {
      if (auto why = shipped->retraction(label)) {
        return *why;
      }
    }
    return from_users(std::string(),
                      [&](Shelf& shelf) { return shelf.retraction(label).value_or(""); });
  }

  CatalogEntry read(Shelf& shelf, const Statement& row) {
    CatalogEntry entry = shelf.read(row);
    entry.retracted = retraction(entry.label());
    return entry;
  }

  // As Catalog::best().
  std::optional<CatalogEntry> best(const Parameters& p) {
    // A damaged entry shuts the user's file; the next try is without it.
    for (int tries = 0; tries < 3; ++tries) {
      const auto known = fewest(p, false);
      auto entry = known ? exact(known->label) : std::nullopt;
      if (!known || (entry && entry->retracted.empty())) {
        return entry;
      }
    }
    return std::nullopt;
  }

  // As Catalog::fewest(). O(n) for n designs of the cell with as few blocks.
  std::optional<Known> fewest(const Parameters& p, bool carries_blocks) {
    const auto look = [&](Shelf& shelf) -> std::optional<Known> {
      std::optional<Known> best;
      Statement& rows = shelf.counts(p);
      const ResetLater later(rows);
      while (rows.step()) {
        if (best && rows.integer(1) != best->b) {
          break;
        }
        const bool carries = rows.integer(2) != 0;
        if ((best && carries) || (carries_blocks && !carries) ||
            !retraction(rows.view(0)).empty()) {
          continue;
        }
        const auto label = parse_design_label(rows.view(0));
        if (!label || label->parameters != p || label->b != rows.integer(1)) {
          throw BadInput(fmt::format("{}: the entry {} is damaged; restore a copy",
                                     shelf.database().name(), rows.view(0)));
        }
        best = Known{rows.text(0), label->b, shipped && &shelf == &*shipped};
        if (carries == carries_blocks) {
          break;  // No other entry precedes it.
        }
      }
      return best;
    };
    std::optional<Known> best = shipped ? look(*shipped) : std::nullopt;
    auto own = from_users(std::optional<Known>(), look);
    return own && (!best || own->b < best->b) ? own : best;
  }

  std::optional<CatalogEntry> exact(std::string_view label) {
    const auto read_it = [&](Shelf& shelf) {
      Statement& row = shelf.entry(label);
      const ResetLater later(row);
      return row.step() ? std::optional(read(shelf, row)) : std::nullopt;
    };
    if (shipped) {
      if (auto entry = read_it(*shipped)) {
        return entry;
      }
    }
    return from_users(std::optional<CatalogEntry>(), read_it);
  }

  // The label that an alias leads to; empty if there is no such alias. An alias that reads as a
  // label, which an older program allowed, is not used.
  std::string behind_alias(std::string_view text) {
    const auto look = [&](Shelf& shelf) { return shelf.alias(text).value_or(""); };
    std::string label = shipped ? look(*shipped) : "";
    label = label.empty() ? from_users(std::string(), look) : label;
    if (label.empty() || !reads_as_label(text)) {
      return label;
    }
    remark = fmt::format(
        "{}: the alias {} is not used, because it reads as a label; remove it with changeover "
        "catalog alias --remove {}",
        user_path, text, text);
    return "";
  }

  // The user's file, checked and open for writing; made if it is not there.
  Shelf& to_write();

  // The same within one task, for which it was checked before. @throws MissingResource if another
  // file has its name by now.
  Shelf& still_to_write();

  // Adds entries in one transaction. The best of their cells before is looked up once and kept in
  // `fewest_of`.
  std::vector<Added> put(Shelf& own, std::span<const CatalogEntry> entries,
                         std::map<Parameters, std::uint64_t>& fewest_of);

  std::optional<Shelf> shipped;
  std::optional<Shelf> user;
  std::string user_path;
  std::string problem;
  std::string remark;
  bool writing = false;  // A failure to read then is reported as one of writing.
  std::map<std::string, std::string, std::less<>> distrusted;  // label, why
  std::mutex mutex;

 private:
  void open_user();

  // Whether a missing file may exist by now. A check takes eight system calls, and a table asks
  // thousands of times.
  bool time_to_look() {
    constexpr auto pause = std::chrono::milliseconds(10);
    const auto now = std::chrono::steady_clock::now();
    if (looked_ && now - *looked_ < pause) {
      return false;
    }
    looked_ = now;
    return true;
  }

  std::optional<std::chrono::steady_clock::time_point> looked_;
  std::optional<std::pair<std::uint64_t, std::uint64_t>> checked_;  // device and number of the file
};

}  // namespace changeover
