#include "plan/model/rule_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_cases = 2'000'000;  // for arithmetic

bool is_like(const char* text, const char* pattern) {
  const auto rest = [](const char* at) {
    do {
      ++at;
    } while ((static_cast<unsigned char>(*at) & 0xc0U) == 0x80U);
    return at;
  };
  // The last star, and the text that it matches next.
  const char* star = nullptr;
  const char* taken = nullptr;
  while (*text != '\0') {
    if (*pattern == '*') {
      star = pattern++;
      taken = text;
    } else if (*pattern == '?') {
      text = rest(text);
      ++pattern;
    } else if (*pattern == *text) {
      ++text;
      ++pattern;
    } else if (star != nullptr) {
      taken = rest(taken);
      text = taken;
      pattern = star + 1;
    } else {
      return false;
    }
  }
  while (*pattern == '*') {
    ++pattern;
  }
  return *pattern == '\0';
}

template <typename T>
bool in_relation(ModelRule::Relation relation, const T& a, const T& b) {
  switch (relation) {
    case ModelRule::Relation::equal:
      return a == b;
    case ModelRule::Relation::unequal:
      return !(a == b);
    case ModelRule::Relation::less:
      return a < b;
    case ModelRule::Relation::at_most:
      return !(b < a);
    case ModelRule::Relation::greater:
      return b < a;
    case ModelRule::Relation::at_least:
      return !(a < b);
  }
  throw InternalError("a relation that is none");
}

class RuleCompiler {
 public:
  using Kind = ModelRule::Kind;
  using What = RuleCondition::What;
  using Condition = RuleCondition;

  explicit RuleCompiler(const Model& model) : model_(model) {
    for (const ModelParameter& parameter : model.parameters) {
      for (const ModelValue& value : parameter.values) {
        names_.push_back(in_capitals(value.names.front()));
      }
    }
  }

  // NOT is moved down to the comparisons.
  Condition compiled(const ModelConstraint& constraint) {
    line_ = constraint.line;
    return simpler(condition(constraint.rule, false));
  }

 private:
  Condition condition(const ModelRule& rule, bool negated) {
    stop_if_asked();
    switch (rule.kind) {
      case Kind::no:
        return condition(rule.of.at(0), !negated);
      case Kind::all:
      case Kind::any: {
        Condition joined{.what = (rule.kind == Kind::all) != negated ? What::all : What::any};
        for (const ModelRule& part : rule.of) {
          joined.of.push_back(condition(part, negated));
        }
        return joined;
      }
      case Kind::negative: {
        if (!rule.terms.empty()) {
          return of_one(rule.terms[0].parameter, negated,
                        [](const ModelValue& value, const std::string&) { return value.negative; });
        }
        Condition joined{.what = negated ? What::all : What::any};
        for (std::size_t p = 0; p < model_.parameters.size(); ++p) {
          joined.of.push_back(of_one(p, negated, [](const ModelValue& value, const std::string&) {
            return value.negative;
          }));
        }
        return joined;
      }
      case Kind::like: {
        const std::string pattern = in_capitals(rule.terms.at(1).text);
        return of_one(rule.terms[0].parameter, negated,
                      [&](const ModelValue&, const std::string& name) {
                        return is_like(name.c_str(), pattern.c_str());
                      });
      }
      case Kind::in: {
        Condition joined{.what = negated ? What::all : What::any};
        for (std::size_t i = 1; i < rule.terms.size(); ++i) {
          joined.of.push_back(
              comparison(ModelRule::Relation::equal, rule.terms[0], rule.terms[i], negated));
        }
        return joined;
      }
      case Kind::compare:
        return comparison(rule.relation, rule.terms.at(0), rule.terms.at(1), negated);
    }
    throw InternalError("a rule that is none");
  }

  template <typename Holds>
  Condition of_one(std::size_t parameter, bool negated, Holds&& holds) {
    const ModelParameter& of = model_.parameters.at(parameter);
    Condition one{.what = What::one, .parameters = {parameter}};
    for (std::size_t i = 0; i < of.values.size(); ++i) {
      one.values.push_back(holds(of.values[i], names_[of.first + i]) != negated);
    }
    return one;
  }

  [[nodiscard]] bool is_plain(const ModelTerm& term) const {
    return term.kind == ModelTerm::Kind::text || term.kind == ModelTerm::Kind::number ||
           term.kind == ModelTerm::Kind::parameter;
  }
  [[nodiscard]] bool is_words(const ModelTerm& term) const {
    return term.kind == ModelTerm::Kind::text || (term.kind == ModelTerm::Kind::parameter &&
                                                  !model_.parameters.at(term.parameter).numeric);
  }

  Condition comparison(ModelRule::Relation relation, const ModelTerm& a, const ModelTerm& b,
                       bool negated) {
    if (is_words(a) != is_words(b)) {  // a number and a text: no relation holds
      return {.what = negated ? What::all : What::any};
    }
    const bool left = a.kind == ModelTerm::Kind::parameter;
    const bool right = b.kind == ModelTerm::Kind::parameter;
    if (!is_plain(a) || !is_plain(b) || (!left && !right)) {
      return of_cases(relation, a, b, negated);
    }
    if (left && right) {
      return of_two(relation, a.parameter, b.parameter, negated);
    }
    const ModelTerm& constant = left ? b : a;
    const std::string text = in_capitals(constant.text);
    return of_one(left ? a.parameter : b.parameter, negated,
                  [&](const ModelValue& value, const std::string& name) {
                    if (is_words(a)) {
                      return left ? in_relation(relation, name, text)
                                  : in_relation(relation, text, name);
                    }
                    return left ? in_relation(relation, *value.number, constant.number)
                                : in_relation(relation, constant.number, *value.number);
                  });
  }

  Condition of_two(ModelRule::Relation relation, std::size_t p, std::size_t q, bool negated) {
    if (p == q) {
      return of_one(p, negated, [&](const ModelValue&, const std::string& name) {
        return in_relation(relation, name, name);
      });
    }
    auto& table = tables_[{p, q, relation, negated}];
    const ModelParameter& first = model_.parameters[p];
    const ModelParameter& second = model_.parameters[q];
    if (!table) {
      RuleTable made{.width = second.values.size(), .holds = {}};
      for (std::size_t i = 0; i < first.values.size(); ++i) {
        stop_if_asked();
        for (std::size_t j = 0; j < second.values.size(); ++j) {
          const bool holds =
              first.numeric
                  ? in_relation(relation, *first.values[i].number, *second.values[j].number)
                  : in_relation(relation, names_[first.first + i], names_[second.first + j]);
          made.holds.push_back(holds != negated);
        }
      }
      table = std::make_shared<const RuleTable>(std::move(made));
    }
    return {.what = What::two, .parameters = {p, q}, .table = table};
  }

  static void collect(const ModelTerm& term, std::vector<std::size_t>& parameters) {
    if (term.kind == ModelTerm::Kind::parameter) {
      parameters.push_back(term.parameter);
    }
    for (const ModelTerm& part : term.of) {
      collect(part, parameters);
    }
  }

  // Arithmetic: evaluates all cases.
  Condition of_cases(ModelRule::Relation relation, const ModelTerm& a, const ModelTerm& b,
                     bool negated) {
    Condition some{.what = What::some};
    collect(a, some.parameters);
    collect(b, some.parameters);
    std::ranges::sort(some.parameters);
    const auto repeated = std::ranges::unique(some.parameters);
    some.parameters.erase(repeated.begin(), repeated.end());
    std::size_t cases = 1;
    for (const std::size_t p : some.parameters) {
      cases *= model_.parameters[p].values.size();
      if (cases > most_cases - cases_) {
        throw BadInput(fmt::format(
            "{}:{}: the arithmetic of the rules has more than {} cases; write this rule with "
            "fewer parameters",
            model_.name, line_, most_cases));
      }
    }
    cases_ += cases;
    std::vector<double> number(model_.parameters.size(), 0);
    for (std::size_t i = 0; i < cases; ++i) {
      std::size_t rest = i;
      for (std::size_t k = some.parameters.size(); k-- > 0;) {
        const std::vector<ModelValue>& values = model_.parameters[some.parameters[k]].values;
        number[some.parameters[k]] = values[rest % values.size()].number.value_or(0);
        rest /= values.size();
      }
      bool holds = false;
      if (is_words(a)) {
        holds = in_relation(relation, in_capitals(a.text), in_capitals(b.text));
      } else {
        const double left = computed(a, number);
        const double right = computed(b, number);
        holds = std::isfinite(left) && std::isfinite(right) && in_relation(relation, left, right);
      }
      some.values.push_back(holds != negated);
    }
    if (some.parameters.empty()) {
      return {.what = some.values.front() ? What::all : What::any};
    }
    return some;
  }

  // NaN where there is no number.
  static double computed(const ModelTerm& term, const std::vector<double>& number) {
    if (term.kind == ModelTerm::Kind::number) {
      return term.number;
    }
    if (term.kind == ModelTerm::Kind::parameter) {
      return number[term.parameter];
    }
    const double a = computed(term.of.at(0), number);
    const double b = computed(term.of.at(1), number);
    switch (term.kind) {
      case ModelTerm::Kind::sum:
        return a + b;
      case ModelTerm::Kind::difference:
        return a - b;
      case ModelTerm::Kind::product:
        return a * b;
      case ModelTerm::Kind::quotient:
        return std::floor(a) == a && std::floor(b) == b ? std::trunc(a / b) : a / b;
      default:
        return std::fmod(a, b);
    }
  }

  static bool is_always(const Condition& condition, bool value) {
    if (condition.what == What::one) {
      return std::ranges::all_of(condition.values, [&](bool each) { return each == value; });
    }
    return condition.of.empty() && condition.what == (value ? What::all : What::any);
  }

  // Removes parts that are always true or false, and merges tables of the same parameter.
  static Condition simpler(Condition condition) {
    if (condition.what != What::all && condition.what != What::any) {
      return condition;
    }
    const bool decides = condition.what == What::any;  // a part that is so decides the whole
    Condition joined{.what = condition.what};
    std::map<std::size_t, std::size_t> tables;  // by parameter
    const auto add = [&](Condition part) {
      if (part.what == What::one) {
        const auto [known, is_new] = tables.emplace(part.parameters.front(), joined.of.size());
        if (!is_new) {
          std::vector<bool>& values = joined.of[known->second].values;
          for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = decides ? values[i] || part.values[i] : values[i] && part.values[i];
          }
          return;
        }
      }
      joined.of.push_back(std::move(part));
    };
    for (Condition& part : condition.of) {
      part = simpler(std::move(part));
      if (part.what == condition.what) {
        for (Condition& inner : part.of) {
          add(std::move(inner));
        }
      } else {
        add(std::move(part));
      }
    }
    for (const Condition& part : joined.of) {
      if (is_always(part, decides)) {
        return {.what = decides ? What::all : What::any};
      }
    }
    std::erase_if(joined.of, [&](const Condition& part) { return is_always(part, !decides); });
    if (joined.of.size() == 1) {
      Condition only = std::move(joined.of.front());
      return only;
    }
    return joined;
  }

  const Model& model_;
  std::vector<std::string> names_;  // by value: the text that is compared
  std::map<std::tuple<std::size_t, std::size_t, ModelRule::Relation, bool>,
           std::shared_ptr<const RuleTable>>
      tables_;
  std::size_t cases_ = 0;
  std::uint64_t line_ = 0;
};

}  // namespace

std::vector<std::size_t> parameters_of(const RuleCondition& condition) {
  std::vector<std::size_t> all = condition.parameters;
  for (const RuleCondition& part : condition.of) {
    const std::vector<std::size_t> more = parameters_of(part);
    all.insert(all.end(), more.begin(), more.end());
  }
  std::ranges::sort(all);
  const auto repeated = std::ranges::unique(all);
  all.erase(repeated.begin(), repeated.end());
  return all;
}

std::vector<RuleCondition> conditions_of(const Model& model) {
  RuleCompiler compiler(model);
  return each_of<RuleCondition>(model.constraints, [&](const ModelConstraint& constraint) {
    return compiler.compiled(constraint);
  });
}

}  // namespace changeover
