// changeover minima: the table of small minima, continued where it was stopped; docs/minima.md is made of it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "changeover/core/error.hpp"
#include "changeover/search/minima_table.hpp"
#include "request.hpp"
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
  std::optional<std::uint64_t> time;
  OutputRequest output;
};

int run(const MinimaRequest& request) {
  std::vector<MinimaRow> rows;
  if (std::filesystem::exists(request.data)) {
    rows = read_minima(*open_input(request.data));
  }
  const auto save = [&] {
    OutputFile file(request.data);
    write_minima(rows, file);
    file.commit();
  };
  constexpr std::uint64_t usual_k = 8;
  const MinimaRange range{
      .k_from = request.k_from.value_or(2),
      .k_to = request.k_to.value_or(usual_k),
      .v_to = request.v_to.value_or(2 * usual_k),
      .strength = static_cast<std::uint32_t>(request.strength.value_or(2)),
  };
  constexpr std::uint64_t usual_conflicts = 100'000;
  constexpr std::uint64_t most_conflicts = std::numeric_limits<std::uint32_t>::max();
  MinimumOptions options;
  options.exact.conflicts_per_step = static_cast<std::uint32_t>(
      std::min(request.conflicts.value_or(usual_conflicts), most_conflicts));
  options.tries_above = 1;
  RunControl control({.time = std::chrono::seconds(request.time.value_or(0))});
  // A row that cost nothing is written with the next one that did.
  fill_minima(range, rows, options, control, [&](const MinimaRow& row) {
    if (row.seconds > 0) {
      save();
    }
  });
  save();
  deliver(minima_markdown(rows), request.output.path);
  return exit_code::done;
}

}  // namespace

void add_minima(Program& program) {
  auto request = std::make_shared<MinimaRequest>();
  request->data = "minima.csv";
  Verb& verb = program.add(
      "minima", "the table of small minima, settled by exact search with checked proofs");
  verb.option("--data", request->data, "FILE", "rows so far, and where new ones go (minima.csv)");
  verb.option("--v", request->v_to, "V", "elements, at most (default 16)");
  verb.option("--k-from", request->k_from, "K", "elements in a block, at least (default 2)");
  verb.option("--k-to", request->k_to, "K", "elements in a block, at most (default 8)");
  verb.option("--strength", request->strength, "T", "2, 3 or 4 (default 2)");
  verb.option("--conflicts", request->conflicts, "N",
              "work on one number of blocks, in conflicts of the solver (default 100000)");
  verb.option("--time", request->time, "SECONDS",
              "time for new rows (default 0: only write the table)");
  request->output.add_to(verb, {"markdown"});
  verb.examples({"changeover minima --time 600 -o minima.md"});
  verb.run([request] { return run(*request); });
}

}  // namespace changeover::cli
