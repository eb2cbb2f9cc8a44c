// A checker for proofs that a formula has no solution: DIMACS CNF and DRAT, read from streams.
//
//     std::ifstream cnf("a.cnf"), proof("a.drat");
//     ProofVerdict verdict = check_proof(cnf, "a.cnf", proof, "a.drat");
//     verdict.verified();          // the formula is unsatisfiable
//     verdict.line;                // otherwise: the first line that does not follow,
//     verdict.reason;              // and why
//
// A proof is a list of clauses, each of which may be added to the formula without making a
// satisfiable one unsatisfiable, until a contradiction is plain; and of clauses that are dropped
// because they are not needed any more. A clause C may be added if unit propagation from ¬C meets a
// contradiction (RUP), or if that is so for every resolvent of C with a clause on C's first literal
// (RAT) [WetzlerHeuleHunt2014].
//
// The checker goes forward, from the first line to the last, and looks at every added clause. It
// shares no code and no header with whatever made the formula or the proof. As is usual, the
// deletion of a clause that is unit under the literals already fixed is ignored: solvers delete
// such clauses and go on using the literal. Ignoring a deletion can never make a wrong proof pass:
// what is kept is a formula that is satisfiable if the given one is. Deleting a clause that is not
// there changes nothing.
//
// Bound by: unit propagation with two watched literals. Memory: the clauses that are alive, a few
// words each.
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <vector>

namespace changeover {

/// How a proof is written.
enum class ProofFormat : std::uint8_t {
  text,    ///< lines "1 -2 0" and "d 1 -2 0"; lines that start with c are comments
  binary,  ///< 'a' or 'd', then literals as variable-length numbers 2|x| + (x < 0), then 0
};

struct ProofOptions {
  ProofFormat format = ProofFormat::text;
  std::uint64_t max_variable = 4'000'000;               ///< a larger number in a file is BadInput
  std::uint64_t max_literals = std::uint64_t{1} << 30;  ///< alive at once; more is MissingResource
  std::function<bool()> stop = {};  ///< asked several times a second, or more; true ends the check
};

struct ProofVerdict {
  enum class Outcome : std::uint8_t {
    verified,  ///< the formula is unsatisfiable
    refuted,   ///< the proof does not show it, which says nothing about the formula
    stopped,   ///< options.stop said so
  };

  Outcome outcome = Outcome::refuted;
  std::uint64_t line = 0;  ///< of the proof (binary: number of the step), where the check ended
  std::string reason;      ///< one line

  std::uint64_t variables = 0;          ///< the largest variable of the formula
  std::uint64_t clauses = 0;            ///< of the formula
  std::uint64_t added = 0;              ///< clauses of the proof that were checked
  std::uint64_t deleted = 0;            ///< deletions that were obeyed
  std::uint64_t ignored_deletions = 0;  ///< of unit clauses and of clauses that are not there
  std::uint64_t by_resolvents = 0;      ///< of those added, by RAT and not by RUP
  std::uint64_t propagations = 0;       ///< literals that unit propagation visited

  [[nodiscard]] bool verified() const { return outcome == Outcome::verified; }

  bool operator==(const ProofVerdict&) const = default;
};

/// Checks the proof against the formula. The names are for messages.
/// @throws BadInput with one line, the name and the line number if a stream is malformed;
/// MissingResource if memory or options.max_literals do not suffice, or a stream cannot be read.
[[nodiscard]] ProofVerdict check_proof(std::istream& cnf, const std::string& cnf_name,
                                       std::istream& proof, const std::string& proof_name,
                                       const ProofOptions& options = {});

/// Checks the proof in one file against the formula in another. @throws as above, and
/// MissingResource if one cannot be opened.
[[nodiscard]] ProofVerdict check_proof_files(const std::string& cnf_path,
                                             const std::string& proof_path,
                                             const ProofOptions& options = {});

// Do some cubes leave nothing out?
//
//     cubes_cover_everything({{1}, {-1, 2}, {-1, -2}});      // true
//     cubes_cover_everything({{1}, {-1, 2}});                // false: −1 −2 is missing
//
// A cube is a list of literals that are all to hold. If a formula has no solution in any of some
// cubes, and every assignment lies in one of these, then it has no solution at all: that is what
// allows a search to be split, each part with its own proof.

/// Literals that hold together: ±1, ±2, …
using Cube = std::vector<std::int32_t>;

/// Whether each assignment of the variables satisfies all the literals of at least one cube. Splits
/// on a variable of the shortest cube: linear in the total length of the cubes of a binary tree for
/// each of its levels, exponential at worst.
/// @throws BadInput if a literal is 0 or a cube contradicts itself.
[[nodiscard]] bool cubes_cover_everything(const std::vector<Cube>& cubes);

}  // namespace changeover
