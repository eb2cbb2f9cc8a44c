// The rules of a model for generating tests: which value may be in a test, and the rules as a
// formula. The tests are judged by follow_rules.cpp, which evaluates the original rules.
//
// Conditions on one or two parameters are converted to excluded values and pairs; the others are
// evaluated one by one.
//
//     const CompiledRules rules(model);
//     rules.apart(x, y);              // no test has both, by a rule of two parameters
//     rules.allows(row, 3, x);        // the larger rules allow x in this row, for parameter 3
//     rules.add_to(cnf);              // variables 1, 2, … are the values
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/plan/model.hpp"
#include "plan/model/rule_conditions.hpp"
#include "search/sat/cnf.hpp"

namespace changeover {

class CompiledRules {
 public:
  /// The model need not outlive this. @throws as conditions_of().
  explicit CompiledRules(const Model& model);

  [[nodiscard]] std::size_t values() const { return banned_.size(); }
  /// Whether the value is in no test.
  [[nodiscard]] bool banned(Element x) const { return banned_[x]; }
  /// Whether a rule, or being out of range both, excludes two values of different parameters.
  [[nodiscard]] bool apart(Element x, Element y) const { return apart_[x * values() + y]; }
  [[nodiscard]] bool any_apart() const { return any_apart_; }
  /// Whether a row, one value per parameter, with x as its value of `parameter`, follows the rules
  /// on this parameter and at least two others.
  [[nodiscard]] bool allows(std::span<const Element> row, std::size_t parameter, Element x) const;

  /// Adds "one value of each parameter" and the rules. The formula must be empty; its first
  /// variables become the values. @throws MissingResource if it becomes too large.
  void add_to(Cnf& cnf) const;

 private:
  [[nodiscard]] bool holds(const RuleCondition& condition, std::span<const Element> row) const;
  void forbid_cases(const RuleCondition& condition);
  void literals_of(const RuleCondition& condition, Cnf& cnf, std::vector<Literal>& clause) const;
  void add_cases(const RuleCondition& condition, Literal unless, Cnf& cnf) const;

  std::vector<Element> first_;  // by parameter, and the end
  std::vector<bool> banned_;    // by value
  std::vector<bool> apart_;     // by pair of values
  bool any_apart_ = false;
  std::vector<RuleCondition> conditions_;         // on three parameters or more
  std::vector<std::vector<std::uint32_t>> with_;  // by parameter: those of them that contain it
};

}  // namespace changeover
