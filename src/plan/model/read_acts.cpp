// Reads a model of ACTS: sections with one parameter, relation or rule per line.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/each.hpp"
#include "core/lines.hpp"
#include "core/printable.hpp"
#include "plan/model/model_builder.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

constexpr unsigned deepest_expression = 200;

struct ActsToken {
  enum class What { end, text, number, name, sign };
  What what = What::end;
  std::string_view text = {};  // without quotes
  std::size_t at = 0;
};

// The value of an expression: a condition, or an operand.
struct ActsValue {
  std::optional<ModelRule> rule = {};
  ModelTerm term = {};
  std::size_t at = 0;
};

// One line of rules.
class ActsRule {
 public:
  ActsRule(ModelBuilder& model, std::string_view line)
      : model_(model), text_(model.text()), line_(line) {
    next();
  }

  ModelRule read() {
    ModelRule rule = as_rule(read_implication());
    if (token_.what != What::end) {
      refuse(fmt::format("found {} after the end of a rule; write one rule per line",
                         shown(token_.text)));
    }
    return rule;
  }

 private:
  using What = ActsToken::What;
  using Kind = ModelRule::Kind;
  using Relation = ModelRule::Relation;

  [[noreturn]] void refuse(const std::string& what) const { text_.refuse(token_.at, what); }
  [[nodiscard]] std::string found() const {
    return token_.what == What::end ? "the end of the line" : shown(token_.text);
  }

  void next() {
    at_ = std::min(line_.find_first_not_of(" \t\r", at_), line_.size());
    token_ = {.at = text_.at(line_) + at_};
    if (at_ == line_.size()) {
      return;
    }
    if (line_[at_] == '"') {
      const std::size_t close = line_.find('"', at_ + 1);
      if (close == std::string_view::npos) {
        refuse("a text is not closed; end it with a quote");
      }
      token_.what = What::text;
      token_.text = line_.substr(at_ + 1, close - at_ - 1);
      at_ = close + 1;
      return;
    }
    constexpr std::string_view signs = "()=!<>&|+-*/%,\"";
    if (signs.find(line_[at_]) == std::string_view::npos) {
      const std::size_t end =
          std::min(line_.find_first_of(" \t\r()=!<>&|+*/%,\"", at_), line_.size());
      token_.text = line_.substr(at_, end - at_);
      if (!number_in(token_.text) && !model_.find(token_.text)) {  // a-b is a difference, or a name
        token_.text = token_.text.substr(0, cut_at_minus(token_.text));
      }
      token_.what = number_in(token_.text) ? What::number : What::name;
      at_ += token_.text.size();
      return;
    }
    token_.what = What::sign;
    const std::string_view two = line_.substr(at_, 2);
    constexpr std::string_view long_signs[] = {"=>", "==", "!=", "<=", ">=", "<>", "&&", "||"};
    const bool is_long = std::ranges::find(long_signs, two) != std::end(long_signs);
    token_.text = line_.substr(at_, is_long ? 2 : 1);
    at_ += token_.text.size();
  }

  // The longest prefix that is a parameter, if another one follows a minus.
  [[nodiscard]] std::size_t cut_at_minus(std::string_view name) const {
    for (std::size_t at = name.rfind('-'); at != std::string_view::npos && at > 0;
         at = name.rfind('-', at - 1)) {
      if (model_.find(name.substr(0, at))) {
        return at;
      }
    }
    return name.size();
  }

  [[nodiscard]] bool is_sign(std::string_view sign) const {
    return token_.what == What::sign && token_.text == sign;
  }
  bool take_sign(std::string_view sign) {
    const bool there = is_sign(sign);
    if (there) {
      next();
    }
    return there;
  }

  [[nodiscard]] static bool is_true(std::string_view word) { return same_word(word, "true"); }
  [[nodiscard]] static bool is_false(std::string_view word) { return same_word(word, "false"); }

  [[nodiscard]] bool is_truth(const ModelTerm& term) const {
    return term.kind == ModelTerm::Kind::text && (is_true(term.text) || is_false(term.text));
  }

  // Converts an operand to a condition: a boolean parameter, or the word true or false.
  ModelRule as_rule(ActsValue value) {
    if (value.rule) {
      return std::move(*value.rule);
    }
    if (is_truth(value.term)) {
      return {.kind = is_true(value.term.text) ? Kind::all : Kind::any};
    }
    const bool of_truth =
        value.term.kind == ModelTerm::Kind::parameter &&
        std::ranges::all_of(model_[value.term.parameter].values, [](const ModelValue& each) {
          return is_true(each.names.front()) || is_false(each.names.front());
        });
    if (!of_truth) {
      text_.refuse(value.at, "this is not a condition; compare it, as in OS = \"Debian\"");
    }
    model_.count_condition(value.at);
    ModelRule rule{.kind = Kind::compare};
    rule.terms = {std::move(value.term), {.kind = ModelTerm::Kind::text, .text = "true"}};
    return rule;
  }

  ActsValue read_implication() {
    ActsValue left = read_any();
    if (!is_sign("=>")) {
      return left;
    }
    deeper();
    next();
    const std::size_t at = left.at;
    ModelRule condition = negated_rule(as_rule(std::move(left)));
    ModelRule then = as_rule(read_implication());
    --depth_;
    return {.rule = joined_rule(Kind::any, std::move(condition), std::move(then)), .at = at};
  }

  ActsValue read_any() { return read_chain("||", Kind::any, &ActsRule::read_all_of); }
  ActsValue read_all_of() { return read_chain("&&", Kind::all, &ActsRule::read_comparison); }

  ActsValue read_chain(std::string_view sign, Kind kind, ActsValue (ActsRule::*part)()) {
    ActsValue left = (this->*part)();
    while (take_sign(sign)) {
      const std::size_t at = left.at;
      ModelRule first = as_rule(std::move(left));
      ModelRule second = as_rule((this->*part)());
      left = {.rule = joined_rule(kind, std::move(first), std::move(second)), .at = at};
    }
    return left;
  }

  ActsValue read_comparison() {
    static constexpr std::pair<std::string_view, Relation> relations[] = {
        {"=", Relation::equal},    {"==", Relation::equal},   {"!=", Relation::unequal},
        {"<>", Relation::unequal}, {"<", Relation::less},     {"<=", Relation::at_most},
        {">", Relation::greater},  {">=", Relation::at_least}};
    ActsValue left = read_sum();
    for (const auto& [sign, relation] : relations) {
      if (is_sign(sign)) {
        next();
        const std::size_t at = left.at;
        ActsValue right = read_sum();
        return {.rule = compared(relation, std::move(left), std::move(right)), .at = at};
      }
    }
    return left;
  }

  ModelRule compared(Relation relation, ActsValue left, ActsValue right) {
    if (left.rule || right.rule) {  // a condition that is true or false
      if (relation != Relation::equal && relation != Relation::unequal) {
        text_.refuse(left.at, "conditions have no order; compare them with = or !=");
      }
      ModelRule a = as_rule(std::move(left));
      ModelRule b = as_rule(std::move(right));
      model_.count_condition(token_.at,
                             conditions_in(a) + conditions_in(b));  // both conditions occur twice
      ModelRule both = joined_rule(Kind::all, a, b);
      ModelRule none =
          joined_rule(Kind::all, negated_rule(std::move(a)), negated_rule(std::move(b)));
      ModelRule same = joined_rule(Kind::any, std::move(both), std::move(none));
      return relation == Relation::equal ? same : negated_rule(std::move(same));
    }
    model_.count_condition(left.at);
    const bool numbers = is_of_numbers(left.term) && is_of_numbers(right.term);
    const bool could_be = is_constant(left.term) || is_constant(right.term);
    if (!numbers && is_of_numbers(left.term) != is_of_numbers(right.term)) {
      if (!could_be) {
        text_.refuse(left.at, "a number and a text cannot be compared; compare each with a value");
      }
      // A constant takes the type of the other side.
      ModelTerm& constant = is_constant(right.term) ? right.term : left.term;
      if (constant.kind == ModelTerm::Kind::text) {
        const auto number = number_in(constant.text);
        if (!number) {
          text_.refuse(right.at,
                       fmt::format("{} is not a number, and the other side is one; write a number",
                                   shown(constant.text)));
        }
        constant = {.kind = ModelTerm::Kind::number, .number = *number};
      } else {
        constant = {.kind = ModelTerm::Kind::text,
                    .text = written_of(constant, is_constant(right.term) ? right.at : left.at)};
      }
    }
    note_if_unknown(left, right, relation);
    ModelRule rule{.kind = Kind::compare, .relation = relation};
    rule.terms = {std::move(left.term), std::move(right.term)};
    return rule;
  }

  [[nodiscard]] static std::size_t conditions_in(const ModelRule& rule) {
    return 1 +
           sum_of<std::size_t>(rule.of, [&](const ModelRule& part) { return conditions_in(part); });
  }

  // A number as written.
  [[nodiscard]] std::string written_of(const ModelTerm& constant, std::size_t at) const {
    const std::string_view rest = text_.text().substr(at);
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n()=!<>&|*/%,\""));
    return number_in(word) ? std::string(word) : fmt::format("{}", constant.number);
  }

  void note_if_unknown(const ActsValue& left, const ActsValue& right, Relation relation) {
    const bool is_value = left.term.kind == ModelTerm::Kind::parameter && is_constant(right.term) &&
                          (relation == Relation::equal || relation == Relation::unequal);
    if (!is_value) {
      return;
    }
    const ModelParameter& of = model_[left.term.parameter];
    const bool known = std::ranges::any_of(of.values, [&](const ModelValue& value) {
      return right.term.kind == ModelTerm::Kind::number
                 ? value.number == right.term.number
                 : same_word(value.names.front(), right.term.text);
    });
    if (!known) {
      model_.note(right.at, fmt::format("{} has no such value", of.name));
    }
  }

  [[nodiscard]] static bool is_constant(const ModelTerm& term) {
    return term.kind == ModelTerm::Kind::text || term.kind == ModelTerm::Kind::number;
  }
  [[nodiscard]] bool is_of_numbers(const ModelTerm& term) const {
    return term.kind == ModelTerm::Kind::parameter ? model_[term.parameter].numeric
                                                   : term.kind != ModelTerm::Kind::text;
  }

  ActsValue read_sum() {
    ActsValue left = read_product();
    while (is_sign("+") || is_sign("-")) {
      const auto kind = is_sign("+") ? ModelTerm::Kind::sum : ModelTerm::Kind::difference;
      next();
      left = combined(kind, std::move(left), read_product());
    }
    return left;
  }

  ActsValue read_product() {
    ActsValue left = read_unary();
    while (is_sign("*") || is_sign("/") || is_sign("%")) {
      const auto kind = is_sign("*")   ? ModelTerm::Kind::product
                        : is_sign("/") ? ModelTerm::Kind::quotient
                                       : ModelTerm::Kind::remainder;
      next();
      left = combined(kind, std::move(left), read_unary());
    }
    return left;
  }

  ActsValue combined(ModelTerm::Kind kind, ActsValue left, ActsValue right) {
    if (left.rule || right.rule || !is_of_numbers(left.term) || !is_of_numbers(right.term)) {
      text_.refuse(left.at,
                   "only numbers can be added and multiplied; use parameters with numbers");
    }
    if (++terms_ > deepest_expression) {
      text_.refuse(left.at,
                   fmt::format("more than {} operators in a rule; split it into several rules",
                               deepest_expression));
    }
    ActsValue value{.term = {.kind = kind}, .at = left.at};
    value.term.of = {std::move(left.term), std::move(right.term)};
    return value;
  }

  void deeper() {
    if (++depth_ > deepest_expression) {
      refuse(fmt::format("brackets more than {} deep; write the rule as several ones",
                         deepest_expression));
    }
  }

  ActsValue read_unary() {
    deeper();
    const std::size_t at = token_.at;
    ActsValue value;
    if (take_sign("!")) {
      value = {.rule = negated_rule(as_rule(read_unary())), .at = at};
    } else if (take_sign("-")) {
      value = combined(ModelTerm::Kind::difference,
                       {.term = {.kind = ModelTerm::Kind::number}, .at = at}, read_unary());
    } else if (take_sign("(")) {
      value = read_implication();
      if (!take_sign(")")) {
        refuse(fmt::format("found {}; close the bracket before it", found()));
      }
    } else {
      value = read_word();
    }
    --depth_;
    return value;
  }

  ActsValue read_word() {
    ActsValue value{.at = token_.at};
    if (token_.what == What::number) {
      value.term = {.kind = ModelTerm::Kind::number, .number = number_in(token_.text).value_or(0)};
    } else if (token_.what == What::text) {
      value.term = {.kind = ModelTerm::Kind::text, .text = std::string(token_.text)};
    } else if (token_.what == What::name) {
      if (const auto parameter = model_.find(token_.text)) {
        value.term = {.kind = ModelTerm::Kind::parameter, .parameter = *parameter};
      } else {
        value.term = {.kind = ModelTerm::Kind::text, .text = std::string(token_.text)};
      }
    } else {
      refuse(
          fmt::format("found {}; compare parameters and values, as in OS = \"Debian\"", found()));
    }
    next();
    return value;
  }

  ModelBuilder& model_;
  ModelText& text_;
  std::string_view line_;
  std::size_t at_ = 0;
  ActsToken token_;
  unsigned depth_ = 0;
  unsigned terms_ = 0;
};

class ActsReader {
 public:
  explicit ActsReader(ModelText& text) : text_(text), model_(text) {}

  Model read() {
    for (Lines lines(text_.text()); lines.next();) {
      const std::string_view line = trimmed(lines.line());
      if (!line.empty() && !line.starts_with("--") && line.front() != '#') {
        line.front() == '[' ? begin_section(line) : take_line(line);
      }
    }
    finish_parameters();
    return model_.take();
  }

 private:
  enum class Section { system, parameter, relation, constraint };

  void begin_section(std::string_view line) {
    static constexpr std::pair<std::string_view, Section> sections[] = {
        {"[System]", Section::system},
        {"[Parameter]", Section::parameter},
        {"[Relation]", Section::relation},
        {"[Constraint]", Section::constraint}};
    const auto known = std::ranges::find_if(
        sections, [&](const auto& section) { return same_word(section.first, line); });
    if (known == std::end(sections)) {
      text_.refuse(text_.at(line),
                   fmt::format("the section {} is not supported; leave it out", shown(line)));
    }
    section_ = known->second;
    if (section_ == Section::parameter && finished_) {
      text_.refuse(text_.at(line), "parameters stand after relations or rules; move them up");
    }
    if (section_ == Section::relation || section_ == Section::constraint) {
      finish_parameters();
    }
  }

  void take_line(std::string_view line) {
    const std::size_t at = text_.at(line);
    switch (section_) {
      case Section::system:
        return;
      case Section::parameter:
        return take_parameter(line);
      case Section::relation:
        return take_relation(line);
      case Section::constraint: {
        ModelRule rule = ActsRule(model_, line).read();
        model_.add_constraint(std::move(rule), at, at + line.size());
        return;
      }
    }
  }

  void finish_parameters() {
    if (!std::exchange(finished_, true)) {
      model_.finish_parameters();
    }
  }

  // Lines such as "OS (enum) : Debian, Windows".
  void take_parameter(std::string_view line) {
    const std::size_t at = text_.at(line);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) {
      text_.refuse(
          at, fmt::format("{} is not a parameter; write OS (enum) : Debian, Windows", shown(line)));
    }
    std::string_view name = trimmed(line.substr(0, colon));
    std::string_view type;
    const std::size_t open = name.rfind('(');
    if (name.ends_with(')') && open != std::string_view::npos) {
      type = trimmed(name.substr(open + 1, name.size() - open - 2));
      name = trimmed(name.substr(0, open));
    }
    constexpr std::string_view of_numbers[] = {"int", "integer", "number", "real"};
    constexpr std::string_view of_texts[] = {"enum", "boolean", "bool"};
    const auto is_one_of = [&](auto& types) {
      return std::ranges::any_of(types,
                                 [&](std::string_view each) { return same_word(each, type); });
    };
    if (!type.empty() && !is_one_of(of_numbers) && !is_one_of(of_texts)) {
      text_.refuse(
          at, fmt::format("the type {} is not supported; write int, enum or boolean", shown(type)));
    }
    model_.add_parameter(name, at, is_one_of(of_texts));
    for (const std::string_view value : split_values(line.substr(colon + 1), ',')) {
      const std::size_t place = text_.at(value);
      if (value.empty()) {
        text_.refuse(place, fmt::format("a value of {} has no name; write one between the commas",
                                        shown(name)));
      }
      if (value.find_first_of(";:") != std::string_view::npos) {
        text_.refuse(
            place, fmt::format("{} is more than a value; write one between commas", shown(value)));
      }
      if (!type.empty() && is_one_of(of_numbers) && !number_in(value)) {
        text_.refuse(place,
                     fmt::format("{} is not a number, and {} is of the type {}; write a number",
                                 shown(value), shown(name), type));
      }
      model_.add_value({std::string(value)}, false, place);
    }
  }

  // Lines such as "R1 : (OS, Browser, 2)".
  void take_relation(std::string_view line) {
    const std::size_t at = text_.at(line);
    const std::size_t open = line.find('(');
    const std::size_t close = line.rfind(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
      text_.refuse(at, "this is not a relation; write it as R1 : (OS, Browser, 2)");
    }
    ModelRelation relation{.place = text_.place(at), .parameters = {}};
    std::vector<std::string_view> words =
        split_values(line.substr(open + 1, close - open - 1), ',');
    if (const std::string_view after = trimmed(line.substr(close + 1)); !after.empty()) {
      words.push_back(after);
    }
    std::uint64_t strength = 0;
    const std::string_view last = words.back();
    const auto [end, fault] = std::from_chars(last.data(), last.data() + last.size(), strength);
    if (fault == std::errc() && end == last.data() + last.size() && !model_.find(last)) {
      relation.strength = strength;
      words.pop_back();
    }
    for (const std::string_view word : words) {
      relation.parameters.push_back(model_.parameter(word, text_.at(word)));
    }
    model_.add_relation(std::move(relation));
  }

  ModelText& text_;
  ModelBuilder model_;
  Section section_ = Section::system;
  bool finished_ = false;
};

// Whether the first line that is no comment begins a section.
bool is_acts(std::string_view text) {
  for (Lines lines(text); lines.next();) {
    const std::string_view line = trimmed(lines.line());
    if (!line.empty() && line.front() != '#' && !line.starts_with("--")) {
      return same_word(line, "[System]") || same_word(line, "[Parameter]");
    }
  }
  return false;
}

}  // namespace

Model read_acts_model(ModelText& text) { return ActsReader(text).read(); }

std::string text_of_model(Input& input) {
  constexpr std::size_t most_bytes = std::size_t{1} << 24;
  return read_to_end(input, most_bytes,
                     "a model lists parameters and rules; is this another file?");
}

Model read_model(Input& input) {
  ModelText text(text_of_model(input), input.name());
  return is_acts(text.text()) ? read_acts_model(text) : read_pict_model(text);
}

}  // namespace changeover
