// The SAT solver CaDiCaL [BiereEtAl2020], as everything here uses it: it stops when a search is to
// stop, and nothing that a callback throws passes through it.
//
//     SatEngine engine;
//     if (engine.add(cnf, control)) {
//       engine.solve(control, 100'000, {.progress = [] { return Progress{.phase = "deciding"}; }});
//     }
//
// For one formula, with a proof if wanted, there is sat_solver.hpp; for one that grows,
// incremental_solver.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/run/control.hpp"
#include "search/sat/cnf.hpp"

namespace changeover {

/// Asked by the solver every few conflicts.
struct SatWatch {
  std::function<Progress()> progress;  ///< what the control is told when it is due
  std::function<bool()> give_up = {};  ///< besides the control
};

class SatEngine {
 public:
  SatEngine();
  ~SatEngine();
  SatEngine(const SatEngine&) = delete;
  SatEngine& operator=(const SatEngine&) = delete;

  /// Before anything is added. @throws InternalError if the solver does not know the option.
  void set(const char* option, int value);
  /// Likewise: counts conflicts, which the solver does not tell, by the clauses that it learns.
  void count_conflicts();
  /// Likewise: writes a DRAT proof in text. It is not checked whether that succeeds.
  void trace_proof(std::FILE* file, const std::string& name);
  void close_proof();

  /// Hands over the clauses that were not yet; false if the control wants to stop: the next call
  /// goes on there.
  /// @throws MissingResource if memory does not suffice, as solve().
  [[nodiscard]] bool add(const Cnf& cnf, RunControl& control);
  /// The same for clauses of one literal each.
  void add_units(std::span<const Literal> literals);

  /// Before one solve(): these hold in the model that it looks for.
  void assume(std::span<const Literal> literals);
  /// Before one solve(): decisions take these first. They count until others are given.
  void prefer(std::span<const Literal> literals);

  /// Looks for a model of all clauses until the control wants to stop or `conflicts` more conflicts
  /// have been had. What a callback throws is thrown when the solver has ended.
  [[nodiscard]] Outcome solve(RunControl& control, std::optional<std::uint64_t> conflicts,
                              const SatWatch& watch);

  /// Whether the literal holds in the model that the last solve() found.
  [[nodiscard]] bool holds(Literal literal) const;

  /// Had so far, since count_conflicts().
  [[nodiscard]] std::uint64_t conflicts() const;

 private:
  struct Solver;
  template <typename Work>
  auto within_memory(Work&& work) const;

  std::unique_ptr<Solver> solver_;
  std::size_t handed_over_ = 0;  // literals
  std::size_t clauses_ = 0;      // of the formula that they are of
  std::vector<Literal> preferred_;
};

}  // namespace changeover
