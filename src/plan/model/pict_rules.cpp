// Reads the rules of PICT.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/printable.hpp"
#include "plan/model/model_builder.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

constexpr unsigned deepest_brackets = 200;

struct PictToken {
  enum class What { end, parameter, text, number, sign, word };
  What what = What::end;
  std::string text = {};  // without brackets or quotes
  std::size_t at = 0;
};

class PictRules {
 public:
  PictRules(ModelBuilder& model, std::size_t offset)
      : model_(model), text_(model.text()), whole_(text_.text()), at_(offset) {
    next();
  }

  void read_all() {
    while (token_.what != PictToken::What::end) {
      const std::size_t begin = token_.at;
      counted_ = 0;
      ModelRule rule = read_rule();
      const std::size_t end = token_.at;
      take_sign(";", "end the rule with a semicolon");
      model_.add_constraint(std::move(rule), begin, end);
    }
  }

 private:
  using What = PictToken::What;

  [[noreturn]] void refuse(const std::string& what) const { text_.refuse(token_.at, what); }
  [[nodiscard]] std::string found() const {
    return token_.what == What::end ? "the end" : shown(token_.text);
  }

  // Skips blanks and lines that begin with #.
  void skip() {
    bool line_begins = at_ == 0 || whole_[at_ - 1] == '\n';
    while (at_ < whole_.size()) {
      const char c = whole_[at_];
      if (std::string_view(" \t\r\n").find(c) != std::string_view::npos) {
        line_begins = line_begins || c == '\n';
        ++at_;
      } else if (c == '#' && line_begins) {
        at_ = std::min(whole_.find('\n', at_), whole_.size());
      } else {
        return;
      }
    }
  }

  // The text up to the closing sign; a backslash escapes \, " and ].
  std::string up_to(char close, const std::string& how) {
    const std::size_t open = at_;
    std::string text;
    for (++at_; at_ < whole_.size() && whole_[at_] != close; ++at_) {
      if (whole_[at_] == '\n') {
        break;
      }
      if (whole_[at_] == '\\') {
        ++at_;
        if (at_ == whole_.size() ||
            std::string_view("\\\"]").find(whole_[at_]) == std::string_view::npos) {
          text_.refuse(at_ - 1,
                       "a backslash stands before \\, \" or ] only; write \\\\ for a backslash");
        }
      }
      text += whole_[at_];
    }
    if (at_ == whole_.size() || whole_[at_] != close) {
      text_.refuse(open, how);
    }
    ++at_;
    return text;
  }

  void next() {
    skip();
    token_ = {.at = at_};
    if (at_ == whole_.size()) {
      return;
    }
    const char c = whole_[at_];
    if (c == '[') {
      token_.text = trimmed(
          up_to(']', "the name of a parameter is not closed; end it with ] on the same line"));
      token_.what = What::parameter;
    } else if (c == '"') {
      token_.text = up_to('"', "a text is not closed; end it with a quote on the same line");
      token_.what = What::text;
    } else if (std::string_view("(){},;<>=").find(c) != std::string_view::npos) {
      const std::string_view two = whole_.substr(at_, 2);
      token_.text = two == "<>" || two == "<=" || two == ">=" ? two : whole_.substr(at_, 1);
      token_.what = What::sign;
      at_ += token_.text.size();
    } else {
      const std::size_t end =
          std::min(whole_.find_first_of(" \t\r\n(){},;<>=[\"", at_), whole_.size());
      token_.text = whole_.substr(at_, end - at_);
      token_.what = number_in(token_.text) ? What::number : What::word;
      at_ = end;
    }
  }

  [[nodiscard]] bool is_sign(std::string_view sign) const {
    return token_.what == What::sign && token_.text == sign;
  }
  [[nodiscard]] bool is_word(std::string_view word) const {
    return token_.what == What::word && same_word(token_.text, word);
  }
  void take_sign(std::string_view sign, std::string_view remedy) {
    if (!is_sign(sign)) {
      refuse(fmt::format("found {}; {}", found(), remedy));
    }
    next();
  }
  bool take_word(std::string_view word) {
    const bool there = is_word(word);
    if (there) {
      next();
    }
    return there;
  }

  ModelRule read_rule() {
    if (!take_word("if")) {
      return read_any();
    }
    ModelRule condition = read_any();
    const std::size_t in_condition = counted_;
    if (!take_word("then")) {
      refuse(fmt::format("found {}; write THEN after the condition of IF", found()));
    }
    ModelRule then = joined_rule(ModelRule::Kind::any, negated_rule(condition), read_any());
    if (!take_word("else")) {
      return then;
    }
    count(in_condition);  // it occurs twice
    return joined_rule(ModelRule::Kind::all, std::move(then),
                       joined_rule(ModelRule::Kind::any, std::move(condition), read_any()));
  }

  ModelRule read_any() {
    ModelRule rule = read_all_of();
    while (take_word("or")) {
      rule = joined_rule(ModelRule::Kind::any, std::move(rule), read_all_of());
    }
    return rule;
  }

  ModelRule read_all_of() {
    ModelRule rule = read_clause();
    while (take_word("and")) {
      rule = joined_rule(ModelRule::Kind::all, std::move(rule), read_clause());
    }
    return rule;
  }

  ModelRule read_clause() {
    if (++depth_ > deepest_brackets) {
      refuse(fmt::format("brackets more than {} deep; write the rule as several ones",
                         deepest_brackets));
    }
    ModelRule rule;
    if (take_word("not")) {
      rule = negated_rule(read_clause());
    } else if (is_sign("(")) {
      next();
      rule = read_any();
      take_sign(")", "close the bracket before it");
    } else if (is_word("isnegative") || is_word("ispositive")) {
      rule = read_range();
    } else {
      rule = read_condition();
    }
    --depth_;
    return rule;
  }

  // IsNegative(), IsNegative(P), and likewise IsPositive.
  ModelRule read_range() {
    const bool positive = is_word("ispositive");
    next();
    if (!is_sign("(")) {
      refuse(
          fmt::format("found {}; write brackets after a function, as in IsNegative(A)", found()));
    }
    const std::size_t close = whole_.find(')', at_);
    if (close == std::string_view::npos) {
      refuse("a bracket is not closed; close it");
    }
    std::string_view name = trimmed(whole_.substr(at_, close - at_));
    if (name.starts_with('[') && name.ends_with(']')) {
      name = trimmed(name.substr(1, name.size() - 2));
    }
    ModelRule rule{.kind = ModelRule::Kind::negative};
    if (!name.empty()) {
      rule.terms.push_back(parameter_term(model_.parameter(name, text_.at(name))));
    }
    count(name.empty() ? model_.size() : 1);
    at_ = close + 1;
    next();
    return positive ? negated_rule(std::move(rule)) : rule;
  }

  [[nodiscard]] static ModelTerm parameter_term(std::size_t parameter) {
    return {.kind = ModelTerm::Kind::parameter, .parameter = parameter};
  }

  ModelRule read_condition() {
    if (token_.what != What::parameter) {
      refuse(fmt::format("found {}; begin a condition with a parameter in [ ], NOT or a bracket",
                         found()));
    }
    const std::size_t parameter = model_.parameter(token_.text, token_.at);
    const ModelParameter& of = model_[parameter];
    ModelRule rule{.kind = ModelRule::Kind::compare};
    rule.terms.push_back(parameter_term(parameter));
    count();
    next();
    const bool negated = take_word("not");
    if (take_word("like")) {
      rule.kind = ModelRule::Kind::like;
      if (of.numeric) {
        refuse(
            fmt::format("LIKE is for texts, and all values of {} are numbers; compare with = or <",
                        shown(of.name)));
      }
      if (token_.what != What::text) {
        refuse(fmt::format("found {}; write a pattern in quotes after LIKE", found()));
      }
      rule.terms.push_back({.kind = ModelTerm::Kind::text, .text = token_.text});
      next();
    } else if (take_word("in")) {
      rule.kind = ModelRule::Kind::in;
      take_sign("{", "write values in { } after IN");
      while (true) {
        rule.terms.push_back(read_constant(of, true));
        count();
        if (!is_sign(",")) {
          break;
        }
        next();
      }
      take_sign("}", "end the list of values with }, with commas between them");
    } else if (negated) {
      refuse(fmt::format("found {}; write LIKE or IN after NOT", found()));
    } else {
      read_comparison(parameter, rule);
    }
    return negated ? negated_rule(std::move(rule)) : rule;
  }

  void read_comparison(std::size_t parameter, ModelRule& rule) {
    const ModelParameter& of = model_[parameter];
    rule.relation = read_relation();
    if (token_.what != What::parameter) {
      using enum ModelRule::Relation;
      rule.terms.push_back(read_constant(of, rule.relation == equal || rule.relation == unequal));
      return;
    }
    const std::size_t other = model_.parameter(token_.text, token_.at);
    if (other == parameter) {
      refuse("a parameter is compared with itself; compare it with another one or a value");
    }
    if (model_[other].numeric != of.numeric) {
      refuse(fmt::format(
          "{} and {} cannot be compared, for only one of them has numbers as values; compare "
          "each with a value",
          shown(of.name), shown(model_[other].name)));
    }
    rule.terms.push_back(parameter_term(other));
    next();
  }

  ModelRule::Relation read_relation() {
    using enum ModelRule::Relation;
    static constexpr std::pair<std::string_view, ModelRule::Relation> relations[] = {
        {"=", equal},    {"<>", unequal}, {"<", less},
        {"<=", at_most}, {">", greater},  {">=", at_least}};
    for (const auto& [sign, relation] : relations) {
      if (is_sign(sign)) {
        next();
        return relation;
      }
    }
    refuse(
        fmt::format("found {}; write =, <>, <, <=, >, >=, LIKE or IN after a parameter", found()));
  }

  ModelTerm read_constant(const ModelParameter& of, bool is_a_value) {
    ModelTerm constant{.kind = ModelTerm::Kind::text, .text = token_.text};
    if (token_.what == What::number) {
      if (!of.numeric) {
        refuse(fmt::format("the values of {} are texts, for not all are numbers; write \"{}\"",
                           shown(of.name), token_.text));
      }
      constant = {.kind = ModelTerm::Kind::number, .number = number_in(token_.text).value_or(0)};
    } else if (token_.what != What::text) {
      refuse(fmt::format("found {}; write a number, or a text in quotes", found()));
    } else if (of.numeric) {
      refuse(fmt::format("all values of {} are numbers; write a number without quotes",
                         shown(of.name)));
    }
    // A word that is no value is often misspelt.
    const bool known = std::ranges::any_of(of.values, [&](const ModelValue& value) {
      return of.numeric ? *value.number == constant.number
                        : same_word(value.names.front(), constant.text);
    });
    if (is_a_value && !known) {
      model_.note(token_.at, fmt::format("{} has no value {}", of.name, shown(token_.text)));
    }
    next();
    return constant;
  }

  void count(std::size_t conditions = 1) {
    counted_ += conditions;
    model_.count_condition(token_.at, conditions);
  }

  ModelBuilder& model_;
  ModelText& text_;
  std::string_view whole_;
  std::size_t at_;
  PictToken token_;
  unsigned depth_ = 0;
  std::size_t counted_ = 0;  // in this rule
};

}  // namespace

void read_pict_rules(ModelBuilder& model, std::size_t offset) {
  PictRules(model, offset).read_all();
}

}  // namespace changeover
