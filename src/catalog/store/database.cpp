#include "catalog/store/database.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include "catalog/store/store.hpp"
#include "changeover/core/error.hpp"
#include "core/lines.hpp"
#include "core/printable.hpp"

namespace changeover {
namespace {

// How long another process may hold the file before we give up, in milliseconds.
constexpr int patience = 20'000;

// What SQLite takes: 512 bytes with a zero at the end, and "-journal" must find room.
constexpr std::size_t longest_path = 500;

std::string_view kind_of(mode_t mode) {
  return S_ISDIR(mode)    ? "a folder"
         : S_ISFIFO(mode) ? "a FIFO"
         : S_ISSOCK(mode) ? "a socket"
                          : "a device";
}

// Whether a regular file is there.
bool is_regular(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) {
      return false;
    }
    throw MissingResource(fmt::format("{}: cannot be opened: {}; name another file with --catalog",
                                      path, std::strerror(errno)));
  }
  if (!S_ISREG(status.st_mode)) {
    throw MissingResource(fmt::format("{}: {}, not a file; name another file with --catalog", path,
                                      kind_of(status.st_mode)));
  }
  return true;
}

[[noreturn]] void refuse(sqlite3* database, int code, const std::string& name) {
  const std::string what = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code);
  switch (code & 0xff) {
    case SQLITE_FULL:
    case SQLITE_IOERR:
      throw MissingResource(
          fmt::format("{}: {}; make room on the disk, nothing was changed", name, what));
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw MissingResource(
          fmt::format("{}: another process is writing to it for more than {} s; try again", name,
                      patience / 1000));
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      throw MissingResource(fmt::format(
          "{}: {}; allow writing there, or name another file with --catalog", name, what));
    case SQLITE_NOMEM:
      throw MissingResource(fmt::format("{}: not enough memory; close other programs", name));
    case SQLITE_PROTOCOL:
    case SQLITE_NOLFS:
      throw MissingResource(
          fmt::format("{}: {}; name a file on another file system with --catalog", name, what));
    case SQLITE_CONSTRAINT:  // We write consistent rows only, so the file is damaged.
    case SQLITE_ERROR:       // Our statements are correct, so the file is not a catalog.
    case SQLITE_SCHEMA:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
    case SQLITE_FORMAT:
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      throw BadInput(
          fmt::format("{}: damaged, or not a catalog ({}); it stays as it is: put it aside and "
                      "restore a copy, or name another file with --catalog",
                      name, what));
    default:
      throw InternalError(fmt::format("{}: SQLite says {} ({})", name, what, code));
  }
}

}  // namespace

Statement::Statement(sqlite3* database, std::string_view sql, const std::string& name)
    : database_(database), name_(name) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(database, sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) {
    refuse(database, code, name_);
  }
}

void Statement::bind(int index, std::uint64_t value) {
  if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    throw BadInput(fmt::format("{}: {} is too large for a catalog; leave it out", name_, value));
  }
  sqlite3_bind_int64(statement_.get(), index, static_cast<sqlite3_int64>(value));
}

void Statement::bind(int index, std::string_view value) {
  sqlite3_bind_text64(statement_.get(), index, value.data(), value.size(), SQLITE_STATIC,
                      SQLITE_UTF8);
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) {
    refuse(database_, code, name_);
  }
  return code == SQLITE_ROW;
}

void Statement::reset() {
  sqlite3_reset(statement_.get());  // step() has reported the error.
}

std::uint64_t Statement::work() const {
  return static_cast<std::uint64_t>(
      sqlite3_stmt_status(statement_.get(), SQLITE_STMTSTATUS_VM_STEP, 0));
}

std::uint64_t Statement::integer(int column) const {
  return static_cast<std::uint64_t>(sqlite3_column_int64(statement_.get(), column));
}

std::string_view Statement::view(int column) const {
  const auto* const text =
      reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return text == nullptr
             ? std::string_view()
             : std::string_view(
                   text, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)));
}

std::string Statement::text(int column) const { return std::string(view(column)); }

std::string as_path(const std::string& name) { return name.starts_with('/') ? name : "./" + name; }

bool is_file(const std::string& name) {
  if (name.empty() || name.find('\0') != std::string::npos) {
    throw MissingResource("not a path of a file; name a file with --catalog");
  }
  const bool is_there = is_regular(name);
  for (const char* const beside : {"-wal", "-shm", "-journal"}) {
    static_cast<void>(is_regular(name + beside));
  }
  std::error_code ignored;
  const auto whole = std::filesystem::weakly_canonical(name, ignored);
  if (!ignored && whole.native().size() > longest_path) {
    throw MissingResource(
        fmt::format("{}: a path of {} bytes, and SQLite takes {}; name a file with a shorter "
                    "path with --catalog",
                    name, whole.native().size(), longest_path));
  }
  return is_there;
}

Database Database::opened(const std::string& path, int flags, std::string name) {
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &database, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  Database result(database, std::move(name));
  if (code != SQLITE_OK) {
    refuse(database, code, result.name_);
  }
  sqlite3_extended_result_codes(database, 1);
  sqlite3_busy_timeout(database, patience);
  return result;
}

Database Database::open(const std::string& path, Access access) {
  static_cast<void>(is_file(path));
  int flags = SQLITE_OPEN_READONLY;
  if (access == Access::read_write || access == Access::create) {
    flags = SQLITE_OPEN_READWRITE | (access == Access::create ? SQLITE_OPEN_CREATE : 0);
  }
  if (access != Access::read_unchanging) {
    return opened(as_path(path), flags, path);
  }
  std::string uri = path.starts_with('/') ? "file://" : "file:";  // with no host before the path
  for (const char byte : as_path(path)) {
    // Characters with a meaning in an address.
    uri += byte == '?' || byte == '#' || byte == '%'
               ? fmt::format("%{:02x}", static_cast<unsigned char>(byte))
               : std::string(1, byte);
  }
  return opened(uri + "?immutable=1", flags | SQLITE_OPEN_URI, path);
}

Database Database::temporary() {
  Database result = opened("", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "a temporary file");
  result.run("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA cache_size = -16000");
  return result;
}

Database Database::in_memory() {
  return opened(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "memory");
}

Database Database::of_image(std::span<const std::byte> image) {
  Database result = opened(":memory:", SQLITE_OPEN_READWRITE, "the program's catalog");
  // SQLite takes it as writable memory, but with READONLY does not write to it.
  auto* const bytes =
      reinterpret_cast<unsigned char*>(const_cast<std::byte*>(image.data()));  // NOLINT
  const auto size = static_cast<sqlite3_int64>(image.size());
  const int code = sqlite3_deserialize(result.database_.get(), "main", bytes, size, size,
                                       SQLITE_DESERIALIZE_READONLY);
  if (code != SQLITE_OK) {
    refuse(result.database_.get(), code, result.name_);
  }
  return result;
}

void Database::run(std::string_view sql) const {
  const std::string text(sql);
  const int code = sqlite3_exec(database_.get(), text.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) {
    refuse(database_.get(), code, name_);
  }
}

void Database::write_ahead() const {
  constexpr int pause = 50;
  for (int waited = 0;; waited += pause) {
    const int code =
        sqlite3_exec(database_.get(), "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
    if (code == SQLITE_OK) {
      return;
    }
    if ((code & 0xff) != SQLITE_BUSY || waited >= patience) {
      refuse(database_.get(), code, name_);
    }
    sqlite3_sleep(pause);
  }
}

std::uint64_t Database::integer(std::string_view sql) const {
  Statement query = prepare(sql);
  return query.step() ? query.integer(0) : 0;
}

std::vector<std::byte> Database::image() const {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
      sqlite3_serialize(database_.get(), "main", &size, 0), &sqlite3_free);
  if (bytes == nullptr) {
    throw MissingResource("not enough memory for the image of a catalog; close other programs");
  }
  std::vector<std::byte> result(static_cast<std::size_t>(size));
  std::memcpy(result.data(), bytes.get(), result.size());
  return result;
}

Transaction::~Transaction() {
  if (database_ != nullptr) {
    try {
      database_->run("ROLLBACK");
    } catch (const Error&) {
      // SQLite has rolled back by itself, or does so when the file is next opened.
    }
  }
}

void Transaction::commit() {
  database_->run("COMMIT");
  database_ = nullptr;
}

// Contradictions in a user's file.

namespace {

using Faults = std::vector<Catalog::Fault>;

void check_rows(Shelf& shelf, Faults& faults) {
  for (Statement rows = shelf.database().prepare(fmt::format("SELECT {}", entry_columns));
       rows.step();) {
    try {
      static_cast<void>(shelf.read(rows));
    } catch (const BadInput& fault) {
      faults.push_back({printable(rows.view(0)), fault.what()});
    }
  }
}

// The faults that SQLite finds: an index that misses a row hides a design. Those of pages come as
// lines of one row, below a headline that only says which file.
void check_structure(const Database& database, Faults& faults) {
  for (Statement rows = database.prepare("PRAGMA integrity_check(20)"); rows.step();) {
    for (Lines lines(rows.view(0)); lines.next();) {
      if (lines.line() != "ok" && !lines.line().empty() && !lines.line().starts_with("***")) {
        faults.push_back(
            {"your own catalog", fmt::format("{}: damaged ({}); restore a copy", database.name(),
                                             printable(lines.line()))});
      }
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
