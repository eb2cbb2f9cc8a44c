// Converts the rules of a model to conditions without NOT, made of tables: the values, or pairs of
// values, that make a comparison true.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "changeover/plan/model.hpp"

namespace changeover {

/// The pairs of values of two parameters that make a comparison true: by the first value, then by
/// the second.
struct RuleTable {
  std::size_t width = 0;
  std::vector<bool> holds;
};

struct RuleCondition {
  enum class What { all, any, one, two, some };
  What what = What::all;
  std::vector<RuleCondition> of = {};
  /// For kinds one, two and some: the parameters of the table; for a whole rule: all, increasing.
  std::vector<std::size_t> parameters = {};
  /// For kind one: the values that make it true; for some: the cases that do, with the last
  /// parameter varying first.
  std::vector<bool> values = {};
  std::shared_ptr<const RuleTable> table = {};  ///< for kind two
};

/// The parameters of a condition, increasing.
[[nodiscard]] std::vector<std::size_t> parameters_of(const RuleCondition& condition);

/// A condition for each rule. @throws BadInput for a rule whose arithmetic has too many cases;
/// Stopped if the scope of this thread requests it. O(conditions · values of their parameters).
[[nodiscard]] std::vector<RuleCondition> conditions_of(const Model& model);

}  // namespace changeover
