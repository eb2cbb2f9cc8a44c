// A user's database with entries at random: read as they were added; with a row that was damaged,
// what is handed out is what was asked for, and the rest is said in one line.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "../entries.hpp"
#include "catalog/store/database.hpp"
#include "damage.hpp"
#include "run_program.hpp"

namespace changeover::test::rows_property_test {
namespace {

using Entries = std::map<std::string, CatalogEntry>;

Entries some_entries(std::uint32_t seed) {
  std::mt19937 random(seed);
  Entries entries;
  for (std::uint64_t count = 1 + some_number(4); count > 0; --count) {
    const CatalogEntry entry = random_entry(random);
    entries.emplace(entry.label(), entry);
  }
  return entries;
}

std::vector<std::byte> image_of(const Entries& entries) {
  std::vector<CatalogEntry> list;
  for (const auto& [label, entry] : entries) {
    list.push_back(entry);
  }
  return make_catalog(list);
}

// A new file, which no disk is waited for.
void put(const std::string& path, const Entries& entries) {
  std::filesystem::remove(path);
  const std::vector<std::byte> image = image_of(entries);
  spit(path, std::string(reinterpret_cast<const char*>(image.data()), image.size()));
}

Entries listed(const Catalog& catalog) {
  Entries entries;
  catalog.each({.best_only = false}, [&](const CatalogEntry& entry) {
    RC_ASSERT((entries.emplace(entry.label(), entry).second));
    return true;
  });
  return entries;
}

RC_GTEST_PROP(RowsProperty, AreReadAsTheyWereWritten, (std::uint32_t seed)) {
  static const TemporaryFolder folder;
  const Entries entries = some_entries(seed);
  const Entries shipped = some_entries(seed + 1);
  put(folder.file("mine.db"), entries);
  const std::vector<std::byte> image = image_of(shipped);
  const Catalog catalog({.shipped = image, .user = folder.file("mine.db")});
  Entries all = shipped;
  all.insert(entries.begin(), entries.end());
  RC_ASSERT(listed(catalog) == all);
  for (const auto& [label, entry] : all) {
    RC_ASSERT(catalog.find(label) == entry);
    RC_ASSERT(catalog.is_shipped(label) == shipped.contains(label));
    std::uint64_t fewest = entry.b;
    for (const auto& [other_label, other] : all) {
      fewest = other.parameters == entry.parameters ? std::min(fewest, other.b) : fewest;
    }
    RC_ASSERT(catalog.best(entry.parameters)->b == fewest);
    RC_ASSERT(catalog.fewest(entry.parameters)->b == fewest);
    RC_ASSERT(catalog.cell(entry.parameters).front().b == fewest);
  }
  RC_ASSERT(catalog.size().designs == all.size());
  RC_ASSERT(catalog.problem().empty());
}

// The cell that a row says it is of.
Parameters cell_of(const Database& database, const std::string& label) {
  Statement row =
      database.prepare("SELECT v, k, change, kind, strength FROM design WHERE label = ?");
  row.bind(1, label);
  if (!row.step()) {
    return {};
  }
  return {.v = row.integer(0),
          .k = row.integer(1),
          .change = row.integer(2),
          .kind = row.integer(3) == 0 ? Kind::linear : Kind::circular,
          .strength = static_cast<std::uint32_t>(row.integer(4))};
}

// Another value in a column of a row, as it may be after a fault of a disk; SQLite keeps no
// checksums. Returns what the row is of now.
Parameters damage_row(const std::string& path, const std::string& label, const Damage& damage) {
  const Database database = Database::open(path, Access::read_write);
  database.run("PRAGMA synchronous = OFF");
  const std::string column = *rc::gen::elementOf(
      std::vector<std::string>{"label", "v", "k", "change", "kind", "strength", "b",
                               "carries_blocks", "line", "line", "line", "json"});
  const std::string table = column == "json" ? "credit" : "design";
  const std::string which = column == "json" ? "" : " WHERE label = ?1";
  Statement read = database.prepare(fmt::format("SELECT {} FROM {}{}", column, table, which));
  if (!which.empty()) {
    read.bind(1, label);
  }
  RC_ASSERT(read.step());
  const std::string value = damage.of(read.text(0));
  RC_LOG() << column << ": " << read.text(0) << " is now " << value << '\n';
  read.reset();
  Statement write =
      database.prepare(fmt::format("UPDATE OR IGNORE {} SET {} = ?2{}", table, column, which));
  if (!which.empty()) {
    write.bind(1, label);
  }
  write.bind(2, value);
  try {
    write.step();
  } catch (const Error&) {
    RC_DISCARD("no value of this column");
  }
  return cell_of(database, label);
}

RC_GTEST_PROP(RowsProperty, DamagedOnesAreNotTakenForOthers,
              (std::uint32_t seed, const Damage& damage)) {
  static const TemporaryFolder folder;
  const std::string path = folder.file("mine.db");
  const Entries entries = some_entries(seed);
  put(path, entries);
  const Parameters now = damage_row(path, entries.begin()->first, damage);
  const Catalog catalog({.user = path});
  const std::uint64_t question = some_number(4);
  for (const auto& [label, entry] : entries) {
    for (const Parameters& p : {entry.parameters, now}) {
      if (question == 0) {
        const auto found = catalog.find(label);
        RC_ASSERT((!found || found->label() == label));
      } else if (question == 1) {
        const auto best = catalog.best(p);
        RC_ASSERT((!best || best->parameters == p));
      } else if (question == 2) {
        const auto fewest = catalog.fewest(p);
        RC_ASSERT((!fewest || parse_design_label(fewest->label)->parameters == p));
      } else if (question == 3) {
        for (const CatalogEntry& each : catalog.cell(p)) {
          RC_ASSERT(each.parameters == p);
        }
      } else {
        RC_ASSERT(listed(catalog).size() <= entries.size());
      }
    }
  }
  const std::string problem = catalog.problem();
  RC_ASSERT((problem.empty() || problem.starts_with(path)));
  RC_ASSERT(is_printable(problem));
}

}  // namespace
}  // namespace changeover::test::rows_property_test
