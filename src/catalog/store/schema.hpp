// The shape of a catalog's database, and how a file of an older version comes to it.
#pragma once

#include <span>
#include <string_view>

#include "catalog/store/database.hpp"

namespace changeover {

/// "CHOV", by which a file is known as ours.
inline constexpr std::uint64_t catalog_application_id = 0x43484f56;

/// From one version to the next.
struct Migration {
  int from = 0;
  std::string_view sql;
};

/// Those that lead to catalog_schema_version, in order.
[[nodiscard]] std::span<const Migration> catalog_migrations();

/// Whether the database has nothing in it.
[[nodiscard]] bool is_blank(const Database& database);

/// @throws BadInput in one line unless the database is a catalog of version `version`, or of an older one that `migrations` leads from.
void check_catalog(const Database& database, int version, std::span<const Migration> migrations);

/// Makes the tables in a blank database.
void make_tables(const Database& database);

/// Brings a catalog of an older version to `version` in one transaction, after a copy of it was made beside it:
/// "mine.db.version-1". A copy of that name that is there already stays, and another name is taken. Does nothing if it is of that
/// version. @throws as Database.
void migrate(const Database& database, int version, std::span<const Migration> migrations);

}  // namespace changeover
