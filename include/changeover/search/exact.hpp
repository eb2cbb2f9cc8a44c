// Decides whether there is a change covering design with exactly b blocks: finds one, or proves
// that there is none.
//
//     RunControl control({.time = std::chrono::seconds(60)});
//     Decision decision =
//         decide({.v = 9, .k = 4, .change = 1}, 11, {.proof_directory = "proofs"}, control);
//     decision.excluded();                // true: there is none, and the proof was checked
//     decision.parts.front().proof_path;  // "proofs/linear-m1-v9-k4-b11.drat", and .cnf beside it
//
// The question becomes a formula (internal: src/search/exact/exact_encoding.hpp) for a SAT solver.
// A design is verified before it is returned. "None" is returned only after a check of the solver's
// DRAT proof, which is read back from the disk with the formula. The checker (module proof) shares
// no code with what made them, and other checkers can read the two files, too. docs/trust.md says
// what remains to be trusted.
//
// The design may be wanted with more than that (search/wanted.hpp): then it is one that has it, and
// "none" is about designs that have it, and says nothing about others.
//
//     ExactOptions options;
//     options.wanted = {.first = {0, 1}, .last = {0, 1}};
//     decide({.v = 6, .k = 3, .change = 1}, 8, options, control);
//
// With one thread and without a share the formula is solved whole. With more threads, or if several
// processes share the search (RunControl::Settings::share), it is split into cubes. Each has its
// own formula and proof, and a check shows that the cubes cover all cases. Every process makes the
// same cubes and takes every share.of-th of them: there is no design if all processes excluded
// their part (Decision::in_share).
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/wanted.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// The clauses of the formula beyond the definition; the defaults are the fastest ones measured.
struct EncodingOptions {
  bool order = true;
  bool degrees = true;
  std::uint64_t budget = 4;  ///< count repetitions if at most this many are possible
};

struct ExactOptions {
  /// Folder for formulas and proofs, named by their parameters; created if it is missing. Files
  /// appear complete or not at all, and only if there is no design. Empty: temporary files that are
  /// removed.
  std::string proof_directory = {};
  /// Without proofs, "none" is only a statement of the solver; designs are found a little faster.
  bool prove = true;
  /// Time limit for one number of blocks, besides the limit of the control.
  std::optional<std::chrono::duration<double>> time_per_step = {};
  /// Limit for conflicts of the solver for one number of blocks (for each part, if it is split).
  /// With one thread the result is then the same on every machine.
  std::optional<std::uint32_t> conflicts_per_step = {};
  EncodingOptions encoding = {};
  /// Approximate number of cubes, at most 4096, independent of the numbers of threads and shares.
  /// 0 means 16 for each share or, without shares, 8 for each thread; one thread alone does not
  /// split. With a number given, a run in n shares can be split further into 2n: share i of n is
  /// shares i and i + n of 2n.
  std::uint64_t cubes = 0;
  /// What the design must have besides; any strength.
  Wanted wanted = {};
};

/// One unsatisfiable formula, and its proof.
struct CheckedPart {
  Cube cube = {};             ///< the literals assumed; empty if the formula is the whole question
  std::string cnf_path = {};  ///< empty if the files were temporary
  std::string proof_path = {};  ///< likewise
  std::uint64_t variables = 0;
  std::uint64_t clauses = 0;
  std::uint64_t proof_bytes = 0;
  std::uint64_t proof_steps =
      0;  ///< clauses added and deleted, as far as the checker had to read them
  std::chrono::duration<double> solve_time{};  ///< processor time
  std::chrono::duration<double> check_time{};  ///< likewise
};

struct Decision {
  Parameters parameters;
  std::uint64_t b = 0;
  Outcome outcome = Outcome::unknown;
  bool proved =
      false;  ///< for outcome `none`: a proof was checked; else it is a statement of the solver
  bool in_share = false;  ///< for outcome `none`: only in the share of this process
  std::optional<VerifiedDesign> design = {};  ///< for outcome `found`
  std::vector<CheckedPart> parts = {};        ///< the excluded parts, each with a checked proof
  std::uint64_t cubes = 1;                    ///< number of parts into which the question was split
  std::string cubes_path = {};  ///< the list of cubes, if there are several and files are kept
  WhyStopped why_stopped = WhyStopped::running;  ///< found, exhausted, or the limit
  std::chrono::duration<double> time{};
  /// The unchanged subsets that are wanted, for outcome `found`.
  std::vector<UnchangedSubset> subsets = {};

  /// Whether it is proved that there is no such design, with what is wanted.
  [[nodiscard]] bool excluded() const { return outcome == Outcome::none && proved && !in_share; }
};

/// Checks before long work that decide() has what it needs: memory within the limit of the control
/// (the formula is counted, not built), and the folder for proofs, which is created if it is
/// missing. Returns the number of threads that the memory allows, at most that of the control.
/// @throws ImpossibleParameters as check(); MissingResource; Stopped as stop_if_asked(). As fast as
/// design_formula_size().
unsigned require_room(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                      const RunControl& control);

/// Decides whether there is a design with exactly b ≥ 1 blocks. @throws ImpossibleParameters as
/// check(); BadInput if b = 0 or wanted_defect() finds one; MissingResource if the formula is too
/// large, or if a file cannot be written and no design was found meanwhile; InternalError if a
/// design fails verification or lacks what is wanted, or a proof fails its check. Time: that of the
/// solver; checking takes about as long again.
[[nodiscard]] Decision decide(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                              RunControl& control);

/// The name of the files of a question, without folder and extension: "linear-m1-v9-k4-b11", with
/// "-t3" before the number of blocks if the strength is 3, and "-with-" and 16 digits made of what
/// is wanted at the end, if anything is. Without b: of all numbers of blocks.
[[nodiscard]] std::string file_stem(const Parameters& p, std::optional<std::uint64_t> b,
                                    const Wanted& wanted = {});

// The minimum number of blocks: a design, and a proof that excludes every smaller number.
//
//     RunControl control({.time = std::chrono::minutes(5)});
//     MinimumResult result = find_minimum({.v = 12, .k = 4}, {}, control);
//     result.settled();                     // true
//     // 14, 14: bounds on paper give 13, which a checked proof excludes
//     result.lower;  result.upper();
//
// The search starts from the largest bound with a proof on paper (bounds/lower_bound.hpp). Minima
// known by exhaustive search are not used, since they are what is settled here. It goes up one
// block at a time, and ends at the first design, at the given upper bound, or when the control
// stops it; then an interval remains.

struct MinimumOptions {
  ExactOptions exact = {};
  /// After the limit of a step is reached (ExactOptions): how many greater numbers of blocks are
  /// tried, without proof, for a better upper bound.
  std::uint64_t tries_above = 0;
  /// Used instead of decide(), for example by several processes that share each question.
  std::function<Decision(std::uint64_t b, const ExactOptions&)> decider = {};
  /// If something is wanted: begins with the best of the known designs that have it, if any has.
  bool from_known = true;
};

struct MinimumResult {
  Parameters parameters;
  std::optional<std::string> impossible = {};  ///< why no design exists with any number of blocks
  Bound start;  ///< the bound on paper from which the search started, with what is wanted
  std::uint64_t lower = 0;                  ///< proven lower bound on the number of blocks
  std::optional<VerifiedDesign> best = {};  ///< the given design, or a better one
  std::vector<Decision> steps = {};         ///< in the order of the search
  WhyStopped why_stopped =
      WhyStopped::running;  ///< `exhausted` if settled or impossible; otherwise the limit
  /// A MissingResource that ended the search early although something is known: `best`, or steps.
  /// Show what is known, then rethrow it.
  std::exception_ptr fault = {};
  std::chrono::duration<double> time{};
  std::vector<UnchangedSubset> subsets = {};  ///< of `best`, those that are wanted
  bool known = false;  ///< `best` is a known design, renumbered to have what is wanted

  /// The number of blocks of `best`.
  [[nodiscard]] std::optional<std::uint64_t> upper() const;
  /// Whether `best` has `lower` blocks.
  [[nodiscard]] bool settled() const { return upper() == lower; }
};

/// The largest bound with a proof on paper. @throws as lower_bounds().
[[nodiscard]] Bound lower_bound_on_paper(const Parameters& p);

/// Searches for the minimum. `known` is a design with these parameters, for example from a
/// construction; it is verified. If the verification of `known` or the search for bounds is
/// stopped, the search continues without them: one block is a bound. @throws as decide() if nothing
/// is known by then, and BadInput if `known` is not a design with these parameters, or is given
/// although something is wanted. Time: that of decide().
[[nodiscard]] MinimumResult find_minimum(const Parameters& p, const MinimumOptions& options,
                                         RunControl& control,
                                         const std::optional<Design>& known = std::nullopt);

// A table of minima: for each set of small parameters the bound on paper, the best construction,
// and how far exact search with checked proofs closes the gap between them.
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
// Filling continues where it was stopped: settled rows stay, and so do rows that were tried with at
// least as many conflicts per step. With a limit of conflicts and none of time the table is the
// same on every machine.

/// The results for one set of parameters. Times are in seconds.
struct MinimaRow {
  Parameters parameters;
  std::uint64_t start = 0;                  ///< the largest bound with a proof on paper
  std::uint64_t lower = 0;                  ///< start, plus one for each excluded number
  std::optional<std::uint64_t> upper = {};  ///< blocks of the best design
  std::string by = {};            ///< the name of the construction of that design, or "SAT"
  double seconds = 0;             ///< of exact search in total
  double solve_seconds = 0;       ///< of these, for refuting the excluded formulas
  double check_seconds = 0;       ///< of these, for checking their proofs
  std::uint64_t proof_bytes = 0;  ///< size of these proofs
  std::uint64_t proof_steps = 0;
  std::uint64_t limit = 0;  ///< limit of conflicts for one number of blocks

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

/// Fills in the missing rows of the range, smallest v first, so that easy rows come before hard
/// ones, and calls on_row after each new row. Rows are sorted by strength, m, kind, k and v. If the
/// control has stopped, only rows that need no search are filled in. If the scope of the caller
/// stops (run/control.hpp), the function returns early, without an exception. @throws as
/// find_minimum() and best_known_table(), and a MissingResource that ended a search; the rows so
/// far stay.
void fill_minima(const MinimaRange& range, std::vector<MinimaRow>& rows,
                 const MinimumOptions& options, RunControl& control,
                 const std::function<void(const MinimaRow&)>& on_row);

/// Writes CSV with a header. Writing, reading and writing again gives the same bytes. @throws as
/// Sink::write().
void write_minima(const std::vector<MinimaRow>& rows, Sink& sink);

/// Reads the rows in their order. @throws BadInput with the line if the text is not as written by
/// write_minima(), also for impossible parameters, repeated parameters, and bounds that decrease;
/// MissingResource if reading fails.
[[nodiscard]] std::vector<MinimaRow> read_minima(Input& input);

/// One JSON object whose "minima" are the rows, in their order.
[[nodiscard]] std::string minima_json(const std::vector<MinimaRow>& rows);

/// Markdown: tables of minima by v and k, of the proofs, and of open cases.
[[nodiscard]] std::string minima_markdown(const std::vector<MinimaRow>& rows);

/// The table of minima as LaTeX, for the packages booktabs and longtable.
[[nodiscard]] std::string minima_latex(const std::vector<MinimaRow>& rows);

}  // namespace changeover
