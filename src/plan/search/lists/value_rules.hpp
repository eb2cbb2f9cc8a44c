// What the rules of a model ask of the set-ups of a bench.
//
// Set-ups have one value of each parameter, in the order of the parameters, which is that of the
// numbers of their values.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "changeover/plan/job.hpp"
#include "plan/job/choices.hpp"
#include "plan/model/compiled_rules.hpp"

namespace changeover {

class ValueRules {
 public:
  /// For a job of a model; without one, everything is allowed. The job must outlive this. `rules`
  /// are those of its model.
  ValueRules(const Job& job, std::shared_ptr<const CompiledRules> rules);

  [[nodiscard]] bool of_model() const { return rules_ != nullptr; }
  /// Whether a set-up that breaks no rule may have `in` in place of the value of its parameter.
  /// O(parameters + rules on it).
  [[nodiscard]] bool may_have(std::span<const Element> setup, Element in) const;
  /// Whether the bench has all values of a set-up.
  [[nodiscard]] bool has_all(std::span<const Element> setup) const;
  /// A set-up that tests these values together and is like `beside` otherwise, if that is easy;
  /// nullopt if there is none. @throws Stopped if the scope of this thread (run/control.hpp)
  /// requests it.
  [[nodiscard]] std::optional<Block> around(std::span<const Element> beside,
                                            std::span<const Element> target) const;

 private:
  const Job* job_;
  std::shared_ptr<const CompiledRules> rules_;
  std::vector<bool> lacks_;                       // by value
  mutable std::unique_ptr<ChoiceSolver> solver_;  // made when it is needed
};

}  // namespace changeover
