// Jobs of a model (plan/model.hpp): every set-up has one value of each parameter and follows all
// rules. A SAT solver decides which values can be together.
//
//     ChoiceSolver solver(job);
//     // A set-up with both, similar to job.start if that is easy; or nullopt.
//     solver.completed({3, 17}, job.start);
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/model/compiled_rules.hpp"
#include "search/sat/sat_solver.hpp"

namespace changeover {

/// The set-ups of a job of a model. The job must outlive this, unchanged.
class ChoiceSolver {
 public:
  explicit ChoiceSolver(const Job& job);

  /// A set-up with these parts and the mounted ones, in the order of the parameters, that breaks no
  /// constraint; nullopt if there is none. The values of `liked` are tried first. @throws Stopped
  /// if the scope of this thread (run/control.hpp) requests it.
  [[nodiscard]] std::optional<Block> completed(std::span<const Element> parts,
                                               std::span<const Element> liked);
  /// A set-up that tests these parts together, as near to the liked one as the solver makes it: if
  /// none of them is out of range, no value of it is. nullopt if there is none. @throws Stopped
  [[nodiscard]] std::optional<Block> testing(std::span<const Element> parts,
                                             std::span<const Element> liked);

  [[nodiscard]] const CompiledRules& rules() const { return rules_; }

 private:
  /// The `liked` set-up with these parts, if it breaks no constraint; usually this avoids calling
  /// the solver.
  [[nodiscard]] std::optional<Block> as_liked(std::span<const Element> parts,
                                              std::span<const Element> liked, bool in_range) const;
  /// By what is assumed, with what is preferred.
  [[nodiscard]] std::optional<Block> solve();

  const Job* job_;
  CompiledRules rules_;
  IncrementalSolver solver_;
  Literal in_range_ = 0;  // no value is out of range
  std::vector<Literal> assumed_;
  std::vector<Literal> preferred_;
};

/// cannot_meet() for jobs of a model. Calls the solver at most once per value and once per pair,
/// and not for pairs in set-ups found before. @throws Stopped as ChoiceSolver::completed()
[[nodiscard]] PairSet apart_in_choices(const Job& job);

/// Those of the triples that can be in one set-up; likewise.
[[nodiscard]] std::vector<Triple> together_in_choices(const Job& job,
                                                      const std::vector<Triple>& triples);

/// Why a job with a model is malformed: its parts are not the values of the model, or its slots not
/// the parameters.
[[nodiscard]] std::optional<std::string> model_defect(const Job& job);

/// Why there is no set-up at all, naming the first rule that excludes all; nullopt if there is one.
[[nodiscard]] std::optional<std::string> no_setup_of_model(const Job& job);

/// The part of a set-up whose value is out of range: only its pairs are tested. Nullopt if there is
/// none.
[[nodiscard]] std::optional<Element> out_of_range(const Job& job, std::span<const Element> setup);

/// Whether two or more values of a set-up are out of range. No plan has such a test, but people
/// may have run one.
[[nodiscard]] bool has_two_out_of_range(const Job& job, std::span<const Element> setup);

}  // namespace changeover
