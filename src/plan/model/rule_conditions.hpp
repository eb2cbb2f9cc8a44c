// The rules of a model as conditions without NOT, of tables: which values, or pairs of values, make
// a comparison true.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "changeover/plan/model.hpp"

namespace changeover {

/// Which pairs of values of two parameters make a comparison true: by the first value and the
/// second.
struct RuleTable {
  std::size_t width = 0;
  std::vector<bool> holds;
};

struct RuleCondition {
  enum class What { all, any, one, two, some };
  What what = What::all;
  std::vector<RuleCondition> of = {};
  /// Of one, two and some: those of the table; of a whole rule: all, increasing.
  std::vector<std::size_t> parameters = {};
  /// Of one: which values make it true; of some: which cases do, the last parameter first.
  std::vector<bool> values = {};
  std::shared_ptr<const RuleTable> table = {};  ///< of two
};

/// The parameters that a condition is about, increasing.
[[nodiscard]] std::vector<std::size_t> parameters_of(const RuleCondition& condition);

/// A condition for each rule. @throws BadInput for a rule whose arithmetic has too many cases;
/// Stopped if the scope of this thread wants to stop. O(conditions · values of their parameters).
[[nodiscard]] std::vector<RuleCondition> conditions_of(const Model& model);

}  // namespace changeover
