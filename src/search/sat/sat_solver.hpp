// Deciding one formula, with a proof.
//
//     const SatResult result = solve_sat(cnf, {}, {.proof_path = "a.drat"}, control);
//     if (result.outcome == Outcome::found) { result.is_true(x); }
//     if (result.outcome == Outcome::none) { check_proof_files("a.cnf", "a.drat"); }
//
// Every call makes a solver of its own and hands it the formula with the assumptions as clauses of
// one literal: proofs of a solver that is asked twice do not check. The proof is DRAT in text.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "search/sat/cnf.hpp"

namespace changeover {

struct SatOptions {
  std::string proof_path = {};  ///< an existing file that the proof replaces; empty: no proof
  Progress progress = {};       ///< told while solving; its steps are the kilobytes of the proof
  /// After so many conflicts the solver gives up: a limit that does not depend on the machine.
  std::optional<std::uint32_t> conflicts = {};
};

struct SatResult {
  Outcome outcome = Outcome::unknown;  ///< of looking for a model
  std::vector<bool> model;             ///< by variable, if found; place 0 means nothing

  /// Whether the literal holds in the model; there must be one.
  [[nodiscard]] bool is_true(Literal x) const {
    return x > 0 ? model[static_cast<std::size_t>(x)] : !model[static_cast<std::size_t>(-x)];
  }
};

/// Decides a formula. Deterministic unless it is stopped.
/// @throws MissingResource if the proof cannot be written whole, or memory does not suffice;
/// InternalError if the solver lacks an option that proofs need; whatever the control's callback
/// throws. Bound by: the solver; exponential at worst.
[[nodiscard]] SatResult solve_sat(const Cnf& cnf, std::span<const Literal> assumptions,
                                  const SatOptions& options, RunControl& control);

/// Splits a formula into at most 2^depth cubes that leave nothing out: a binary tree whose inner
/// nodes branch on one of the variables 1 … candidates, the one of which both values fix most
/// others by unit propagation, looking ahead [HeuleKullmannWieringaBiere2011]. Where every value of
/// every candidate is known or refuted, a branch ends early. Deterministic.
/// @throws InternalError if there are fewer variables than candidates; Stopped as stop_if_asked().
/// O(2^depth · candidates) propagations.
[[nodiscard]] std::vector<Cube> split_into_cubes(const Cnf& cnf, std::size_t candidates,
                                                 unsigned depth);

}  // namespace changeover
