// What all answers of the server share.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/design.hpp"
#include "changeover/run/control.hpp"
#include "serve/http/events.hpp"
#include "serve/http/message.hpp"

namespace changeover::cli {
class KnownTable;
struct TableRange;
}  // namespace changeover::cli

namespace changeover::serve {

// Tables that were asked for: a page asks for a table and for pictures of it at once, and to look
// for the best of each cell takes time.
//
//     const auto table = explorer.tables.of(range, explorer.generation());
//     table->cells(Kind::linear);

/// Why a table is made: a request wants it, or it will be wanted sometime.
enum class Haste : std::uint8_t { wanted, sometime };

/// The last few tables. Thread-safe: who asks for a table that another request is making waits for
/// it; not if it is made for sometime, which may take long: then it is made at once.
class KnownTables {
 public:
  /// The table of a range, while the catalog is of this generation. @throws as known_table();
  /// Stopped if the control of this thread's scope wants to stop.
  [[nodiscard]] std::shared_ptr<const cli::KnownTable> of(const cli::TableRange& range,
                                                          const std::string& generation,
                                                          Haste haste = Haste::wanted);

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const cli::KnownTable> table;  // nothing while it is being made
    Haste haste = Haste::wanted;                   // of who makes it
  };
  using Place = std::list<Entry>::iterator;

  Place find(const std::string& key);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Entry> entries_;  // last used first
};

class SearchJobs;
class PlanJobs;
class RunStore;

/// A design from a file of the user, read when the server started.
struct GivenFile {
  std::string name;
  Design design;
};

struct Limits {
  std::size_t body_bytes = std::size_t{64} << 20;      ///< of a design that is sent
  std::size_t json_bytes = std::size_t{1} << 20;       ///< of other bodies
  std::chrono::duration<double> seconds{60};           ///< of one answer
  std::uint64_t memory_bytes = 0;                      ///< of one table in the making of an answer
  unsigned searches = 2;                               ///< at once
  unsigned plans = 4;                                  ///< that are followed, at once
  std::size_t plan_bytes = std::size_t{32} << 20;      ///< of the answer to a plan, or of its file
  std::size_t untaken_bytes = std::size_t{512} << 20;  ///< of answers that were not yet taken
  std::size_t remembered_bytes = std::size_t{256} << 20;  ///< of all plans that have ended
};

/// Answers that were given, so that the same is not computed twice. Thread-safe; the least recently
/// used go first.
class AnswerCache {
 public:
  explicit AnswerCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  [[nodiscard]] std::optional<Response> find(const std::string& key);
  void keep(const std::string& key, const Response& response);

 private:
  struct Kept {
    std::string key;
    Response response;
    std::size_t bytes = 0;
  };
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::mutex mutex_;
  std::list<Kept> kept_;  // last used first
  std::map<std::string, std::list<Kept>::iterator> by_key_;
};

struct Explorer {
  Catalog& catalog;
  std::vector<GivenFile> files;
  Limits limits = {};
  bool may_write = true;
  EventHub events = {};
  std::atomic<bool> stopping = false;
  std::shared_ptr<SearchJobs> jobs = {};
  std::shared_ptr<PlanJobs> plans = {};
  std::shared_ptr<RunStore> runs = {};
  AnswerCache cache{std::size_t{64} << 20};
  KnownTables tables = {};

  explicit Explorer(Catalog& known);
  ~Explorer();
  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;

  /// Changes whenever the user's catalog does, by this process or another.
  [[nodiscard]] std::string generation() const;
};

/// How an answer may be given again.
enum class Again : std::uint8_t {
  made_anew,       ///< it depends on what happens
  while_unchanged  ///< as long as the catalog does not change
};

/// Makes an answer within the limits, with faults as the statuses of HTTP: 400 for a question that
/// cannot be, 422 with the place for a file that is malformed, 503 if a limit was reached. Work
/// stops when the client has gone.
/// @throws Refusal; InternalError
[[nodiscard]] Response answered(Explorer& explorer, const Request& request, Again again,
                                const std::function<Response()>& make);

}  // namespace changeover::serve
