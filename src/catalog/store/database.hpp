// The part of SQLite that the catalog needs.
//
//     Database database = Database::open("mine.db", Access::read_write);
//     Statement select = database.prepare("SELECT b FROM design WHERE label = ?");
//     select.bind(1, "6.4.2.circular.3.…");
//     while (select.step()) {
//       select.integer(0);
//     }
//
// Errors of SQLite become our faults: a full disk, a lock that lasts and a write-protected file are
// MissingResource; a file that is damaged or not a database is BadInput; all else is InternalError.
// Each message names the file.
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace changeover {

class Statement {
 public:
  void bind(int index, std::uint64_t value);
  void bind(int index, std::string_view value);  ///< must live until the next reset()

  /// Goes to the next row; false at the end.
  bool step();
  void reset();

  /// reset(), and these values for the parameters 1, 2, …
  template <typename... Values>
  Statement& with(const Values&... values) {
    reset();
    int index = 0;
    (bind(++index, values), ...);
    return *this;
  }

  /// The number of steps of SQLite's machine so far: a measure of work that does not depend on the
  /// clock.
  [[nodiscard]] std::uint64_t work() const;

  [[nodiscard]] std::uint64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::string_view view(int column) const;  ///< until the next step()

 private:
  friend class Database;
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  Statement(sqlite3* database, std::string_view sql, const std::string& name);

  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
  std::string name_;
};

/// Resets a statement at the end of a block: a statement that stopped at a row keeps its connection
/// at the state of the database of that time.
class ResetLater {
 public:
  explicit ResetLater(Statement& statement) : statement_(&statement) {}
  ~ResetLater() { statement_->reset(); }
  ResetLater(const ResetLater&) = delete;
  ResetLater& operator=(const ResetLater&) = delete;

 private:
  Statement* statement_;
};

/// Spells a name so that SQLite takes it for a path: ":memory:" and "file:mine.db?mode=memory" are
/// files, too.
[[nodiscard]] std::string as_path(const std::string& name);

/// Whether there is a file for SQLite to open. @throws MissingResource in one line if there is
/// something else (a folder, a FIFO, a device, a socket) in its place or that of its journals, or
/// if there cannot be a file: a folder of the path is not one or may not be searched, the path is
/// too long for SQLite.
[[nodiscard]] bool is_file(const std::string& name);

enum class Access : std::uint8_t {
  read,
  read_unchanging,  ///< promises SQLite that no process can write the file and its folder
  read_write,
  create
};

class Database {
 public:
  /// The name is a path, always. @throws as the summary says; as is_file().
  [[nodiscard]] static Database open(const std::string& path, Access access);

  /// An empty one in a file without a name that ends with this; beyond some 16 MB it takes space on
  /// the disk instead of memory.
  [[nodiscard]] static Database temporary();

  /// An empty one in memory, or the image of one, which is read-only and must outlive this.
  [[nodiscard]] static Database in_memory();
  [[nodiscard]] static Database of_image(std::span<const std::byte> image);

  [[nodiscard]] Statement prepare(std::string_view sql) const {
    return {database_.get(), sql, name_};
  }
  void run(std::string_view sql) const;

  /// Has the file a journal beside which it can be read. SQLite does not wait here for another
  /// process that does the same, as it does elsewhere; this waits as long.
  void write_ahead() const;

  [[nodiscard]] std::uint64_t integer(std::string_view sql) const;  ///< of a query with one row

  /// The bytes of the whole database.
  [[nodiscard]] std::vector<std::byte> image() const;

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  struct Closer {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  };
  Database(sqlite3* database, std::string name) : database_(database), name_(std::move(name)) {}
  static Database opened(const std::string& path, int flags, std::string name);

  std::unique_ptr<sqlite3, Closer> database_;
  std::string name_;
};

/// A transaction: everything written between its beginning and commit(), or nothing. Waits for
/// other writers.
class Transaction {
 public:
  explicit Transaction(const Database& database) : database_(&database) {
    database.run("BEGIN IMMEDIATE");
  }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Database* database_;
};

}  // namespace changeover
