// changeover minima: the table of small minima, continued where it was stopped; docs/minima.md is
// made of it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "answer/answer.hpp"
#include "changeover/search/exact.hpp"
#include "io/file/file_lock.hpp"
#include "request/output.hpp"
#include "request/parameters.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct MinimaRequest {
  std::string data;
  std::optional<std::uint64_t> v_to;
  std::optional<std::uint64_t> k_from;
  std::optional<std::uint64_t> k_to;
  std::optional<std::uint64_t> strength;
  std::optional<std::uint64_t> conflicts;
  RunRequest run;
  OutputRequest output;

  /// What is asked for, filled in where it says nothing.
  [[nodiscard]] MinimaRange range() const {
    constexpr std::uint64_t usual_k = 8;
    MinimaRange range{.k_from = k_from.value_or(2),
                      .k_to = k_to.value_or(usual_k),
                      .v_to = v_to.value_or(2 * usual_k),
                      .strength = strength_of(strength)};
    if (range.k_from > range.k_to) {
      throw UsageError{
          fmt::format("--k-from {} --k-to {}: the range is empty; write the smaller number first",
                      range.k_from, range.k_to)};
    }
    // Rows that need no search are made however many there are.
    constexpr std::uint64_t most_elements = 1000;
    if (range.v_to > most_elements) {
      throw UsageError{
          fmt::format("--v {} is out of range; give at most {}", range.v_to, most_elements)};
    }
    return range;
  }

  /// Whether a row is in the answer: what is not asked about is not limited.
  [[nodiscard]] bool shows(const MinimaRow& row) const {
    const Parameters& p = row.parameters;
    return (!v_to || p.v <= *v_to) && (!k_from || p.k >= *k_from) && (!k_to || p.k <= *k_to) &&
           (!strength || p.strength == *strength);
  }
};

// No file yet, no rows; what is there must be readable.
std::vector<MinimaRow> rows_of(const std::string& path) {
  std::error_code error;
  if (std::filesystem::status(path, error).type() == std::filesystem::file_type::not_found) {
    return {};
  }
  return read_minima(*open_input(path));
}

Answer run(const MinimaRequest& request) {
  const MinimaRange range = request.range();
  const std::string data = request.data.empty() ? "minima.csv" : request.data;
  const bool searches = !request.run.time.empty() &&
                        parse_duration(request.run.time, "--time") > std::chrono::seconds(0);
  const bool saves = searches || !request.data.empty();
  require_file("--data", data, "rows are read and written");
  check_inputs(request.output, {{"--data", data}});
  std::optional<FileLock> lock;
  if (saves) {
    lock.emplace(data);
  }
  std::vector<MinimaRow> rows = rows_of(data);
  const auto save = [&] { write_file(data, [&](OutputFile& file) { write_minima(rows, file); }); };
  constexpr std::uint64_t usual_conflicts = 100'000;
  constexpr std::uint64_t most_conflicts = std::numeric_limits<std::uint32_t>::max();
  MinimumOptions options;
  options.exact.conflicts_per_step = static_cast<std::uint32_t>(
      std::min(request.conflicts.value_or(usual_conflicts), most_conflicts));
  options.tries_above = 1;
  RunRequest limits = request.run;
  if (!searches) {
    limits.time = limits.default_time = "";  // What needs no search is found whatever it takes.
  }
  limits.threads = 1;  // so that the table is the same everywhere
  const auto running = std::make_shared<Running>(limits, request.output);
  if (saves) {
    save();  // not only after the work, if it is in vain
  }
  // First what needs no search, however far up.
  RunControl no_search(running->control(), std::chrono::seconds(0));
  fill_minima(range, rows, options, no_search, [](const MinimaRow&) {});
  if (searches) {
    fill_minima(range, rows, options, running->control(), [&](const MinimaRow&) { save(); });
  }
  running->finish();
  if (saves) {
    save();
  }
  std::erase_if(rows, [&](const MinimaRow& row) { return !request.shows(row); });
  return final_answer(running,
                      text_answer(request.output.json()                ? minima_json(rows)
                                  : request.output.format() == "latex" ? minima_latex(rows)
                                                                       : minima_markdown(rows),
                                  request.output));
}

}  // namespace

void add_minima(Program& program) {
  auto [verb, request] = program.add<MinimaRequest>(
      "minima", "make the table of small minima, by exact search with checked proofs", run);
  verb.option("--data", request.data, "FILE",
              "rows so far, and where new ones go (default minima.csv, written with --time only)");
  verb.option("--v", request.v_to, "V", "elements, at most (new rows: 16; shown: all)");
  verb.option("--k-from", request.k_from, "K", "elements in a block, at least (2; all)");
  verb.option("--k-to", request.k_to, "K", "elements in a block, at most (8; all)");
  verb.option("--strength", request.strength, "T",
              fmt::format("from 2 to {} (new rows: 2; shown: all)", max_strength));
  verb.option("--conflicts", request.conflicts, "N",
              "work on one number of blocks, in conflicts of the solver (default 100000)");
  request.run.add_limits_to(verb, "0s", request.output, false);
  request.output.add_to(verb, {"markdown", "latex", "json"});
  verb.examples({"changeover minima --v 10                   what needs no search, and minima.csv",
                 "changeover minima --time 10m -o minima.md  go on with minima.csv"});
}

}  // namespace changeover::cli
