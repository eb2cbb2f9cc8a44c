// Tables that were asked for: a page asks for a table and for pictures of it at once, and to look
// for the best of each cell takes time.
//
//     const auto table = explorer.tables.of(range, explorer.generation());
//     table->cells(Kind::linear);
#pragma once

#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace changeover::cli {
class KnownTable;
struct TableRange;
}  // namespace changeover::cli

namespace changeover::serve {

/// The last few tables. Thread-safe: who asks for a table that another request is making waits for
/// it.
class KnownTables {
 public:
  /// The table of a range, while the catalog is of this generation. @throws as known_table();
  /// Stopped if the control of this thread's scope wants to stop.
  [[nodiscard]] std::shared_ptr<const cli::KnownTable> of(const cli::TableRange& range,
                                                          const std::string& generation);

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const cli::KnownTable> table;  // nothing while it is being made
  };
  using Place = std::list<Entry>::iterator;

  Place find(const std::string& key);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Entry> entries_;  // last used first
};

}  // namespace changeover::serve
