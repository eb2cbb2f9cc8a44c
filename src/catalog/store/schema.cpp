#include "catalog/store/schema.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// An entry is kept as its line, without its credit; the columns are for look-ups. Kinds are 0 and
// 1, as in Kind.
constexpr std::string_view tables = R"(
CREATE TABLE credit(
  id INTEGER PRIMARY KEY,
  json TEXT NOT NULL UNIQUE
) STRICT;
CREATE TABLE design(
  label TEXT PRIMARY KEY,
  v INTEGER NOT NULL, k INTEGER NOT NULL, change INTEGER NOT NULL,
  kind INTEGER NOT NULL CHECK(kind IN (0, 1)), strength INTEGER NOT NULL,
  b INTEGER NOT NULL CHECK(b > 0), lower_bound INTEGER NOT NULL,
  carries_blocks INTEGER NOT NULL CHECK(carries_blocks IN (0, 1)),
  construction TEXT NOT NULL, date TEXT NOT NULL,
  credit INTEGER NOT NULL REFERENCES credit(id),
  line TEXT NOT NULL
) STRICT;
CREATE INDEX design_by_cell ON design(k, v, change, kind, strength, b, label);
CREATE TABLE retraction(
  label TEXT PRIMARY KEY,
  why TEXT NOT NULL
) STRICT, WITHOUT ROWID;
CREATE TABLE alias(
  alias TEXT PRIMARY KEY,
  label TEXT NOT NULL
) STRICT, WITHOUT ROWID;
)";

int version_of(const Database& database) {
  return static_cast<int>(database.integer("PRAGMA user_version"));
}

// The definitions of the tables and the index, as SQLite keeps them.
std::string shape_of(const Database& database) {
  Statement rows = database.prepare("SELECT name, sql FROM sqlite_schema ORDER BY name");
  std::string shape;
  while (rows.step()) {
    shape += rows.text(0) + "\n" + rows.text(1) + "\n";
  }
  return shape;
}

const std::string& shape_as_made() {
  static const std::string shape = [] {
    const Database fresh = Database::in_memory();
    make_tables(fresh);
    return shape_of(fresh);
  }();
  return shape;
}

std::string name_of_copy(const std::string& path, int version) {
  std::string copy = fmt::format("{}.version-{}", path, version);
  for (int number = 2; std::filesystem::exists(copy); ++number) {
    copy = fmt::format("{}.version-{}.{}", path, version, number);
  }
  return copy;
}

// The copy gets its name only when it is complete and on the disk.
void keep_copy(const Database& database, int version) {
  const std::string path = name_of_copy(database.name(), version);
  const std::string unfinished = fmt::format("{}.unfinished-{}", path, ::getpid());
  std::error_code error;
  std::filesystem::remove(unfinished, error);  // of a process that had this number before
  Statement copy = database.prepare("VACUUM INTO ?");
  const std::string target = as_path(unfinished);
  copy.bind(1, target);
  copy.step();
  const int descriptor = ::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_safe = descriptor >= 0 && ::fsync(descriptor) == 0;
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  if (is_safe) {
    std::filesystem::rename(unfinished, path, error);
  }
  if (!is_safe || error) {
    throw MissingResource(
        fmt::format("{}: no copy could be made beside it before it is converted to this version; "
                    "make room on the disk, nothing was changed",
                    database.name()));
  }
}

}  // namespace

std::span<const Migration> catalog_migrations() {
  return {};  // Version 1 is the first.
}

bool is_blank(const Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_schema") == 0 && version_of(database) == 0 &&
         database.integer("PRAGMA application_id") == 0;
}

void check_catalog(const Database& database, int version, std::span<const Migration> migrations) {
  const std::string& name = database.name();
  if (database.integer("PRAGMA application_id") != catalog_application_id) {
    throw BadInput(fmt::format(
        "{}: a database, but not a catalog of changeover; name another file with --catalog", name));
  }
  const int found = version_of(database);
  if (found > version) {
    throw BadInput(fmt::format(
        "{}: written by a newer program (version {} of a catalog, here {}); use that one, "
        "or name another file with --catalog",
        name, found, version));
  }
  if (found == catalog_schema_version && shape_of(database) != shape_as_made()) {
    throw BadInput(
        fmt::format("{}: damaged (its tables are not those of a catalog); it stays as it is: put "
                    "it aside and restore a copy, or name another file with --catalog",
                    name));
  }
  if (found < version &&
      std::ranges::none_of(migrations, [&](const Migration& step) { return step.from == found; })) {
    throw BadInput(fmt::format(
        "{}: version {} of a catalog is not known; name another file with --catalog", name, found));
  }
}

void make_tables(const Database& database) {
  database.run(tables);
  database.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                           catalog_application_id, catalog_schema_version));
}

void migrate(const Database& database, int version, std::span<const Migration> migrations) {
  const int found = version_of(database);
  if (found >= version) {
    return;
  }
  keep_copy(database, found);
  Transaction transaction(database);
  // Another process may have done it while this one waited.
  for (int at = version_of(database); at < version; ++at) {
    const auto step = std::ranges::find(migrations, at, &Migration::from);
    if (step == migrations.end()) {
      throw InternalError(fmt::format("{}: no migration from version {}", database.name(), at));
    }
    database.run(step->sql);
    database.run(fmt::format("PRAGMA user_version = {}", at + 1));
  }
  transaction.commit();
}

}  // namespace changeover
