// What the tests of a model say on a sheet: a value for each parameter.
#pragma once

#include <string>
#include <vector>

#include "changeover/plan/model.hpp"
#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The values of a sheet by step and parameter, as they are written there: a value with several
/// names has another of them each time that it is set, and keeps it while it stays.
class ShownValues {
 public:
  /// For a job with a model, which must outlive this.
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

/// What heads the column of a parameter: its name, or "slot_3 step" if another column is called so.
[[nodiscard]] std::string value_head(const Model& model, std::size_t parameter);

/// A value under one of its names, the first one for 0.
[[nodiscard]] std::string name_of_value(const ModelValue& value, std::size_t turn);

}  // namespace changeover
