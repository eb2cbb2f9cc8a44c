#include "plan/model/compiled_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_rule_literals = 50'000'000;

}  // namespace

CompiledRules::CompiledRules(const Model& model)
    : banned_(model.values(), false),
      apart_(model.values() * model.values(), false),
      with_(model.parameters.size()) {
  for (const ModelParameter& parameter : model.parameters) {
    first_.push_back(parameter.first);
  }
  first_.push_back(static_cast<Element>(model.values()));
  std::vector<Element> negative;
  for (Element x = 0; x < model.values(); ++x) {
    if (!model.value(x).negative) {
      continue;
    }
    for (const Element y : negative) {
      if (model.parameter_of(x) != model.parameter_of(y)) {
        apart_[x * values() + y] = apart_[y * values() + x] = true;
        any_apart_ = true;
      }
    }
    negative.push_back(x);
  }
  for (RuleCondition& condition : conditions_of(model)) {
    std::vector<RuleCondition> parts;  // all of them hold
    if (condition.what == RuleCondition::What::all) {
      parts = std::move(condition.of);
    } else {
      parts.push_back(std::move(condition));
    }
    for (RuleCondition& part : parts) {
      const std::vector<std::size_t> parameters = parameters_of(part);
      if (parameters.size() <= 2) {
        RuleCondition whole{.what = RuleCondition::What::all, .parameters = parameters};
        whole.of.push_back(std::move(part));
        forbid_cases(whole);
        continue;
      }
      for (const std::size_t p : parameters) {
        with_[p].push_back(static_cast<std::uint32_t>(conditions_.size()));
      }
      conditions_.push_back(std::move(part));
    }
  }
}

// For at most two parameters: every case that does not hold is excluded.
void CompiledRules::forbid_cases(const RuleCondition& condition) {
  const std::vector<std::size_t>& parameters = condition.parameters;
  if (parameters.empty()) {  // it can never hold
    if (!holds(condition, {})) {
      banned_.assign(banned_.size(), true);
    }
    return;
  }
  std::vector<Element> row(first_.size() - 1, 0);
  const std::size_t p = parameters.front();
  for (row[p] = first_[p]; row[p] < first_[p + 1]; ++row[p]) {
    if (parameters.size() == 1) {
      banned_[row[p]] = banned_[row[p]] || !holds(condition, row);
      continue;
    }
    stop_if_asked();
    const std::size_t q = parameters.back();
    for (row[q] = first_[q]; row[q] < first_[q + 1]; ++row[q]) {
      if (!holds(condition, row)) {
        apart_[row[p] * values() + row[q]] = apart_[row[q] * values() + row[p]] = true;
        any_apart_ = true;
      }
    }
  }
}

bool CompiledRules::holds(const RuleCondition& condition, std::span<const Element> row) const {
  const auto value = [&](std::size_t parameter) {
    return static_cast<std::size_t>(row[parameter] - first_[parameter]);
  };
  switch (condition.what) {
    case RuleCondition::What::all:
      return std::ranges::all_of(condition.of,
                                 [&](const RuleCondition& part) { return holds(part, row); });
    case RuleCondition::What::any:
      return std::ranges::any_of(condition.of,
                                 [&](const RuleCondition& part) { return holds(part, row); });
    case RuleCondition::What::one:
      return condition.values[value(condition.parameters[0])];
    case RuleCondition::What::two:
      return condition.table->holds[value(condition.parameters[0]) * condition.table->width +
                                    value(condition.parameters[1])];
    case RuleCondition::What::some: {
      std::size_t at = 0;
      for (const std::size_t p : condition.parameters) {
        at = at * (first_[p + 1] - first_[p]) + value(p);
      }
      return condition.values[at];
    }
  }
  throw InternalError("a condition that is none");
}

bool CompiledRules::allows(std::span<const Element> row, std::size_t parameter, Element x) const {
  const std::vector<std::uint32_t>& with = with_[parameter];
  if (with.empty()) {
    return true;
  }
  thread_local std::vector<Element> changed;
  if (row[parameter] != x) {
    changed.assign(row.begin(), row.end());
    changed[parameter] = x;
    row = changed;
  }
  return std::ranges::all_of(with, [&](std::uint32_t i) { return holds(conditions_[i], row); });
}

void CompiledRules::add_to(Cnf& cnf) const {
  const auto literal = [](Element x) { return static_cast<Literal>(x) + 1; };
  for (std::size_t x = 0; x < values(); ++x) {
    cnf.new_variable();
  }
  std::vector<Literal> clause;
  for (std::size_t p = 0; p + 1 < first_.size(); ++p) {
    clause.clear();
    for (Element x = first_[p]; x < first_[p + 1]; ++x) {
      clause.push_back(literal(x));
      for (Element y = first_[p]; y < x; ++y) {
        cnf.add({-literal(x), -literal(y)});
      }
    }
    cnf.add(clause);
  }
  for (Element x = 0; x < values(); ++x) {
    if (banned_[x]) {
      cnf.add({-literal(x)});
    }
    for (Element y = 0; y < x; ++y) {
      if (apart(x, y)) {
        cnf.add({-literal(x), -literal(y)});
      }
    }
  }
  for (const RuleCondition& condition : conditions_) {
    stop_if_asked();
    if (condition.what == RuleCondition::What::some) {
      add_cases(condition, 0, cnf);
      continue;
    }
    clause.clear();
    literals_of(condition, cnf, clause);
    cnf.add(clause);
    if (cnf.size().literals > most_rule_literals) {
      throw MissingResource(fmt::format(
          "the rules of the model are a formula of more than {} literals; plan for a part of the "
          "model",
          most_rule_literals));
    }
  }
}

// Adds literals of which one holds if and only if the condition does.
void CompiledRules::literals_of(const RuleCondition& condition, Cnf& cnf,
                                std::vector<Literal>& clause) const {
  const auto literal = [this](std::size_t parameter, std::size_t i) {
    return static_cast<Literal>(first_[parameter] + i) + 1;
  };
  switch (condition.what) {
    case RuleCondition::What::any:
      for (const RuleCondition& part : condition.of) {
        literals_of(part, cnf, clause);
      }
      return;
    case RuleCondition::What::one: {
      const std::size_t p = condition.parameters[0];
      const auto out = std::ranges::count(condition.values, false);
      for (std::size_t i = 0; i < condition.values.size(); ++i) {
        if (out == 1 && !condition.values[i]) {
          clause.push_back(-literal(p, i));
        } else if (out != 1 && condition.values[i]) {
          clause.push_back(literal(p, i));
        }
      }
      return;
    }
    case RuleCondition::What::all: {
      const Literal whole = cnf.new_variable();
      clause.push_back(whole);
      std::vector<Literal> part_clause;
      for (const RuleCondition& part : condition.of) {
        part_clause = {-whole};
        literals_of(part, cnf, part_clause);
        cnf.add(part_clause);
      }
      return;
    }
    case RuleCondition::What::two: {
      const Literal whole = cnf.new_variable();
      clause.push_back(whole);
      const std::size_t p = condition.parameters[0];
      const std::size_t q = condition.parameters[1];
      std::vector<Literal> row;
      for (std::size_t i = 0; i < first_[p + 1] - first_[p]; ++i) {
        row = {-whole, -literal(p, i)};
        for (std::size_t j = 0; j < condition.table->width; ++j) {
          if (condition.table->holds[i * condition.table->width + j]) {
            row.push_back(literal(q, j));
          }
        }
        cnf.add(row);
      }
      return;
    }
    case RuleCondition::What::some: {
      const Literal whole = cnf.new_variable();
      clause.push_back(whole);
      add_cases(condition, -whole, cnf);
      return;
    }
  }
}

// Excludes every case that does not hold; with a literal, only if that does not hold.
void CompiledRules::add_cases(const RuleCondition& condition, Literal unless, Cnf& cnf) const {
  std::vector<Literal> clause;
  for (std::size_t i = 0; i < condition.values.size(); ++i) {
    if (condition.values[i]) {
      continue;
    }
    clause.clear();
    if (unless != 0) {
      clause.push_back(unless);
    }
    std::size_t rest = i;
    for (std::size_t k = condition.parameters.size(); k-- > 0;) {
      const std::size_t p = condition.parameters[k];
      const std::size_t values = first_[p + 1] - first_[p];
      clause.push_back(-(static_cast<Literal>(first_[p] + rest % values) + 1));
      rest /= values;
    }
    cnf.add(clause);
  }
}

}  // namespace changeover
