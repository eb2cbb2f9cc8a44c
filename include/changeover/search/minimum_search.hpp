// The least number of blocks: every smaller one excluded by a proof, and a design.
//
//     RunControl control({.time = std::chrono::minutes(5)});
//     MinimumResult result = find_minimum({.v = 12, .k = 4}, {}, control);
//     result.settled();                     // true
//     result.lower;  result.upper();         // 14, 14: bounds on paper give 13, which a checked proof excludes
//
// The walk starts from the largest bound that is a proof on paper (bounds/lower_bound.hpp; minima known
// by exhaustive search are not used: they are what is settled here), and goes up one block at a time. It ends at
// the first design, at the upper bound that is given, or when the control stops it: then an interval is left.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/search/exact.hpp"

namespace changeover {

struct MinimumOptions {
  ExactOptions exact = {};
  /// If the limit of a step is reached (ExactOptions) and the walk must end: how many greater numbers of blocks
  /// are tried, without proof, for a better upper bound.
  std::uint64_t tries_above = 0;
  /// Who decides about a number of blocks, if not decide(): several processes that share each question, say.
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
  /// A MissingResource that ended the walk before its time, if something is known all the same: `best`, or steps.
  /// Show what is known, then throw it on.
  std::exception_ptr fault = {};
  std::chrono::duration<double> time{};

  /// The number of blocks of `best`.
  [[nodiscard]] std::optional<std::uint64_t> upper() const;
  /// `best` has `lower` blocks.
  [[nodiscard]] bool settled() const { return upper() == lower; }
};

/// The largest bound that is a proof on paper. @throws as lower_bounds().
[[nodiscard]] Bound lower_bound_on_paper(const Parameters& p);

/// Walks up to the minimum. `known` is a design with these parameters, from a construction say; it is verified.
/// What is stopped while `known` is verified or bounds are looked for goes on without: one block is a bound.
/// @throws as decide() if nothing is known by then, and BadInput if `known` is not a design with these
/// parameters. Bound by: decide().
[[nodiscard]] MinimumResult find_minimum(const Parameters& p, const MinimumOptions& options,
                                         RunControl& control,
                                         const std::optional<Design>& known = std::nullopt);

}  // namespace changeover
