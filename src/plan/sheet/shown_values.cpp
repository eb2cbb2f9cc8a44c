#include "plan/sheet/shown_values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plan/job/setups/setup_columns.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {

std::string name_of_value(const ModelValue& value, std::size_t turn) {
  if (value.names.size() == 1) {
    return value.label;
  }
  return (value.negative ? "~" : "") + value.names[turn % value.names.size()];
}

ShownValues::ShownValues(const Job& job, const RunSheet& sheet)
    : model_(job.model.get()), parameters_(job.model->parameters.size()) {
  std::vector<std::size_t> turns(job.names.size(), 0);
  std::vector<std::string> before(parameters_);
  for (const Element x : job.start) {
    before[job.slot_of[x]] = name_of_value(model_->value(x), 0);
    turns[x] = 1;
  }
  for (const RunStep& step : sheet.steps) {
    std::vector<bool> set(parameters_, false);
    for (const Element x : step.put_in) {
      before[job.slot_of[x]] = name_of_value(model_->value(x), turns[x]++);
      set[job.slot_of[x]] = true;
    }
    shown_.insert(shown_.end(), before.begin(), before.end());
    set_.insert(set_.end(), set.begin(), set.end());
  }
}

std::vector<std::string> ShownValues::set_in(std::size_t step) const {
  std::vector<std::string> words;
  for (std::size_t p = 0; p < parameters_; ++p) {
    if (is_set(step, p)) {
      words.push_back(fmt::format("{}: {}", model_->parameters[p].name, value(step, p)));
    }
  }
  return words;
}

std::string value_head(const Model& model, std::size_t parameter) {
  const std::string& name = model.parameters[parameter].name;
  const bool taken = name.starts_with("slot_") || is_head_beside_values(name);
  return taken ? fmt::format("slot_{} {}", parameter + 1, name) : name;
}

}  // namespace changeover
