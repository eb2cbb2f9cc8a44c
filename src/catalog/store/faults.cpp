// Contradictions in a user's file.
#include <fmt/format.h>

#include "catalog/store/store.hpp"
#include "core/printable.hpp"

namespace changeover {
namespace {

using Faults = std::vector<Catalog::Fault>;

void check_rows(const Shelf& shelf, Faults& faults) {
  for (Statement rows = shelf.database().prepare(fmt::format("SELECT {}", entry_columns));
       rows.step();) {
    try {
      static_cast<void>(shelf.read(rows));
    } catch (const BadInput& fault) {
      faults.push_back({printable(rows.view(0)), fault.what()});
    }
  }
}

// The faults that SQLite finds: an index that misses a row hides a design.
void check_structure(const Database& database, Faults& faults) {
  for (Statement rows = database.prepare("PRAGMA integrity_check(20)"); rows.step();) {
    if (rows.view(0) != "ok") {
      faults.push_back({"your own catalog", fmt::format("{}: damaged ({}); restore a copy",
                                                        database.name(), rows.view(0))});
    }
  }
}

}  // namespace

std::vector<Catalog::Fault> Catalog::faults() const {
  const std::lock_guard lock(store_->mutex);
  return store_->from_users(Faults(), [&](Shelf& shelf) {
    Faults faults;
    check_structure(shelf.database(), faults);
    check_rows(shelf, faults);
    const auto is_there = [&](std::string_view label) {
      return shelf.has(label) || (store_->shipped && store_->shipped->has(label));
    };
    for (Statement rows = shelf.database().prepare("SELECT alias, label FROM alias");
         rows.step();) {
      const std::string alias = printable(rows.view(0));
      const std::string mend =
          fmt::format("remove it with changeover catalog alias --remove '{}'", alias);
      if (reads_as_label(rows.view(0))) {
        faults.push_back({alias, "an alias that reads as a label, and is not used; " + mend});
      } else if (!is_there(rows.view(1))) {
        faults.push_back({alias, fmt::format("an alias that leads to {}, and there is no such "
                                             "design; {}",
                                             printable(rows.view(1)), mend)});
      }
    }
    return faults;
  });
}

}  // namespace changeover
