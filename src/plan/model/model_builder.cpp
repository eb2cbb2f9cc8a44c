#include "plan/model/model_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "plan/model/model_names.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_model_name = 255;
constexpr std::size_t most_notes = 10;

// Two labels that look alike count as the same.
std::string look_of(std::string_view label) { return in_capitals(visible(label)); }

}  // namespace

ModelText::ModelText(std::string text, std::string name)
    : text_(std::move(text)), name_(std::move(name)) {
  if (without_byte_order_mark(text_).size() < text_.size()) {
    text_ = std::string(without_byte_order_mark(text_));
  }
  for (std::size_t at = 0; at < text_.size();) {
    const std::size_t end = std::min(text_.find('\n', at), text_.size());
    std::string_view line = std::string_view(text_).substr(at, end - at);
    line.remove_suffix(line.ends_with('\r') ? 1U : 0U);
    if (const auto defect = first_defect(line, true)) {
      refuse(at + defect->offset, defect->what);
    }
    at = end + 1;
  }
}

std::uint64_t ModelText::line(std::size_t offset) {
  if (offset < counted_) {
    return place_of(text_, offset).line;
  }
  line_ += static_cast<std::uint64_t>(
      std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                 text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
  counted_ = offset;
  return line_;
}

std::string ModelText::place(std::size_t offset) const {
  const Place place = place_of(text_, offset);
  return fmt::format("{}:{}:{}", name_, place.line, place.column);
}

void ModelText::refuse(std::size_t offset, std::string_view what) const {
  fail(name_, place_of(text_, offset), what);
}

std::optional<std::size_t> ModelBuilder::find(std::string_view name) const {
  const auto found = by_name_.find(in_capitals(name));
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

std::size_t ModelBuilder::parameter(std::string_view name, std::size_t at) const {
  const auto found = find(name);
  if (!found) {
    text_.refuse(at, no_parameter(name, model_));
  }
  return *found;
}

void ModelBuilder::check_text(std::string_view what, std::string_view text, std::size_t at) const {
  if (text.size() > longest_model_name) {
    text_.refuse(at, fmt::format("a name of more than {} bytes; shorten it", longest_model_name));
  }
  if (const auto defect = text_defect(text)) {
    text_.refuse(at, fmt::format("the {} {}: {}", what, shown(text), *defect));
  }
}

void ModelBuilder::add_parameter(std::string_view name, std::size_t at, bool of_texts) {
  if (name.empty()) {
    text_.refuse(at, "a parameter has no name; write one before its values");
  }
  check_text("name", name, at);
  if (!by_name_.emplace(in_capitals(name), size()).second) {
    text_.refuse(at, fmt::format("a second parameter is called {}; rename one", shown(name)));
  }
  model_.parameters.push_back({.name = std::string(name), .values = {}});
  model_.parameters.back().first = static_cast<Element>(values_);
  of_texts_.push_back(of_texts);
}

void ModelBuilder::add_value(std::vector<std::string> names, bool negative, std::size_t at) {
  ModelParameter& parameter = model_.parameters.back();
  if (++values_ > max_parts) {
    text_.refuse(at,
                 fmt::format("more than {} values in all; plan for fewer at a time", max_parts));
  }
  for (const std::string& name : names) {
    check_text("value", name, at);
    if (name.empty() && names.size() > 1) {
      text_.refuse(at,
                   fmt::format("a value of {} has an empty name beside |; write one on each side",
                               shown(parameter.name)));
    }
  }
  parameter.values.push_back({.names = std::move(names), .negative = negative});
}

void ModelBuilder::add_values_of(std::size_t parameter, std::size_t at) {
  const std::vector<ModelValue> values = model_.parameters[parameter].values;
  for (const ModelValue& value : values) {
    add_value(value.names, value.negative, at);
  }
}

void ModelBuilder::add_relation(ModelRelation relation) {
  std::vector<std::size_t>& parameters = relation.parameters;
  std::ranges::sort(parameters);
  parameters.erase(std::ranges::unique(parameters).begin(), parameters.end());
  model_.relations.push_back(std::move(relation));
}

void ModelBuilder::finish_parameters() {
  if (size() < 2) {
    text_.refuse(0, size() == 0
                        ? "no parameter is listed; write one per line, as in OS: Debian, Windows"
                        : "there is only one parameter; add another, so that values can meet");
  }
  for (std::size_t p = 0; p < size(); ++p) {
    ModelParameter& parameter = model_.parameters[p];
    std::unordered_set<std::string> looks;
    bool any_in_range = false;
    parameter.numeric = !of_texts_[p];
    for (ModelValue& value : parameter.values) {
      value.number = number_in(value.names.front());
      parameter.numeric = parameter.numeric && value.number;
      any_in_range = any_in_range || !value.negative;
      const std::string name =
          fmt::format("{}{}", value.negative ? "~" : "",
                      value.names.front().empty() ? "(empty)" : value.names.front());
      value.label = name;
      for (std::size_t i = 2; !looks.insert(look_of(value.label)).second; ++i) {
        value.label = fmt::format("{} ({})", name, i);
      }
      if (value.label != name) {
        note(fmt::format("{} has values that rules cannot tell apart: {} and {}", parameter.name,
                         name, value.label));
      }
    }
    if (!any_in_range) {
      text_.refuse(0, fmt::format("all values of {} are out of range; give one that is not",
                                  shown(parameter.name)));
    }
  }
}

void ModelBuilder::add_constraint(ModelRule rule, std::size_t begin, std::size_t end) {
  constexpr std::size_t longest = 100;
  const std::string_view written = text_.text().substr(begin, end - begin);
  std::string line;
  for (std::size_t i = 0; i < written.size() && line.size() <= longest; ++i) {
    const bool blank = std::string_view(" \t\r\n").find(written[i]) != std::string_view::npos;
    if (!blank) {
      line += written[i];
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  if (line.size() > longest) {
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(line[cut]) & 0xc0U) == 0x80U) {
      --cut;
    }
    line = line.substr(0, cut) + "…";
  }
  model_.constraints.push_back(
      {.rule = std::move(rule), .line = text_.line(begin), .text = std::move(line)});
}

void ModelBuilder::count_condition(std::size_t at, std::size_t conditions) {
  conditions_ += conditions;
  if (conditions_ > max_model_conditions) {
    text_.refuse(at,
                 fmt::format("more than {} conditions in all rules together; plan for a part of "
                             "the model",
                             max_model_conditions));
  }
}

void ModelBuilder::note(std::size_t at, const std::string& what) {
  if (model_.notes.size() < most_notes) {
    model_.notes.push_back(fmt::format("{}: {}", text_.place(at), what));
  } else {
    ++more_notes_;
  }
}

Model ModelBuilder::take() {
  if (more_notes_ > 0) {
    model_.notes.push_back(
        fmt::format("{}: {} like these", model_.name, count_of(more_notes_, "more note")));
  }
  return std::move(model_);
}

ModelRule joined_rule(ModelRule::Kind kind, ModelRule a, ModelRule b) {
  ModelRule all{.kind = kind};
  if (a.kind == kind) {
    all = std::move(a);
  } else {
    all.of.push_back(std::move(a));
  }
  if (b.kind == kind) {
    for (ModelRule& part : b.of) {
      all.of.push_back(std::move(part));
    }
  } else {
    all.of.push_back(std::move(b));
  }
  return all;
}

ModelRule negated_rule(ModelRule rule) {
  ModelRule negation{.kind = ModelRule::Kind::no};
  negation.of.push_back(std::move(rule));
  return negation;
}

std::size_t Model::values() const {
  return parameters.empty() ? 0 : parameters.back().first + parameters.back().values.size();
}

std::size_t Model::parameter_of(Element value) const {
  const auto after = std::ranges::upper_bound(parameters, value, {}, &ModelParameter::first);
  return static_cast<std::size_t>(after - parameters.begin()) - 1;
}

const ModelValue& Model::value(Element value) const {
  const ModelParameter& parameter = parameters[parameter_of(value)];
  return parameter.values[value - parameter.first];
}

}  // namespace changeover
