// Reads the parameters of a PICT model.
#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "core/lines.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/model/model_builder.hpp"
#include "plan/model/model_text.hpp"

namespace changeover {
namespace {

bool has_word(std::string_view line, std::string_view word) {
  return in_capitals(line).find(word) != std::string::npos;
}

// Whether a line begins the rules: "IF [", "[P] =", "(", "NOT (", "IsNegative(". A parameter may
// also be named If.
bool begins_rules(std::string_view line) {
  if (line.front() == '[' || line.front() == '(') {
    return true;
  }
  const std::size_t sign = line.find_first_of("[(:");
  const bool is_parameter = sign != std::string_view::npos && line[sign] == ':';
  if (is_parameter) {
    return false;
  }
  const auto begins_with = [&](std::string_view word) {
    return same_word(line.substr(0, word.size()), word) &&
           (line.size() == word.size() ||
            std::string_view(" \t[(").find(line[word.size()]) != std::string_view::npos);
  };
  if (begins_with("isnegative") || begins_with("ispositive")) {
    return sign != std::string_view::npos;
  }
  if (!begins_with("if") && !begins_with("not")) {
    return false;
  }
  return line.size() == 2 || line.find('[') != std::string_view::npos ||
         trimmed(line.substr(line.front() == 'n' || line.front() == 'N' ? 3 : 2))
             .starts_with('(') ||
         has_word(line, "ISNEGATIVE") || has_word(line, "ISPOSITIVE");
}

class PictReader {
 public:
  explicit PictReader(ModelText& text) : text_(text), model_(text) {}

  Model read() {
    std::size_t rules = text_.text().size();
    for (Lines lines(text_.text()); lines.next();) {
      const std::string_view line = trimmed(lines.line());
      if (!line.empty() && line.front() != '#') {
        if (begins_rules(line)) {
          rules = text_.at(lines.line());
          break;
        }
        line.front() == '{' ? take_sub_model(line) : take_parameter(line);
      }
    }
    if (weights_ > 0) {
      model_.note(fmt::format(
          "{} {} a weight, which does not count: costs decide what is tested more often",
          count_of(weights_, "value"), weights_ == 1 ? "has" : "have"));
    }
    model_.finish_parameters();
    read_pict_rules(model_, rules);
    return model_.take();
  }

 private:
  void take_parameter(std::string_view line) {
    std::size_t end = line.find(':');
    end = end == std::string_view::npos ? line.find(',') : end;
    const std::size_t at = text_.at(line);
    if (end == std::string_view::npos) {
      text_.refuse(at, fmt::format("{} is not a parameter; write its name, a colon and its values",
                                   shown(line)));
    }
    std::string_view name = trimmed(line.substr(0, end));
    if (name.starts_with('$')) {
      text_.refuse(at,
                   fmt::format("{} is a parameter of expected results, which are not supported; "
                               "leave it out",
                               shown(name)));
    }
    const std::size_t order = name.find('@');
    if (order != std::string_view::npos && number_in(trimmed(name.substr(order + 1)))) {
      model_.add_relation({.place = text_.place(at),
                           .parameters = {model_.size()},
                           .strength = strength_in(name.substr(order + 1), at)});
      name = trimmed(name.substr(0, order));
    }
    model_.add_parameter(name, at);
    for (const std::string_view value : split_values(line.substr(end + 1), ',')) {
      take_value(value);
    }
  }

  void take_value(std::string_view value) {
    const std::size_t at = text_.at(value);
    if (value.size() > 2 && value.front() == '<' && value.back() == '>') {
      const std::string_view name = trimmed(value.substr(1, value.size() - 2));
      if (const auto other = model_.find(name); other && *other + 1 < model_.size()) {
        model_.add_values_of(*other, at);
        return;
      }
      model_.note(at, fmt::format("no parameter before this one is called {}, so {} is a value",
                                  shown(name), shown(value)));
    }
    value = without_weight(value);
    const bool negative = value.starts_with('~');
    if (negative) {
      value = trimmed(value.substr(1));
    }
    std::vector<std::string> names;
    for (const std::string_view name : split_values(value, '|')) {
      names.emplace_back(name);
    }
    model_.add_value(std::move(names), negative, at);
  }

  // Removes a weight: "NTFS (10)".
  std::string_view without_weight(std::string_view value) {
    const std::size_t open = value.rfind('(');
    if (!value.ends_with(')') || open == std::string_view::npos) {
      return value;
    }
    const std::string_view inside = trimmed(value.substr(open + 1, value.size() - open - 2));
    std::uint64_t weight = 0;
    const auto [end, fault] = std::from_chars(inside.data(), inside.data() + inside.size(), weight);
    if (fault != std::errc() || end != inside.data() + inside.size() || weight == 0) {
      return value;
    }
    ++weights_;
    return trimmed(value.substr(0, open));
  }

  [[nodiscard]] std::uint64_t strength_in(std::string_view text, std::size_t at) const {
    text = trimmed(text);
    std::uint64_t strength = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), strength);
    if (fault != std::errc() || end != text.data() + text.size() || strength == 0) {
      text_.refuse(at,
                   fmt::format("found {}; write a strength after @, a whole number", shown(text)));
    }
    return strength;
  }

  // Lines such as "{ OS, Browser } @ 2".
  void take_sub_model(std::string_view line) {
    const std::size_t at = text_.at(line);
    const std::size_t close = line.find('}');
    if (close == std::string_view::npos) {
      text_.refuse(at, "a sub-model is not closed; write { A, B } @ 2");
    }
    ModelRelation relation{.place = text_.place(at), .parameters = {}};
    for (const std::string_view name : split_values(line.substr(1, close - 1), ',')) {
      relation.parameters.push_back(model_.parameter(name, text_.at(name)));
    }
    const std::string_view after = trimmed(line.substr(close + 1));
    if (!after.empty()) {
      if (after.front() != '@') {
        text_.refuse(text_.at(after), "a sub-model lacks its strength; write it as { A, B } @ 2");
      }
      relation.strength = strength_in(after.substr(1), text_.at(after));
    }
    model_.add_relation(std::move(relation));
  }

  ModelText& text_;
  ModelBuilder model_;
  std::size_t weights_ = 0;
};

}  // namespace

Model read_pict_model(ModelText& text) { return PictReader(text).read(); }

}  // namespace changeover
