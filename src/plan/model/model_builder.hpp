// Builds a model; shared by its readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "changeover/plan/model.hpp"

namespace changeover {

/// A text with a name, and the places in it.
class ModelText {
 public:
  /// @throws BadInput for a text that is not plain text.
  ModelText(std::string text, std::string name);

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::size_t at(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - text_.data());
  }
  /// The line of an offset; fast for increasing offsets.
  [[nodiscard]] std::uint64_t line(std::size_t offset);
  [[nodiscard]] std::string place(std::size_t offset) const;
  [[noreturn]] void refuse(std::size_t offset, std::string_view what) const;

 private:
  std::string text_;
  std::string name_;
  std::size_t counted_ = 0;
  std::uint64_t line_ = 1;
};

/// Adds parameters, values and conditions, and refuses malformed ones.
class ModelBuilder {
 public:
  explicit ModelBuilder(ModelText& text) : text_(text) { model_.name = text.name(); }

  /// The number of the parameter with this name, in any case.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// The same. @throws BadInput if there is none.
  [[nodiscard]] std::size_t parameter(std::string_view name, std::size_t at) const;
  [[nodiscard]] const ModelParameter& operator[](std::size_t parameter) const {
    return model_.parameters[parameter];
  }
  [[nodiscard]] std::size_t size() const { return model_.parameters.size(); }

  /// Adds a parameter. With `of_texts`, rules treat its values as texts, even if all are numbers.
  void add_parameter(std::string_view name, std::size_t at, bool of_texts = false);
  /// Adds a value to the last parameter.
  void add_value(std::vector<std::string> names, bool negative, std::size_t at);
  /// Adds the values of another parameter.
  void add_values_of(std::size_t parameter, std::size_t at);
  /// Ends the parameters. @throws BadInput if there are too few.
  void finish_parameters();

  /// Its parameters may come in any order, and more than once.
  void add_relation(ModelRelation relation);
  void add_constraint(ModelRule rule, std::size_t begin, std::size_t end);
  /// Counts conditions of rules. @throws BadInput beyond max_model_conditions.
  void count_condition(std::size_t at, std::size_t conditions = 1);
  /// Adds a note with its line; beyond a few, notes are only counted.
  void note(std::size_t at, const std::string& what);
  void note(std::string line) { model_.notes.push_back(std::move(line)); }

  [[nodiscard]] Model take();
  [[nodiscard]] ModelText& text() { return text_; }

 private:
  /// @throws BadInput if the name of that kind of thing is too long or has signs that it may not
  void check_text(std::string_view what, std::string_view text, std::size_t at) const;

  ModelText& text_;
  Model model_;
  std::unordered_map<std::string, std::size_t> by_name_;
  std::vector<bool> of_texts_;  // by parameter
  std::size_t values_ = 0;
  std::size_t conditions_ = 0;
  std::size_t more_notes_ = 0;
};

/// Reads a model. @throws BadInput with a place.
[[nodiscard]] Model read_pict_model(ModelText& text);
[[nodiscard]] Model read_acts_model(ModelText& text);

/// Reads the rules of PICT from this offset on. @throws BadInput with a place.
void read_pict_rules(ModelBuilder& model, std::size_t offset);

/// A rule that combines two by `any` or `all`, and merges nested rules of the same kind.
[[nodiscard]] ModelRule joined_rule(ModelRule::Kind kind, ModelRule a, ModelRule b);
[[nodiscard]] ModelRule negated_rule(ModelRule rule);

}  // namespace changeover
