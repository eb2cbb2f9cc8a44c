// The values of parameters on the sheet of a model.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/model.hpp"
#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The values of a sheet by step and parameter, as written there: a value with several names uses
/// the next one each time it is set, and keeps it while it stays.
class ShownValues {
 public:
  /// Needs a job with a model, which must outlive this.
  ShownValues(const Job& job, const RunSheet& sheet);

  [[nodiscard]] const std::string& value(std::size_t step, std::size_t parameter) const {
    return shown_[step * parameters_ + parameter];
  }
  /// "OS: Debian" for each parameter that is set in a step.
  [[nodiscard]] std::vector<std::string> set_in(std::size_t step) const;
  /// Whether a step sets a parameter.
  [[nodiscard]] bool is_set(std::size_t step, std::size_t parameter) const {
    return set_[step * parameters_ + parameter];
  }

 private:
  const Model* model_;
  std::size_t parameters_;
  std::vector<std::string> shown_;
  std::vector<bool> set_;
};

/// The heading of the column of a parameter: its name, or "slot_3 step" if another column has that
/// name.
[[nodiscard]] std::string value_head(const Model& model, std::size_t parameter);

/// The name of a value for its `turn`-th use, from 0.
[[nodiscard]] std::string name_of_value(const ModelValue& value, std::size_t turn);

}  // namespace changeover
