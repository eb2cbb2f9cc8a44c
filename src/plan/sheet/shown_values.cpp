#include "plan/sheet/shown_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

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
  constexpr std::array<std::string_view, 11> of_a_sheet{
      "step", "set",         "take_out", "put_in", "new_pairs", "new_triples",
      "cost", "cost_so_far", "result",   "notes",  "bench"};
  const std::string& name = model.parameters[parameter].name;
  const bool taken =
      name.starts_with("slot_") ||
      std::ranges::any_of(of_a_sheet, [&](std::string_view head) { return same_word(head, name); });
  return taken ? fmt::format("slot_{} {}", parameter + 1, name) : name;
}

}  // namespace changeover
