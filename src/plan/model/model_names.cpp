#include "plan/model/model_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/spelling.hpp"
#include "core/words.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {

ModelNames::ModelNames(const Model& model) : model_(&model), values_(model.parameters.size()) {
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    const ModelParameter& parameter = model.parameters[p];
    parameters_.emplace(in_capitals(parameter.name), p);
    // Labels first, since they identify values.
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      values_[p].emplace(in_capitals(parameter.values[i].label),
                         parameter.first + static_cast<Element>(i));
    }
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      for (const std::string& name : parameter.values[i].names) {
        values_[p].emplace(in_capitals(name), parameter.first + static_cast<Element>(i));
      }
    }
  }
}

std::optional<std::size_t> ModelNames::parameter(std::string_view name) const {
  const auto found = parameters_.find(in_capitals(trimmed(name)));
  return found == parameters_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Element> ModelNames::value(std::size_t parameter, std::string_view name) const {
  const auto& values = values_[parameter];
  const std::string_view plain = trimmed(name);
  auto found = values.find(in_capitals(plain));
  if (found == values.end() && plain.starts_with('~')) {
    found = values.find(in_capitals(trimmed(plain.substr(1))));
  }
  if (found != values.end()) {
    return found->second;
  }
  const std::string_view rest = without_parameter(parameter, plain);
  return rest.size() < plain.size() ? value(parameter, rest) : std::nullopt;
}

std::string_view ModelNames::without_parameter(std::size_t parameter, std::string_view name) const {
  for (std::size_t at = name.find_first_of(":="); at != std::string_view::npos;
       at = name.find_first_of(":=", at + 1)) {
    if (this->parameter(name.substr(0, at)) == parameter) {
      return trimmed(name.substr(at + 1));
    }
  }
  return name;
}

std::optional<Element> ModelNames::part(std::string_view word) const {
  for (std::size_t at = word.find_first_of(":="); at != std::string_view::npos;
       at = word.find_first_of(":=", at + 1)) {
    if (const auto p = parameter(word.substr(0, at))) {
      if (const auto found = value(*p, word.substr(at + 1))) {
        return found;
      }
    }
  }
  std::optional<Element> only;
  for (std::size_t p = 0; p < values_.size(); ++p) {
    if (const auto found = value(p, word)) {
      if (only) {
        return std::nullopt;
      }
      only = found;
    }
  }
  return only;
}

std::string ModelNames::complaint(std::string_view word) const {
  std::vector<std::string> places;
  for (std::size_t p = 0; p < values_.size(); ++p) {
    if (value(p, word)) {
      places.push_back(model_->parameters[p].name);
    }
  }
  if (places.size() > 1) {
    return fmt::format("{} is a value of {}; write {}: {}", shown(word),
                       fmt::join(places, " and of "), places.front(), trimmed(word));
  }
  const std::size_t at = word.find_first_of(":=");
  if (at != std::string_view::npos) {
    if (const auto p = parameter(word.substr(0, at))) {
      return fmt::format("{} has no value {}; write it as the model does",
                         model_->parameters[*p].name, shown(trimmed(word.substr(at + 1))));
    }
  }
  return fmt::format(
      "no parameter has the value {}; write it as the model does, or as Parameter: value",
      shown(word));
}

std::optional<std::string> parameter_meant(std::string_view name,
                                           const std::vector<std::string>& parameters) {
  const auto small = each_of<std::string>(parameters, lower_case);
  const auto nearest = nearest_word(lower_case(name), small);
  return nearest ? std::optional(parameters[static_cast<std::size_t>(
                       std::ranges::find(small, *nearest) - small.begin())])
                 : std::nullopt;
}

std::string no_parameter(std::string_view name, const Model& model) {
  const auto meant =
      parameter_meant(name, each_of<std::string>(model.parameters, &ModelParameter::name));
  return fmt::format(
      "no parameter is called {}; {}", shown(name),
      meant ? fmt::format("did you mean {}?", shown(*meant)) : "write it as the model does");
}

}  // namespace changeover
