// Writing entries into one database.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "catalog/store/database.hpp"
#include "catalog/store/schema.hpp"
#include "changeover/catalog/entry.hpp"

namespace changeover {

// Puts entries into a database, within the caller's transaction.
class Filler {
 public:
  explicit Filler(const Database& database)
      : add_credit_(database.prepare("INSERT OR IGNORE INTO credit(json) VALUES(?)")),
        credit_(database.prepare("SELECT id FROM credit WHERE json = ?")),
        add_(database.prepare("INSERT INTO design VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?)")),
        retract_(database.prepare("INSERT OR REPLACE INTO retraction VALUES(?,?)")) {}

  void add(const CatalogEntry& entry) {
    // The credit is a header, so that one reader reads it.
    const std::string credit = header_line(entry.credit);
    add_credit_.with(std::string_view(credit)).step();
    credit_.with(std::string_view(credit)).step();
    const std::uint64_t credit_id = credit_.integer(0);
    CatalogEntry plain = entry;
    plain.retracted.clear();
    const std::string line = line_of(plain, entry.credit);
    const std::string label = entry.label();
    const Parameters& p = entry.parameters;
    add_.with(std::string_view(label), p.v, p.k, p.change, code_of(p.kind),
              std::uint64_t{p.strength}, entry.b, entry.lower_bound,
              std::uint64_t{entry.carries_blocks() ? 1U : 0U},
              std::string_view(entry.recipe.construction), std::string_view(entry.credit.date),
              credit_id, std::string_view(line))
        .step();
    if (!entry.retracted.empty()) {
      retract(label, entry.retracted);
    }
  }

  void retract(std::string_view label, std::string_view why) { retract_.with(label, why).step(); }

 private:
  Statement add_credit_, credit_, add_, retract_;
};

}  // namespace changeover
