// Tables that were planned: a page asks for a table and for pictures of it at once, and planning is what takes the time.
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
class PlannedTable;
struct TableRange;
}  // namespace changeover::cli

namespace changeover::serve {

/// The last few tables. Thread-safe: who asks for a table that somebody else is planning waits for it.
class PlannedTables {
 public:
  /// The table of a range, while the catalog is of this generation. @throws as plan_table(); Stopped if the control of
  /// this thread's scope wants to stop.
  [[nodiscard]] std::shared_ptr<const cli::PlannedTable> of(const cli::TableRange& range,
                                                            const std::string& generation);

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const cli::PlannedTable> table;  // nothing while it is being planned
  };
  using Place = std::list<Entry>::iterator;

  Place find(const std::string& key);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Entry> entries_;  // last used first
};

}  // namespace changeover::serve
