// Runs of tests that the server keeps: what was planned, and the results of its tests, which
// several people write down, on several days.
//
//     RunStore store(folder, events);
//     const std::string id = store.keep({.title = "Pump bench", .sheet = "{…}"}).id;
//     store.add_result(id, {.test = "3", .result = "pass", .by = "Ann"}, 1);
//     store.json(id);
//
// A run is a file in the folder, format "changeover-run/1", which appears whole or not at all and
// is read anew for each question; a lock lets one server at a time change it. The sheet is the
// page's own: an object that the server does not look into. Results are of tests of one sheet:
// with each comes the revision of the sheet, and one of a sheet that was replaced is refused.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "serve/http/events.hpp"

namespace changeover::serve {

/// The result of a test. An empty one is none.
struct RunResult {
  std::string test;  ///< its name on the sheet
  std::string result;
  std::string notes = {};
  std::string by = {};
  std::string at = {};  ///< when, in UTC: "2026-11-22T10:00:00Z"
};

struct KeptRun {
  std::string id = {};
  std::string title = {};
  std::uint64_t revision = 1;        ///< grows with every change
  std::uint64_t sheet_revision = 1;  ///< the revision that brought this sheet
  std::string changed = {};          ///< when, as RunResult::at
  std::uint64_t tests = 0;           ///< of the sheet
  std::string sheet = {};            ///< JSON
  std::vector<RunResult> results = {};
};

class RunStore {
 public:
  /// `folder` is made when something is kept; empty: there is no place for it.
  RunStore(std::string folder, EventHub& events);

  /// A new run if it has no id, else another sheet for it, with the results that go with it;
  /// `run.sheet_revision` says on which sheet it follows. @throws Refusal 404 for one that there is
  /// not, 409 if another sheet came meanwhile, 422 for too many runs; MissingResource
  KeptRun keep(KeptRun run);

  /// Writes down one result. @throws Refusal 404, 409 as keep()
  KeptRun add_result(const std::string& id, RunResult result, std::uint64_t sheet_revision);

  /// @throws Refusal 404
  void remove(const std::string& id);

  [[nodiscard]] std::string json(const std::string& id) const;
  /// An array of all without their sheets, the last changed first. Files that cannot be read are
  /// left out.
  [[nodiscard]] std::string list_json() const;

 private:
  [[nodiscard]] std::string path_of(const std::string& id) const;
  [[nodiscard]] KeptRun read(const std::string& id) const;
  void write(const KeptRun& run) const;
  void publish(const KeptRun& run, bool removed);

  std::string folder_;
  EventHub& events_;
  mutable std::mutex mutex_;
};

}  // namespace changeover::serve
