// SQLite, as far as the catalog needs it.
//
//     Database database = Database::open("mine.db", Access::read_write);
//     Statement select = database.prepare("SELECT b FROM design WHERE label = ?");
//     select.bind(1, "6.4.2.circular.3.…");
//     while (select.step()) {
//       select.integer(0);
//     }
//
// What SQLite reports becomes one of our faults: a full disk, a lock that lasts, a file that may not be written are
// MissingResource; a file that is damaged or no database is BadInput; all else is InternalError. Each names the file.
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

  /// Whether there is a row; false at the end.
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

  /// How many steps SQLite's machine took for it so far: work that does not depend on the clock.
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

/// Resets a statement at the end of a block: one that stopped at a row keeps the whole connection looking at the database as it was then.
class ResetLater {
 public:
  explicit ResetLater(Statement& statement) : statement_(&statement) {}
  ~ResetLater() { statement_->reset(); }
  ResetLater(const ResetLater&) = delete;
  ResetLater& operator=(const ResetLater&) = delete;

 private:
  Statement* statement_;
};

/// A name as SQLite takes it for a path, whatever it looks like: ":memory:" and
/// "file:mine.db?mode=memory" are files, too.
[[nodiscard]] std::string as_path(const std::string& name);

/// Whether a file is there for SQLite to open. @throws MissingResource in one line if something
/// else is there (a folder, a FIFO, a device, a socket), or where its journals belong, or nothing
/// can be there: a folder on the way is none or may not be searched, the path is longer than SQLite
/// takes.
[[nodiscard]] bool is_file(const std::string& name);

enum class Access : std::uint8_t {
  read,
  read_unchanging,  ///< the file and its folder cannot be written by anybody, as SQLite is told
  read_write,
  create
};

class Database {
 public:
  /// The name is a path, always. @throws as the summary says; as is_file().
  [[nodiscard]] static Database open(const std::string& path, Access access);

  /// An empty one in a file that has no name and goes away with this; beyond some 16 MB it takes
  /// room on the disk and no memory.
  [[nodiscard]] static Database temporary();

  /// An empty one in memory, or the image of one, which nobody can write and which must outlive this.
  [[nodiscard]] static Database in_memory();
  [[nodiscard]] static Database of_image(std::span<const std::byte> image);

  [[nodiscard]] Statement prepare(std::string_view sql) const {
    return {database_.get(), sql, name_};
  }
  void run(std::string_view sql) const;
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

/// All that is written between its beginning and commit(), or nothing of it. Waits for other writers.
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
