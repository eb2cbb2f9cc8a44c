// A run as the document of its file, "changeover-run/1", and what of it is sent.
//
//     const std::string text = run_json(run);
//     const KeptRun again = run_in(text, run.id);      // the same run
//
// Files and bodies are read by the same rules (serve/api/request/query.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/write/json_writer.hpp"
#include "serve/api/request/query.hpp"

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

  /// How many tests have a result.
  [[nodiscard]] std::uint64_t done() const;
};

/// The largest revision, which numbers of JavaScript hold.
inline constexpr std::uint64_t most_revisions = (std::uint64_t{1} << 53) - 1;

/// A text of so many bytes; empty if it is missing. @throws Refusal 422
[[nodiscard]] std::string short_text(JsonBody& body, const std::string& name);
/// What was observed, without `at`. @throws Refusal 422
[[nodiscard]] RunResult result_in(JsonBody& body);
/// A test is called by its number on the sheet, behind the name of its bench if there are several.
/// @throws Refusal 422 for a name that no test of a sheet of so many can have
void require_test(const std::string& test, std::uint64_t tests);
/// Sheet and results, as they are sent and kept. @throws Refusal 422
void read_sheet(JsonBody& body, KeptRun& run);

/// The keys of a run in a list, without `done`.
void write_head(JsonWriter& json, const KeptRun& run);
[[nodiscard]] std::string run_json(const KeptRun& run);
/// The run of that id. @throws BadInput with why, if the text is not all that a run is
[[nodiscard]] KeptRun run_in(const std::string& text, const std::string& id);

}  // namespace changeover::serve
