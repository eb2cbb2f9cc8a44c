// The rules of a model as those who make tests need them: which value may come into a test, and as
// a formula. What comes of it is judged by follow_rules.cpp, which reads the rules as they stand.
//
// Conditions of one or two parameters become values and pairs that are out; the others are looked
// at one by one.
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
  /// A value that is in no test.
  [[nodiscard]] bool banned(Element x) const { return banned_[x]; }
  /// Two values of different parameters that one rule, or that both are out of range, keeps apart.
  [[nodiscard]] bool apart(Element x, Element y) const { return apart_[x * values() + y]; }
  [[nodiscard]] bool any_apart() const { return any_apart_; }
  /// Whether a row, one value a parameter, that has x as its value of a parameter follows the rules
  /// of three parameters and more with this one.
  [[nodiscard]] bool allows(std::span<const Element> row, std::size_t parameter, Element x) const;

  /// One value of each parameter, and the rules. The formula has no variables yet, and has those of
  /// the values first.
  /// @throws MissingResource if it grows beyond all measure.
  void add_to(Cnf& cnf) const;

 private:
  [[nodiscard]] bool holds(const RuleCondition& condition, std::span<const Element> row) const;
  void forbid_cases(const RuleCondition& condition);
  void literals_of(const RuleCondition& condition, Cnf& cnf, std::vector<Literal>& clause) const;
  void add_cases(const RuleCondition& condition, Literal unless, Cnf& cnf) const;

  std::vector<Element> first_;  // by parameter, and one more
  std::vector<bool> banned_;    // by value
  std::vector<bool> apart_;     // by two values
  bool any_apart_ = false;
  std::vector<RuleCondition> conditions_;         // of three parameters and more
  std::vector<std::vector<std::uint32_t>> with_;  // by parameter: those of them that have it
};

}  // namespace changeover
