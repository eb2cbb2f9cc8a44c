// What writes to a user's file.
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "catalog/store/filler.hpp"
#include "catalog/store/schema.hpp"
#include "catalog/store/store.hpp"
#include "io/file/remedies.hpp"

namespace changeover {
namespace {

bool may_write(const std::string& path) { return access(path.c_str(), W_OK) == 0; }

// Which file has this name.
std::optional<std::pair<std::uint64_t, std::uint64_t>> file_behind(const std::string& path) {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0
             ? std::optional(std::pair<std::uint64_t, std::uint64_t>(status.st_dev, status.st_ino))
             : std::nullopt;
}

// Sets a mark while it lives.
class WhileWriting {
 public:
  explicit WhileWriting(bool& mark) : mark_(&mark) { *mark_ = true; }
  ~WhileWriting() { *mark_ = false; }
  WhileWriting(const WhileWriting&) = delete;
  WhileWriting& operator=(const WhileWriting&) = delete;

 private:
  bool* mark_;
};

void require(bool is_there, std::string_view label) {
  if (!is_there) {
    throw BadInput(
        fmt::format("there is no design {} in the catalog; give a label that it has", label));
  }
}

// The fewest known blocks of each cell that was added to; 0 if there is no design.
using FewestOfCells = std::map<Parameters, std::uint64_t>;

}  // namespace

Shelf& Catalog::Store::to_write() {
  if (user_path.empty()) {
    throw MissingResource(
        "there is no file for your own catalog; name one with --catalog or CHANGEOVER_CATALOG");
  }
  problem.clear();
  user.reset();
  const std::filesystem::path path(user_path);
  if (path.has_parent_path()) {
    make_folder(path.parent_path().string(), "name another file with --catalog");
  }
  const Database database = Database::open(user_path, Access::create);
  if (is_blank(database)) {
    database.write_ahead();
    Transaction transaction(database);
    if (is_blank(database)) {  // No other process was faster.
      make_tables(database);
    }
    transaction.commit();
  }
  check_catalog(database, catalog_schema_version, catalog_migrations());
  Statement health = database.prepare("PRAGMA quick_check(1)");
  if (!health.step() || health.view(0) != "ok") {
    throw BadInput(
        fmt::format("{}: damaged ({}); it stays as it is: put it aside and restore a "
                    "copy, or name another file with --catalog",
                    user_path, health.view(0)));
  }
  checked_ = file_behind(user_path);
  open_user();
  return still_to_write();
}

Shelf& Catalog::Store::still_to_write() {
  if (!user || !checked_ || file_behind(user_path) != checked_) {
    throw MissingResource(fmt::format(
        "{}: another file took its name while it was written to; try again", user_path));
  }
  return *user;
}

void Catalog::Store::open_user() {
  const bool writable = may_write(user_path);
  Database database = Database::open(user_path, writable ? Access::read_write : Access::read);
  try {
    static_cast<void>(is_blank(database));  // Reads the first page.
  } catch (const MissingResource&) {
    // If not even the folder can be written, no process writes.
    if (writable) {
      throw;
    }
    database = Database::open(user_path, Access::read_unchanging);
  }
  if (is_blank(database)) {
    return;  // Being made.
  }
  check_catalog(database, catalog_schema_version, catalog_migrations());
  if (writable) {
    database.run("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
    migrate(database, catalog_schema_version, catalog_migrations());
  }
  user.emplace(std::move(database));
}

std::vector<Added> Catalog::Store::put(Shelf& own, std::span<const CatalogEntry> entries,
                                       std::map<Parameters, std::uint64_t>& fewest_of) {
  const WhileWriting mark(writing);
  std::vector<Added> results;
  Transaction transaction(own.database());
  Filler filler(own.database());
  for (const CatalogEntry& entry : entries) {
    const std::string label = entry.label();
    if (const auto there = exact(label)) {
      if (there->checksum != entry.checksum) {
        throw BadInput(fmt::format(
            "{}: another design has that label; write its elements by other numbers", label));
      }
      results.push_back(Added::already_there);
      continue;
    }
    auto place = fewest_of.find(entry.parameters);
    if (place == fewest_of.end()) {
      const auto known = fewest(entry.parameters, false);
      place = fewest_of.emplace(entry.parameters, known ? known->b : 0).first;
    }
    const bool is_better =
        entry.retracted.empty() && (place->second == 0 || entry.b < place->second);
    if (is_better) {
      place->second = entry.b;
    }
    results.push_back(is_better ? Added::improved : Added::added);
    filler.add(entry);
  }
  transaction.commit();
  return results;
}

std::vector<Added> Catalog::add(std::span<const CatalogEntry> entries) {
  const std::lock_guard lock(store_->mutex);
  FewestOfCells fewest_of;
  return store_->put(store_->to_write(), entries, fewest_of);
}

void Catalog::add_lists(const std::function<std::vector<CatalogEntry>()>& next,
                        const std::function<void(std::span<const Added>)>& done) {
  FewestOfCells fewest_of;
  for (bool is_first = true;; is_first = false) {
    const std::vector<CatalogEntry> entries = next();
    if (entries.empty()) {
      return;
    }
    std::vector<Added> results;
    {
      const std::lock_guard lock(store_->mutex);
      Shelf& own = is_first ? store_->to_write() : store_->still_to_write();
      results = store_->put(own, entries, fewest_of);
    }
    done(results);
  }
}

void Catalog::retract(std::string_view label, std::string_view why) {
  const std::lock_guard lock(store_->mutex);
  require(store_->exact(label).has_value(), label);
  Shelf& own = store_->to_write();
  Transaction transaction(own.database());
  Filler(own.database()).retract(label, why);
  transaction.commit();
}

void Catalog::alias(std::string_view alias, std::string_view label) {
  const std::lock_guard lock(store_->mutex);
  if (reads_as_label(alias)) {
    throw BadInput(
        fmt::format("{} is a label or the beginning of one, and a label cannot be used as an "
                    "alias; choose another word",
                    alias));
  }
  require(store_->exact(label).has_value(), label);
  Shelf& own = store_->to_write();
  const WhileWriting mark(store_->writing);
  Transaction transaction(own.database());
  const std::string there = store_->behind_alias(alias);
  // An alias that leads nowhere may be used again.
  if (!there.empty() && there != label && store_->exact(there)) {
    throw BadInput(fmt::format("{} leads to {} already; choose another word", alias, there));
  }
  own.database().prepare("INSERT OR REPLACE INTO alias VALUES(?,?)").with(alias, label).step();
  transaction.commit();
}

std::string Catalog::remove_alias(std::string_view alias) {
  const std::lock_guard lock(store_->mutex);
  const auto behind = store_->from_users(std::optional<std::string>(),
                                         [&](Shelf& shelf) { return shelf.alias(alias); });
  if (!behind) {
    throw BadInput(
        fmt::format("there is no alias {} in your catalog; check how it is spelt", alias));
  }
  Shelf& own = store_->to_write();
  Transaction transaction(own.database());
  own.database().prepare("DELETE FROM alias WHERE alias = ?").with(alias).step();
  transaction.commit();
  return *behind;
}

std::vector<std::byte> make_catalog(std::span<const CatalogEntry> entries) {
  const Database database = Database::in_memory();
  make_tables(database);
  {
    Transaction transaction(database);
    Filler filler(database);
    for (const CatalogEntry& entry : entries) {
      filler.add(entry);
    }
    transaction.commit();
  }
  database.run("VACUUM");
  return database.image();
}

}  // namespace changeover
