// Converts a model to a job.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/printable.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

std::string qualified(const ModelParameter& parameter, const ModelValue& value) {
  return fmt::format("{}: {}", parameter.name, value.label);
}

// Values are named by their labels; if several look the same, by their parameters, too.
std::vector<std::string> part_names(const Model& model) {
  std::map<std::string, std::size_t> uses;
  for (const ModelParameter& parameter : model.parameters) {
    for (const ModelValue& value : parameter.values) {
      ++uses[in_capitals(visible(value.label))];
      ++uses[in_capitals(visible(qualified(parameter, value)))];
    }
  }
  std::vector<std::string> names;
  for (const ModelParameter& parameter : model.parameters) {
    for (const ModelValue& value : parameter.values) {
      const bool is_alone = uses[in_capitals(visible(value.label))] == 1;
      names.push_back(is_alone ? value.label : qualified(parameter, value));
    }
  }
  return names;
}

}  // namespace

Job job_of(Model model, Amount test_cost, Amount change_cost) {
  if (model.parameters.size() < 2) {
    throw BadInput("a model needs at least two parameters; add one");
  }
  Job job = make_job(model.values(), model.parameters.size(), test_cost, change_cost);
  job.names = part_names(model);
  job.needed = PairSet(job.parts());
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    const ModelParameter& parameter = model.parameters[p];
    job.slots.push_back({.name = parameter.name, .least = 1, .most = 1});
    job.slot_of.insert(job.slot_of.end(), parameter.values.size(), static_cast<std::uint32_t>(p));
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      const auto x = static_cast<Element>(parameter.first + i);
      for (Element y = 0; y < parameter.first; ++y) {
        if (!parameter.values[i].negative || !model.value(y).negative) {
          job.needed.insert(x, y);
        }
      }
    }
  }
  job.model = std::make_shared<const Model>(std::move(model));
  return job;
}

void check_relations(const Model& model, std::uint64_t strength) {
  for (const ModelRelation& relation : model.relations) {
    const std::uint64_t asked = relation.strength.value_or(strength);
    if (asked == strength && relation.parameters.size() == model.parameters.size()) {
      continue;
    }
    const bool one = relation.parameters.size() == 1;
    if (asked == strength && one) {
      continue;
    }
    throw BadInput(
        one ? fmt::format("{}: {} asks for the strength {}; write that of the whole, which is {}",
                          relation.place, model.parameters[relation.parameters.front()].name, asked,
                          strength)
            : fmt::format(
                  "{}: sub-models are not supported; leave it out, or list all parameters with "
                  "the strength of the whole, which is {}",
                  relation.place, strength));
  }
}

}  // namespace changeover
