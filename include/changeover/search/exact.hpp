// Is there a change covering design with exactly b blocks? Found, or proved that there is none.
//
//     RunControl control({.time = std::chrono::seconds(60)});
//     Decision decision = decide({.v = 9, .k = 4, .change = 1}, 11, {.proof_directory = "proofs"}, control);
//     decision.excluded();                     // true: there is none, and the proof was checked
//     decision.parts.front().proof_path;       // "proofs/linear-m1-v9-k4-b11.drat", and .cnf beside it
//
// The question becomes a formula (src/search/exact/exact_encoding.hpp) for a SAT solver. A design is verified before it
// is handed out. "None" is said only after the solver's DRAT proof, read back from the disk with the
// formula, was checked by room proof, which shares no code with what made them; anyone can check the two files
// with another checker. docs/trust.md says what trust remains.
//
// With one thread and no share the formula is solved whole. With more, or if several processes share the
// search (RunControl::Settings::share), it is split into cubes; each has a formula and a proof of its own,
// and it is checked that the cubes leave nothing out. Every process makes the same cubes and takes every
// share.of-th of them: there is none if all of them excluded their part (Decision::in_share).
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "changeover/run/outcome.hpp"
#include "changeover/verify/verified_design.hpp"

namespace changeover {

/// Which clauses beyond the definition the formula has; the default is what was measured to be best.
struct EncodingOptions {
  bool order = true;
  bool degrees = true;
  std::uint64_t budget = 4;  ///< count repetitions if at most so many are possible
};

struct ExactOptions {
  /// Where formulas and proofs are kept, named by their parameters; made if it is missing. Files appear
  /// whole or not at all, and only if there is no design. Empty: temporary files that are removed.
  std::string proof_directory = {};
  /// Without a proof "none" cannot be said, only that the solver says so; designs are found a little faster.
  bool prove = true;
  /// The most time for one number of blocks, besides the limit of the control.
  std::optional<std::chrono::duration<double>> time_per_step = {};
  /// The most conflicts of the solver for one number of blocks (for each part, if it is split). With one thread
  /// the answer then does not depend on the machine.
  std::optional<std::uint32_t> conflicts_per_step = {};
  EncodingOptions encoding = {};
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

/// Checks, before long work, that decide() would have what it needs: memory that the control allows, where the
/// formula is counted and not built, and the folder for proofs, which is made if it is missing. Returns the threads
/// that the memory allows, those of the control or fewer.
/// @throws ImpossibleParameters as check(); MissingResource; Stopped as stop_if_asked(). As fast as
/// design_formula_size().
unsigned require_room(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                      const RunControl& control);

/// Decides whether there is a design with exactly b ≥ 1 blocks.
/// @throws ImpossibleParameters as check(); BadInput if b = 0; MissingResource if the formula is too large, or if a
/// file cannot be written whole and no design was found meanwhile; InternalError if a design does not verify or a proof does
/// not check. Bound by: the solver; checking takes about as long again.
[[nodiscard]] Decision decide(const Parameters& p, std::uint64_t b, const ExactOptions& options,
                              RunControl& control);

/// The name of the files of a question, without folder and ending: "linear-m1-v9-k4-b11", with "-t3" before
/// the number of blocks if the strength is 3.
[[nodiscard]] std::string file_stem(const Parameters& p, std::uint64_t b);

}  // namespace changeover
