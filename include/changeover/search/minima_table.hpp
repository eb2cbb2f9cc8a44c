// A table of minima: for each set of small parameters the bound on paper, the best construction, and what
// exact search with checked proofs makes of the gap between them.
//
//     std::vector<MinimaRow> rows = read_minima(*open_input("minima.csv"));       // of an earlier run
//     fill_minima({.changes = {1}, .k_from = 3, .k_to = 3, .v_to = 6}, rows, {}, control,
//                 [&](const MinimaRow&) {
//                   OutputFile file("minima.csv");
//                   write_minima(rows, file);
//                   file.commit();
//                 });
//     std::string text = minima_markdown(rows);
//
// Filling goes on where it was stopped: rows that are settled stay, and so do those that were tried with at least
// as many conflicts a step. A limit of conflicts and not of time makes the table the same everywhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/search/minimum_search.hpp"

namespace changeover {

/// What is known of one set of parameters. Times are in seconds.
struct MinimaRow {
  Parameters parameters;
  std::uint64_t start = 0;  ///< the largest bound that is a proof on paper
  std::uint64_t lower = 0;  ///< start, and one more for each number that was excluded
  std::optional<std::uint64_t> upper = {};  ///< blocks of the best design
  std::string by = {};                      ///< who made it: a construction's name, or "SAT"
  double seconds = 0;                       ///< that exact search took in all
  double solve_seconds = 0;                 ///< of these, to refute the formulas that were excluded
  double check_seconds = 0;                 ///< and to check their proofs
  std::uint64_t proof_bytes = 0;            ///< of these proofs
  std::uint64_t proof_steps = 0;
  std::uint64_t limit = 0;  ///< conflicts that one number of blocks was given

  [[nodiscard]] bool settled() const { return upper == lower; }

  bool operator==(const MinimaRow&) const = default;
};

struct MinimaRange {
  std::vector<std::uint64_t> changes = {1, 2, 3};
  std::uint64_t k_from = 2;
  std::uint64_t k_to = 8;
  std::uint64_t v_to = 16;
  std::uint32_t strength = 2;
};

/// Fills in what is missing of the range, the smallest v first, so that easy rows come before hard ones, and
/// calls on_row after each new row. Rows stay in the order of strength, m, kind, k and v. With a control that has
/// stopped only rows are filled in that need no search. Ends early, without an exception, where the scope of
/// the caller stops (run/scope.hpp).
/// @throws as find_minimum() and plan_range(), and a MissingResource that ended a search; the rows until then stay.
void fill_minima(const MinimaRange& range, std::vector<MinimaRow>& rows,
                 const MinimumOptions& options, RunControl& control,
                 const std::function<void(const MinimaRow&)>& on_row);

/// CSV with a line of names. Writing, reading and writing again gives the same bytes. @throws as
/// Sink::write().
void write_minima(const std::vector<MinimaRow>& rows, Sink& sink);

/// The rows in their order. @throws BadInput with the line if the text is not what write_minima() writes: impossible parameters,
/// some that stand there twice, and bounds that decrease are refused, too; MissingResource if reading fails.
[[nodiscard]] std::vector<MinimaRow> read_minima(Input& input);

/// One object whose "minima" are the rows, in their order.
[[nodiscard]] std::string minima_json(const std::vector<MinimaRow>& rows);

/// Markdown: tables of minima by v and k, of the proofs and of what is open.
[[nodiscard]] std::string minima_markdown(const std::vector<MinimaRow>& rows);

}  // namespace changeover
