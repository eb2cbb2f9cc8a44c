#include "changeover/catalog/catalog.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>

#include "catalog/store/database.hpp"
#include "catalog/store/filler.hpp"
#include "catalog/store/schema.hpp"
#include "catalog/store/shelf.hpp"
#include "changeover/catalog/label.hpp"
#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// Where an entry stands in a list.
struct Row {
  std::array<std::uint64_t, 5> cell;  // change, strength, kind, k, v
  std::uint64_t b = 0;
  std::string label;
  bool users = false;
  bool carries_blocks = false;

  [[nodiscard]] auto name() const { return std::tie(cell, b, label); }
  [[nodiscard]] auto key() const { return std::tie(cell, b, label, users); }
  [[nodiscard]] auto rank() const {
    return std::tie(cell, b, users, carries_blocks, label);
  }  // as best() has it
};

// What no entry has.
bool is_beyond(const Parameters& p) {
  return std::max({p.v, p.k, p.change}) > std::numeric_limits<Element>::max();
}

bool may_write(const std::string& path) { return access(path.c_str(), W_OK) == 0; }

}  // namespace

class Catalog::Store {
 public:
  explicit Store(Files files) : user_path(std::move(files.user)) {
    if (!files.shipped.empty()) {
      shipped.emplace(Database::of_image(files.shipped));
    }
  }

  // The user's file, if it is there and can be read.
  Shelf* users() {
    if (!user && !user_path.empty() && problem.empty()) {
      std::error_code error;
      if (std::filesystem::exists(user_path, error)) {
        try {
          open_user();
        } catch (const Error& fault) {
          problem = fault.what();
        }
      }
    }
    return user && problem.empty() ? &*user : nullptr;
  }

  // Reads from the user's file, which may turn out to be damaged: then it is as if it were not there.
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
        problem = fault.what();  // It stays open: whoever called may be reading from it, too.
      }
    }
    return otherwise;
  }

  // Why an entry is retracted, wherever that is said; empty if it is not.
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

  // The first row that is not retracted.
  std::optional<CatalogEntry> first_good(Shelf& shelf, Statement& rows) {
    const ResetLater later(rows);
    while (rows.step()) {
      CatalogEntry entry = read(shelf, rows);
      if (entry.retracted.empty()) {
        return entry;
      }
    }
    return std::nullopt;
  }

  template <typename Rows>
  std::optional<CatalogEntry> first_good_of_both(Rows&& rows) {
    std::optional<CatalogEntry> best;
    if (shipped) {
      best = first_good(*shipped, rows(*shipped));
    }
    auto own = from_users(std::optional<CatalogEntry>(),
                          [&](Shelf& shelf) { return first_good(shelf, rows(shelf)); });
    if (own && (!best || own->b < best->b)) {
      best = std::move(own);
    }
    return best;
  }

  std::optional<Known> fewest(const Parameters& p, bool carries_blocks) {
    const auto look = [&](Shelf& shelf) -> std::optional<Known> {
      Statement& rows = shelf.counts(p);
      const ResetLater later(rows);
      while (rows.step()) {
        if ((!carries_blocks || rows.integer(2) != 0) && retraction(rows.view(0)).empty()) {
          const auto label = parse_design_label(rows.view(0));
          if (!label || label->parameters != p || label->b != rows.integer(1)) {
            throw BadInput(
                fmt::format("{}: the entry {} is damaged", shelf.database().name(), rows.view(0)));
          }
          return Known{rows.text(0), label->b};
        }
      }
      return std::nullopt;
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

  std::string behind_alias(std::string_view text) {
    const auto look = [&](Shelf& shelf) { return shelf.alias(text).value_or(""); };
    std::string label = shipped ? look(*shipped) : "";
    return label.empty() ? from_users(std::string(), look) : label;
  }

  // The user's file, to be written; made if it is not there.
  Shelf& to_write() {
    if (user_path.empty()) {
      throw MissingResource(
          "there is no file for a catalog of your own: name one by --catalog or CHANGEOVER_CATALOG");
    }
    problem.clear();
    user.reset();
    const std::filesystem::path path(user_path);
    if (path.has_parent_path()) {
      std::error_code error;
      std::filesystem::create_directories(path.parent_path(), error);
      if (error) {
        throw MissingResource(fmt::format("{}: cannot be made: {}; name another file by --catalog",
                                          path.parent_path().string(), error.message()));
      }
    }
    const Database database = Database::open(user_path, Access::create);
    if (is_blank(database)) {
      database.run("PRAGMA journal_mode = WAL");
      Transaction transaction(database);
      if (is_blank(database)) {  // Nobody was faster.
        make_tables(database);
      }
      transaction.commit();
    }
    check_catalog(database, catalog_schema_version, catalog_migrations());
    Statement health = database.prepare("PRAGMA quick_check(1)");
    if (!health.step() || health.view(0) != "ok") {
      throw BadInput(
          fmt::format("{}: damaged ({}); it stays as it is: put it aside and restore a "
                      "copy, or name another file by --catalog",
                      user_path, health.view(0)));
    }
    open_user();
    return *user;
  }

  std::optional<Shelf> shipped;
  std::optional<Shelf> user;
  std::string user_path;
  std::string problem;
  bool writing = false;  // What cannot be read then is a fault of the writing.
  std::map<std::string, std::string, std::less<>> distrusted;  // label, why
  std::mutex mutex;

 private:
  void open_user() {
    const bool writable = may_write(user_path);
    Database database = Database::open(user_path, writable ? Access::read_write : Access::read);
    try {
      static_cast<void>(is_blank(database));  // Reads the first page.
    } catch (const MissingResource&) {
      // Where not even the folder can be written, nobody writes.
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
};

namespace {

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

}  // namespace

Catalog::Catalog(Files files) : store_(std::make_unique<Store>(std::move(files))) {}
Catalog::~Catalog() = default;

std::optional<CatalogEntry> Catalog::best(const Parameters& p) const {
  if (is_beyond(p)) {
    return std::nullopt;
  }
  const std::lock_guard lock(store_->mutex);
  return store_->first_good_of_both([&](Shelf& shelf) -> Statement& { return shelf.cell(p); });
}

std::optional<Catalog::Known> Catalog::fewest(const Parameters& p, bool carries_blocks) const {
  if (is_beyond(p)) {
    return std::nullopt;
  }
  const std::lock_guard lock(store_->mutex);
  return store_->fewest(p, carries_blocks);
}

std::optional<CatalogEntry> Catalog::find(std::string_view label) const {
  const std::lock_guard lock(store_->mutex);
  const std::string behind = store_->behind_alias(label);
  const std::string wanted = behind.empty() ? std::string(label) : behind;
  if (auto entry = store_->exact(wanted)) {
    return entry;
  }
  // The beginning of a label: a cell, its number of blocks or the first of its digits.
  const std::size_t dot = wanted.rfind('.');
  if (dot == std::string::npos || parse_cell_label(wanted) ||
      !(parse_cell_label(std::string_view(wanted).substr(0, dot)) ||
        parse_cell_label(std::string_view(wanted).substr(0, wanted.rfind('.', dot - 1))))) {
    return std::nullopt;
  }
  const bool is_count = parse_cell_label(std::string_view(wanted).substr(0, dot)).has_value();
  const std::string beginning = is_count ? wanted + "." : wanted;
  std::set<std::string> labels;
  const auto collect = [&](Shelf& shelf) {
    Statement& rows = shelf.begins(beginning);
    const ResetLater later(rows);
    while (rows.step()) {
      labels.insert(rows.text(0));
    }
    return true;
  };
  if (store_->shipped) {
    collect(*store_->shipped);
  }
  store_->from_users(true, collect);
  if (labels.size() > 1) {
    throw BadInput(
        fmt::format("{} designs have a label that begins with {}, as {} and {}; write more "
                    "of it",
                    labels.size(), wanted, *labels.begin(), *labels.rbegin()));
  }
  return labels.empty() ? std::nullopt : store_->exact(*labels.begin());
}

std::vector<CatalogEntry> Catalog::cell(const Parameters& p) const {
  std::vector<CatalogEntry> entries;
  if (is_beyond(p)) {
    return entries;
  }
  const std::lock_guard lock(store_->mutex);
  const auto collect = [&](Shelf& shelf) {
    std::vector<CatalogEntry> found;
    Statement& rows = shelf.cell(p);
    const ResetLater later(rows);
    while (rows.step()) {
      found.push_back(store_->read(shelf, rows));
    }
    return found;
  };
  if (store_->shipped) {
    entries = collect(*store_->shipped);
  }
  for (CatalogEntry& entry : store_->from_users(std::vector<CatalogEntry>(), collect)) {
    if (std::ranges::none_of(
            entries, [&](const CatalogEntry& other) { return other.label() == entry.label(); })) {
      entries.push_back(std::move(entry));
    }
  }
  std::ranges::stable_sort(entries, {}, &CatalogEntry::b);
  return entries;
}

void Catalog::each(const CatalogFilter& filter,
                   const std::function<bool(const CatalogEntry&)>& take) const {
  // Labels in order first, entries one by one: what is listed may be much.
  std::vector<Row> rows;
  {
    const std::lock_guard lock(store_->mutex);
    std::string sql =
        "SELECT change, strength, kind, k, v, b, label, carries_blocks FROM design WHERE 1";
    const auto bound = [&](const char* condition, const auto& value) {
      if (value) {
        sql += fmt::format(" AND {} {}", condition, static_cast<std::uint64_t>(*value));
      }
    };
    bound("v >=", filter.v_from);
    bound("v <=", filter.v_to);
    bound("k >=", filter.k_from);
    bound("k <=", filter.k_to);
    bound("change =", filter.change);
    bound("strength =", filter.strength);
    if (filter.kind) {
      sql += fmt::format(" AND kind = {}", code_of(*filter.kind));
    }
    const auto collect = [&](Shelf& shelf, bool users) {
      for (Statement query = shelf.database().prepare(sql); query.step();) {
        rows.push_back({{query.integer(0), query.integer(1), query.integer(2), query.integer(3),
                         query.integer(4)},
                        query.integer(5),
                        query.text(6),
                        users,
                        query.integer(7) != 0});
      }
      return true;
    };
    if (store_->shipped && !filter.users_only) {
      collect(*store_->shipped, false);
    }
    store_->from_users(true, [&](Shelf& shelf) { return collect(shelf, true); });
  }
  std::ranges::sort(rows, {}, &Row::key);
  const auto twins = std::ranges::unique(rows, {}, &Row::name);
  rows.erase(twins.begin(), twins.end());
  std::ranges::sort(rows, {}, &Row::rank);
  const bool wants_retracted = filter.status == "retracted";
  const decltype(Row::cell)* taken = nullptr;  // the cell whose best was handed out
  for (const Row& row : rows) {
    if (filter.best_only && !wants_retracted && taken != nullptr && *taken == row.cell) {
      continue;
    }
    std::optional<CatalogEntry> entry;
    {
      const std::lock_guard lock(store_->mutex);
      entry = store_->exact(row.label);
    }
    if (!entry || entry->retracted.empty() == wants_retracted) {
      continue;
    }
    taken = &row.cell;
    const bool passes =
        (filter.status.empty() || entry->status() == filter.status) &&
        (filter.construction.empty() || entry->recipe.construction == filter.construction) &&
        (filter.since.empty() || entry->credit.date >= filter.since) &&
        (!filter.gap || entry->b >= entry->lower_bound + *filter.gap);
    if (passes && !take(*entry)) {
      return;
    }
  }
}

std::vector<Improvement> Catalog::history(const Parameters& p) const {
  std::vector<CatalogEntry> entries = cell(p);
  std::erase_if(entries, [](const CatalogEntry& entry) { return !entry.retracted.empty(); });
  // Of one day the better ones last.
  std::ranges::stable_sort(entries, [](const CatalogEntry& a, const CatalogEntry& b) {
    return std::tuple(a.credit.date, b.b) < std::tuple(b.credit.date, a.b);
  });
  std::vector<Improvement> steps;
  for (const CatalogEntry& entry : entries) {
    if (steps.empty() || entry.b < steps.back().b) {
      const Credit& credit = entry.credit;
      std::string how = credit.command.empty() ? entry.recipe.construction : credit.command;
      if (!entry.cites.empty()) {
        const std::string from = fmt::format("[{}]", fmt::join(entry.cites, ", "));
        how = credit.command.empty() ? from : from + "; " + how;
      }
      for (const std::string& more : {entry.note, credit.who, credit.program}) {
        how += more.empty() ? "" : "; " + more;
      }
      steps.push_back({entry.label(), entry.b, credit.date, std::move(how)});
    }
  }
  return steps;
}

Catalog::Size Catalog::size() const {
  const std::lock_guard lock(store_->mutex);
  Size size;
  std::set<std::string> labels;
  std::set<std::array<std::uint64_t, 5>> cells;
  const auto count = [&](Shelf& shelf) {
    const Database& database = shelf.database();
    for (Statement rows =
             database.prepare("SELECT label, change, strength, kind, k, v FROM design");
         rows.step();) {
      labels.insert(rows.text(0));
      cells.insert(
          {rows.integer(1), rows.integer(2), rows.integer(3), rows.integer(4), rows.integer(5)});
    }
    for (Statement rows = database.prepare("SELECT coalesce(max(date), '') FROM design");
         rows.step();) {
      size.latest = std::max(size.latest, std::string(rows.text(0)));
    }
    return true;
  };
  if (store_->shipped) {
    count(*store_->shipped);
  }
  store_->from_users(true, count);
  size.designs = labels.size();
  size.cells = cells.size();
  return size;
}

std::optional<std::uint64_t> Catalog::largest_users_v() const {
  const std::lock_guard lock(store_->mutex);
  const std::uint64_t v = store_->from_users(std::uint64_t{0}, [](Shelf& shelf) {
    return shelf.database().integer("SELECT coalesce(max(v), 0) FROM design");
  });
  return v == 0 ? std::nullopt : std::optional(v);
}

std::string Catalog::problem() const {
  const std::lock_guard lock(store_->mutex);
  store_->users();
  if (store_->problem.empty() && !store_->distrusted.empty()) {
    const auto& [label, why] = *store_->distrusted.begin();
    return fmt::format("{}: {} is left out: {}", store_->user_path, label, why);
  }
  return store_->problem;
}

void Catalog::distrust(const std::string& label, const std::string& why) const {
  const std::lock_guard lock(store_->mutex);
  store_->distrusted.emplace(label, why);
}

bool Catalog::is_shipped(std::string_view label) const {
  const std::lock_guard lock(store_->mutex);
  return store_->shipped && store_->shipped->has(label);
}

std::vector<Added> Catalog::add(std::span<const CatalogEntry> entries) {
  const std::lock_guard lock(store_->mutex);
  Shelf& own = store_->to_write();
  const WhileWriting writing(store_->writing);
  std::vector<Added> results;
  Transaction transaction(own.database());
  Filler filler(own.database());
  for (const CatalogEntry& entry : entries) {
    const std::string label = entry.label();
    if (const auto there = store_->exact(label)) {
      if (there->checksum != entry.checksum) {
        throw BadInput(
            fmt::format("{}: another design has that label; write its elements by other "
                        "numbers",
                        label));
      }
      results.push_back(Added::already_there);
      continue;
    }
    const auto best = store_->fewest(entry.parameters, false);
    results.push_back(best && best->b <= entry.b ? Added::added : Added::improved);
    filler.add(entry);
  }
  transaction.commit();
  return results;
}

void Catalog::retract(std::string_view label, std::string_view why) {
  const std::lock_guard lock(store_->mutex);
  if (!store_->exact(label)) {
    throw BadInput(fmt::format("there is no design {} in the catalog", label));
  }
  Shelf& own = store_->to_write();
  Transaction transaction(own.database());
  Filler(own.database()).retract(label, why);
  transaction.commit();
}

void Catalog::alias(std::string_view alias, std::string_view label) {
  const std::lock_guard lock(store_->mutex);
  if (parse_design_label(alias) || parse_cell_label(alias)) {
    throw BadInput(
        fmt::format("{} is a label, and labels are not given away; choose another word", alias));
  }
  if (!store_->exact(label)) {
    throw BadInput(fmt::format("there is no design {} in the catalog", label));
  }
  const std::string there = store_->behind_alias(alias);
  if (!there.empty() && there != label) {
    throw BadInput(fmt::format("{} leads to {} already; choose another word", alias, there));
  }
  Shelf& own = store_->to_write();
  Transaction transaction(own.database());
  own.database().prepare("INSERT OR IGNORE INTO alias VALUES(?,?)").with(alias, label).step();
  transaction.commit();
}

const std::string& Catalog::user_path() const { return store_->user_path; }

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
