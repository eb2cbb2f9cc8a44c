#include "plan/search/lists/value_rules.hpp"

#include <algorithm>
#include <utility>

namespace changeover {

ValueRules::ValueRules(const Job& job, std::shared_ptr<const CompiledRules> rules)
    : job_(&job), rules_(std::move(rules)), lacks_(job.names.size(), false) {
  for (Element x = 0; x < lacks_.size() && of_model(); ++x) {
    lacks_[x] = rules_->banned(x);
  }
  for (const Element x : job.barred) {
    lacks_[x] = true;
  }
}

bool ValueRules::may_have(std::span<const Element> setup, Element in) const {
  const std::size_t parameter = job_->slot_of[in];
  if (lacks_[in]) {
    return false;
  }
  if (rules_->any_apart()) {
    for (std::size_t p = 0; p < setup.size(); ++p) {
      if (p != parameter && rules_->apart(setup[p], in)) {
        return false;
      }
    }
  }
  return rules_->allows(setup, parameter, in);
}

bool ValueRules::has_all(std::span<const Element> setup) const {
  return std::ranges::none_of(setup, [&](Element x) { return lacks_[x]; });
}

std::optional<Block> ValueRules::around(std::span<const Element> beside,
                                        std::span<const Element> target) const {
  if (!has_all(target)) {
    return std::nullopt;
  }
  if (!solver_) {
    solver_ = std::make_unique<ChoiceSolver>(*job_);
  }
  return solver_->testing(target, beside);
}

}  // namespace changeover
