// Runs of tests that the server keeps: what was planned, and the results of its tests, which
// several people write down, on several days.
//
//     RunStore store(folder, events);
//     const std::string id = store.keep({.title = "Pump bench", .sheet = "{…}"}).id;
//     store.add_result(id, {.test = "3", .result = "pass", .by = "Ann"}, 1);
//     store.json(id);
//
// A run is a file in the folder, format "changeover-run/1", which appears whole or not at all and
// is read again for each question; a lock lets one server at a time change it. The sheet is the
// page's own: an object that the server does not look into. Results are of tests of one sheet:
// with each comes the revision of the sheet, and one of a sheet that was replaced is refused.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "serve/http/events.hpp"
#include "serve/plans/run_document.hpp"

namespace changeover::serve {

class RunStore {
 public:
  /// `folder` is made when something is kept; empty: there is no place for it.
  RunStore(std::string folder, EventHub& events);

  /// A new run if it has no id, else another sheet for it, with the results that go with it;
  /// `run.sheet_revision` says on which sheet it follows. @throws Refusal 404 for one that there is
  /// not, 409 if another sheet came meanwhile, 413 if it were too large, 422 for too many runs;
  /// MissingResource
  KeptRun keep(KeptRun run);

  /// Writes down one result. @throws Refusal 404, 409, 413 as keep(), 422 for a test that is not on
  /// the sheet
  KeptRun add_result(const std::string& id, RunResult result, std::uint64_t sheet_revision);

  /// @throws Refusal 404
  void remove(const std::string& id);

  /// @throws Refusal 404; MissingResource for a file that cannot be read as a run
  [[nodiscard]] std::string json(const std::string& id) const;
  /// An array of all without their sheets, the last changed first. Files that cannot be read as
  /// runs are left out. What is known of a file is remembered until its time or size changes.
  /// @throws MissingResource if the folder cannot be read
  [[nodiscard]] std::string list_json() const;

 private:
  struct Listed {
    std::array<std::int64_t, 4> stamp = {};  ///< of the file, whatever is in it
    std::optional<KeptRun> run = {};         ///< without sheet and results; nullopt: it is none
    std::uint64_t done = 0;
  };

  [[nodiscard]] std::string path_of(const std::string& id) const;
  /// The ids of the files that are named as runs.
  [[nodiscard]] std::vector<std::string> ids() const;
  [[nodiscard]] KeptRun read(const std::string& id) const;
  [[nodiscard]] std::optional<Listed> listed(const std::string& id) const;
  /// @throws Refusal 413, 422 for one that could not be read again
  void write(const KeptRun& run) const;
  void publish(const KeptRun& run, bool removed);

  std::string folder_;
  EventHub& events_;
  std::mutex mutex_;  // of those that write
  mutable std::mutex listed_mutex_;
  mutable std::map<std::string, Listed> listed_;
};

}  // namespace changeover::serve
