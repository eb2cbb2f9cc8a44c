// Wraps the SAT solver CaDiCaL [BiereEtAl2020]: it stops when a search is to stop, and no exception
// of a callback passes through it.
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

/// Called by the solver every few conflicts.
struct SatWatch {
  std::function<Progress()> progress;  ///< reported to the control when it is due
  std::function<bool()> give_up = {};  ///< stops the solver, like the control
};

class SatEngine {
 public:
  SatEngine();
  ~SatEngine();
  SatEngine(const SatEngine&) = delete;
  SatEngine& operator=(const SatEngine&) = delete;

  /// Call before anything is added. @throws InternalError if the solver does not know the option.
  void set(const char* option, int value);
  /// Likewise: counts conflicts, which the solver does not report, by the clauses that it learns.
  void count_conflicts();
  /// Likewise: writes a DRAT proof as text. Write errors are not detected.
  void trace_proof(std::FILE* file, const std::string& name);
  void close_proof();

  /// Passes new clauses to the solver. Returns false if the control requests a stop: the next call
  /// continues from there. @throws MissingResource if memory is too small, as solve().
  [[nodiscard]] bool add(const Cnf& cnf, RunControl& control);
  /// The same for unit clauses.
  void add_units(std::span<const Literal> literals);

  /// Call before one solve(): these literals hold in the model that it looks for.
  void assume(std::span<const Literal> literals);
  /// Call before one solve(): decisions try these literals first, until others are given.
  void prefer(std::span<const Literal> literals);

  /// Searches for a model of all clauses until the control requests a stop or `conflicts` more
  /// conflicts have occurred. An exception of a callback is rethrown when the solver has ended.
  [[nodiscard]] Outcome solve(RunControl& control, std::optional<std::uint64_t> conflicts,
                              const SatWatch& watch);

  /// Whether the literal holds in the model that the last solve() found.
  [[nodiscard]] bool holds(Literal literal) const;

  /// The number so far, since count_conflicts().
  [[nodiscard]] std::uint64_t conflicts() const;

 private:
  struct Solver;
  template <typename Work>
  auto within_memory(Work&& work) const;

  std::unique_ptr<Solver> solver_;
  std::size_t handed_over_ = 0;  // literals
  std::size_t clauses_ = 0;      // of the formula with these literals
  std::vector<Literal> preferred_;
};

}  // namespace changeover
