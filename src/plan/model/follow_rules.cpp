// Checks whether a test follows the original rules of a model. The generator of tests has its own
// form of the rules (compiled_rules.hpp) and shares no code with this, except for reading words of
// a model.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"

namespace changeover {
namespace {

using Relation = ModelRule::Relation;

unsigned char without_case(char c) {
  return static_cast<unsigned char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
}

// The length of the first UTF-8 character.
std::size_t character(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xc0U) == 0x80U) {
    ++length;
  }
  return length;
}

bool same_character(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         (a == b || (a.size() == 1 && without_case(a[0]) == without_case(b[0])));
}

// '*' matches any text, '?' any character. O(text · pattern).
bool matches_pattern(std::string_view text, std::string_view pattern) {
  std::size_t t = 0;
  std::size_t p = 0;
  std::size_t star = std::string_view::npos;
  std::size_t from = 0;
  while (t < text.size()) {
    const std::size_t here = character(text.substr(t));
    const std::size_t wanted = p < pattern.size() ? character(pattern.substr(p)) : 0;
    if (wanted > 0 && pattern[p] == '*') {
      star = p++;
      from = t;
    } else if (wanted > 0 && (pattern[p] == '?' ||
                              same_character(text.substr(t, here), pattern.substr(p, wanted)))) {
      p += wanted;
      t += here;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      from += character(text.substr(from));
      t = from;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', std::min(p, pattern.size())) == std::string_view::npos;
}

int order_of_texts(std::string_view a, std::string_view b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (without_case(a[i]) != without_case(b[i])) {
      return without_case(a[i]) < without_case(b[i]) ? -1 : 1;
    }
  }
  return a.size() == b.size() ? 0 : (a.size() < b.size() ? -1 : 1);
}

bool has_order(Relation relation, int order) {
  switch (relation) {
    case Relation::equal:
      return order == 0;
    case Relation::unequal:
      return order != 0;
    case Relation::less:
      return order < 0;
    case Relation::at_most:
      return order <= 0;
    case Relation::greater:
      return order > 0;
    case Relation::at_least:
      return order >= 0;
  }
  throw InternalError("a relation that is none");
}

class Referee {
 public:
  Referee(const Model& model, const std::vector<const ModelValue*>& values)
      : model_(model), values_(values) {}

  [[nodiscard]] bool holds(const ModelRule& rule) const {
    const auto here = [this](const ModelRule& part) { return holds(part); };
    switch (rule.kind) {
      case ModelRule::Kind::all:
        return std::ranges::all_of(rule.of, here);
      case ModelRule::Kind::any:
        return std::ranges::any_of(rule.of, here);
      case ModelRule::Kind::no:
        return !holds(rule.of.at(0));
      case ModelRule::Kind::negative:
        return rule.terms.empty() ? std::ranges::any_of(values_, &ModelValue::negative)
                                  : values_.at(rule.terms[0].parameter)->negative;
      case ModelRule::Kind::like:
        return matches_pattern(text(rule.terms.at(0)), rule.terms.at(1).text);
      case ModelRule::Kind::in:
        return std::any_of(rule.terms.begin() + 1, rule.terms.end(), [&](const ModelTerm& term) {
          return compared(Relation::equal, rule.terms[0], term);
        });
      case ModelRule::Kind::compare:
        return compared(rule.relation, rule.terms.at(0), rule.terms.at(1));
    }
    throw InternalError("a rule that is none");
  }

 private:
  [[nodiscard]] bool is_text(const ModelTerm& term) const {
    return term.kind == ModelTerm::Kind::text || (term.kind == ModelTerm::Kind::parameter &&
                                                  !model_.parameters.at(term.parameter).numeric);
  }

  // An expression without a value, such as 1/0, has no relation to anything.
  [[nodiscard]] bool compared(Relation relation, const ModelTerm& a, const ModelTerm& b) const {
    if (is_text(a) && is_text(b)) {
      return has_order(relation, order_of_texts(text(a), text(b)));
    }
    if (is_text(a) || is_text(b)) {
      return false;
    }
    const auto left = number(a);
    const auto right = number(b);
    return left && right && has_order(relation, *left < *right ? -1 : (*left > *right ? 1 : 0));
  }

  [[nodiscard]] std::string_view text(const ModelTerm& term) const {
    return term.kind == ModelTerm::Kind::parameter
               ? std::string_view(values_.at(term.parameter)->names.at(0))
               : std::string_view(term.text);
  }

  [[nodiscard]] std::optional<double> number(const ModelTerm& term) const {
    if (term.kind == ModelTerm::Kind::number) {
      return term.number;
    }
    if (term.kind == ModelTerm::Kind::parameter) {
      return values_.at(term.parameter)->number;
    }
    const auto a = number(term.of.at(0));
    const auto b = number(term.of.at(1));
    if (!a || !b) {
      return std::nullopt;
    }
    double value = 0;
    switch (term.kind) {
      case ModelTerm::Kind::sum:
        value = *a + *b;
        break;
      case ModelTerm::Kind::difference:
        value = *a - *b;
        break;
      case ModelTerm::Kind::product:
        value = *a * *b;
        break;
      case ModelTerm::Kind::quotient:  // of whole numbers, rounded to a whole number
        value = *a / *b;
        value = *a == std::trunc(*a) && *b == std::trunc(*b) ? std::trunc(value) : value;
        break;
      default:
        value = std::fmod(*a, *b);
    }
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }

  const Model& model_;
  const std::vector<const ModelValue*>& values_;
};

}  // namespace

std::optional<std::string> broken_rule(const Model& model, const Block& test) {
  std::vector<const ModelValue*> values(model.parameters.size(), nullptr);
  const ModelValue* out_of_range = nullptr;
  for (const Element x : test) {
    if (x >= model.values()) {
      return fmt::format("there is no value {} of {}", std::uint64_t{x} + 1, model.values());
    }
    const std::size_t p = model.parameter_of(x);
    const ModelValue& value = model.parameters[p].values[x - model.parameters[p].first];
    if (values[p] != nullptr) {
      return fmt::format("{} has two values, {} and {}", model.parameters[p].name, values[p]->label,
                         value.label);
    }
    values[p] = &value;
    if (value.negative && out_of_range != nullptr) {
      return fmt::format("{} and {} are out of range both", out_of_range->label, value.label);
    }
    out_of_range = value.negative ? &value : out_of_range;
  }
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (values[p] == nullptr) {
      return fmt::format("{} has no value", model.parameters[p].name);
    }
  }
  const Referee referee(model, values);
  for (const ModelConstraint& constraint : model.constraints) {
    if (!referee.holds(constraint.rule)) {
      return fmt::format("the rule on line {} is broken: {}", constraint.line, constraint.text);
    }
  }
  return std::nullopt;
}

}  // namespace changeover
