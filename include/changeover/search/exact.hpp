// Is there a change covering design with exactly b blocks? Found, or proved that there is none.
//
//     RunControl control({.time = std::chrono::seconds(60)});
//     Decision decision =
//         decide({.v = 9, .k = 4, .change = 1}, 11, {.proof_directory = "proofs"}, control);
//     decision.excluded();                // true: there is none, and the proof was checked
//     decision.parts.front().proof_path;  // "proofs/linear-m1-v9-k4-b11.drat", and .cnf beside it
//
// The question becomes a formula (src/search/exact/exact_encoding.hpp) for a SAT solver. A design
// is verified before it is handed out. "None" is said only after the solver's DRAT proof, read back
// from the disk with the formula, was checked by room proof, which shares no code with what made
// them; anyone can check the two files with another checker. docs/trust.md says what trust remains.
//
// With one thread and no share the formula is solved whole. With more, or if several processes
// share the search (RunControl::Settings::share), it is split into cubes; each has a formula and a
// proof of its own, and it is checked that the cubes leave nothing out. Every process makes the
// same cubes and takes every share.of-th of them: there is none if all of them excluded their part
// (Decision::in_share).
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// Which clauses beyond the definition the formula has; the default is what was measured to be
/// best.
struct EncodingOptions {
  bool order = true;
  bool degrees = true;
  std::uint64_t budget = 4;  ///< count repetitions if at most so many are possible
};

struct ExactOptions {
  /// Where formulas and proofs are kept, named by their parameters; made if it is missing. Files
  /// appear whole or not at all, and only if there is no design. Empty: temporary files that are
  /// removed.
  std::string proof_directory = {};
  /// Without a proof "none" cannot be said, only that the solver says so; designs are found a
  /// little faster.
  bool prove = true;
  /// The most time for one number of blocks, besides the limit of the control.
  std::optional<std::chrono::duration<double>> time_per_step = {};
  /// The most conflicts of the solver for one number of blocks (for each part, if it is split).
  /// With one thread the answer then does not depend on the machine.
  std::optional<std::uint32_t> conflicts_per_step = {};
  EncodingOptions encoding = {};
  /// The question is split into about so many cubes, 4096 at most, however many threads and shares
  /// there are. 0: 16 for each share, or 8 for each thread; one thread alone splits nothing. Shares
  /// of the same cubes can be divided further: shares i and i + n of 2n are share i of n.
  std::uint64_t cubes = 0;
};

/// One formula without solution, and its proof.
struct CheckedPart {
  Cube cube = {};             ///< the literals assumed; empty if the formula is the whole question
  std::string cnf_path = {};  ///< empty if the files were temporary
  std::string proof_path = {};  ///< likewise
  std::uint64_t variables = 0;
  std::uint64_t clauses = 0;
  std::uint64_t proof_bytes = 0;
  std::uint64_t proof_steps = 0;  ///< clauses added and deleted, as far as the checker had to read
  std::chrono::duration<double> solve_time{};  ///< of the processor
  std::chrono::duration<double> check_time{};  ///< likewise
};

struct Decision {
  Parameters parameters;
  std::uint64_t b = 0;
  Outcome outcome = Outcome::unknown;
  bool proved = false;    ///< if none: with a checked proof; otherwise it is the solver's word
  bool in_share = false;  ///< if none: in the part of this process, of several
  std::optional<VerifiedDesign> design = {};  ///< if found
  std::vector<CheckedPart> parts = {};        ///< what was excluded, each with a checked proof
  std::uint64_t cubes = 1;                    ///< into how many parts the question was split
  std::string cubes_path = {};  ///< the list of the cubes, if there are several and files are kept
  WhyStopped why_stopped = WhyStopped::running;  ///< found, exhausted, or the limit
  std::chrono::duration<double> time{};

  /// Whether there is no such design, proved.
  [[nodiscard]] bool excluded() const { return outcome == Outcome::none && proved && !in_share; }
};

/// Checks, before long work, that decide() would have what it needs: memory that the control
/// allows, where the formula is counted and not built, and the folder for proofs, which is made if
/// it is missing. Returns the threads that the memory allows, those of the control or fewer.
/// @throws ImpossibleParameters as check(); MissingResource; Stopped as stop_if_asked(). As fast as
/// design_formula_size().
unsigned require_room(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                      const RunControl& control);

/// Decides whether there is a design with exactly b ≥ 1 blocks.
/// @throws ImpossibleParameters as check(); BadInput if b = 0; MissingResource if the formula is
/// too large, or if a file cannot be written whole and no design was found meanwhile; InternalError
/// if a design does not verify or a proof does not check. Bound by: the solver; checking takes
/// about as long again.
[[nodiscard]] Decision decide(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                              RunControl& control);

/// The name of the files of a question, without folder and ending: "linear-m1-v9-k4-b11", with
/// "-t3" before the number of blocks if the strength is 3.
[[nodiscard]] std::string file_stem(const Parameters& p, std::uint64_t b);

// The least number of blocks: every smaller one excluded by a proof, and a design.
//
//     RunControl control({.time = std::chrono::minutes(5)});
//     MinimumResult result = find_minimum({.v = 12, .k = 4}, {}, control);
//     result.settled();                     // true
//     // 14, 14: bounds on paper give 13, which a checked proof excludes
//     result.lower;  result.upper();
//
// The walk starts from the largest bound that is a proof on paper (bounds/lower_bound.hpp; minima
// known by exhaustive search are not used: they are what is settled here), and goes up one block at
// a time. It ends at the first design, at the upper bound that is given, or when the control stops
// it: then an interval is left.

struct MinimumOptions {
  ExactOptions exact = {};
  /// If the limit of a step is reached (ExactOptions) and the walk must end: how many greater
  /// numbers of blocks are tried, without proof, for a better upper bound.
  std::uint64_t tries_above = 0;
  /// Who decides about a number of blocks, if not decide(): several processes that share each
  /// question, say.
  std::function<Decision(std::uint64_t b, const ExactOptions&)> decider = {};
};

struct MinimumResult {
  Parameters parameters;
  std::optional<std::string> impossible = {};  ///< why no design exists with any number of blocks
  Bound start;                                 ///< the bound on paper from which the walk started
  std::uint64_t lower = 0;                     ///< no design has fewer blocks
  std::optional<VerifiedDesign> best = {};     ///< the given design, or a better one
  std::vector<Decision> steps = {};            ///< in the order of the walk
  WhyStopped why_stopped =
      WhyStopped::running;  ///< exhausted if settled or impossible; the limit if not
  /// A MissingResource that ended the walk before its time, if something is known all the same:
  /// `best`, or steps. Show what is known, then throw it on.
  std::exception_ptr fault = {};
  std::chrono::duration<double> time{};

  /// The number of blocks of `best`.
  [[nodiscard]] std::optional<std::uint64_t> upper() const;
  /// `best` has `lower` blocks.
  [[nodiscard]] bool settled() const { return upper() == lower; }
};

/// The largest bound that is a proof on paper. @throws as lower_bounds().
[[nodiscard]] Bound lower_bound_on_paper(const Parameters& p);

/// Walks up to the minimum. `known` is a design with these parameters, from a construction say; it
/// is verified. What is stopped while `known` is verified or bounds are looked for goes on without:
/// one block is a bound.
/// @throws as decide() if nothing is known by then, and BadInput if `known` is not a design with
/// these parameters. Bound by: decide().
[[nodiscard]] MinimumResult find_minimum(const Parameters& p, const MinimumOptions& options,
                                         RunControl& control,
                                         const std::optional<Design>& known = std::nullopt);

// A table of minima: for each set of small parameters the bound on paper, the best construction,
// and what exact search with checked proofs makes of the gap between them.
//
//     std::vector<MinimaRow> rows = read_minima(*open_input("minima.csv"));  // of an earlier run
//     fill_minima({.changes = {1}, .k_from = 3, .k_to = 3, .v_to = 6}, rows, {}, control,
//                 [&](const MinimaRow&) {
//                   OutputFile file("minima.csv");
//                   write_minima(rows, file);
//                   file.commit();
//                 });
//     std::string text = minima_markdown(rows);
//
// Filling goes on where it was stopped: rows that are settled stay, and so do those that were tried
// with at least as many conflicts a step. A limit of conflicts and not of time makes the table the
// same everywhere.

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

/// Fills in what is missing of the range, the smallest v first, so that easy rows come before hard
/// ones, and calls on_row after each new row. Rows stay in the order of strength, m, kind, k and v.
/// With a control that has stopped only rows are filled in that need no search. Ends early, without
/// an exception, where the scope of the caller stops (run/control.hpp).
/// @throws as find_minimum() and best_known_table(), and a MissingResource that ended a search; the
/// rows until then stay.
void fill_minima(const MinimaRange& range, std::vector<MinimaRow>& rows,
                 const MinimumOptions& options, RunControl& control,
                 const std::function<void(const MinimaRow&)>& on_row);

/// CSV with a line of names. Writing, reading and writing again gives the same bytes. @throws as
/// Sink::write().
void write_minima(const std::vector<MinimaRow>& rows, Sink& sink);

/// The rows in their order. @throws BadInput with the line if the text is not what write_minima()
/// writes: impossible parameters, some that stand there twice, and bounds that decrease are
/// refused, too; MissingResource if reading fails.
[[nodiscard]] std::vector<MinimaRow> read_minima(Input& input);

/// One object whose "minima" are the rows, in their order.
[[nodiscard]] std::string minima_json(const std::vector<MinimaRow>& rows);

/// Markdown: tables of minima by v and k, of the proofs and of what is open.
[[nodiscard]] std::string minima_markdown(const std::vector<MinimaRow>& rows);

/// The same as LaTeX, for the packages booktabs and longtable.
[[nodiscard]] std::string minima_latex(const std::vector<MinimaRow>& rows);

}  // namespace changeover
