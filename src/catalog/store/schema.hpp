// The schema of a catalog's database, and the migration of older files.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "catalog/store/database.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover {

/// "CHOV", the application id of our files.
inline constexpr std::uint64_t catalog_application_id = 0x43484f56;

/// A step from one version to the next.
struct Migration {
  int from = 0;
  std::string_view sql;
};

/// The steps to catalog_schema_version, in order.
[[nodiscard]] std::span<const Migration> catalog_migrations();

/// Whether the database has nothing in it.
[[nodiscard]] bool is_blank(const Database& database);

/// @throws BadInput in one line unless the database is a catalog of version `version`, or of an
/// older one from which `migrations` lead.
void check_catalog(const Database& database, int version, std::span<const Migration> migrations);

/// Makes the tables in a blank database.
void make_tables(const Database& database);

/// Converts a catalog of an older version to `version` in one transaction, after making a copy
/// beside it: "mine.db.version-1". An existing file of that name stays, and the copy gets another
/// name. Does nothing if it is of that version. @throws as Database.
void migrate(const Database& database, int version, std::span<const Migration> migrations);

// Kinds as numbers, as a catalog's database has them.

inline std::uint64_t code_of(Kind kind) { return kind == Kind::linear ? 0 : 1; }

}  // namespace changeover
