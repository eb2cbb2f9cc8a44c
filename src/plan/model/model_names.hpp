// Finds parameters and values by the names that people write.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "changeover/plan/model.hpp"

namespace changeover {

/// The case of A to Z is ignored. The model must outlive this.
class ModelNames {
 public:
  explicit ModelNames(const Model& model);

  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] std::optional<std::size_t> parameter(std::string_view name) const;
  /// A value of this parameter by its label or any of its names, with or without ~ or the name of
  /// the parameter before it: "Debian", "OS: Debian".
  [[nodiscard]] std::optional<Element> value(std::size_t parameter, std::string_view name) const;
  /// What is behind the name of this parameter, if that is there: "Debian" of "OS: Debian".
  [[nodiscard]] std::string_view without_parameter(std::size_t parameter,
                                                   std::string_view name) const;
  /// "OS: Debian" or "OS=Debian", or "Debian" if only one parameter has such a value.
  [[nodiscard]] std::optional<Element> part(std::string_view word) const;
  /// The message for a word that part() does not find.
  [[nodiscard]] std::string complaint(std::string_view word) const;

 private:
  const Model* model_;
  std::unordered_map<std::string, std::size_t> parameters_;
  std::vector<std::unordered_map<std::string, Element>> values_;  // by parameter
};

/// The one of these parameters that was probably meant by a name that none of them has.
[[nodiscard]] std::optional<std::string> parameter_meant(
    std::string_view name, const std::vector<std::string>& parameters);

/// The message for a name that no parameter of the model has.
[[nodiscard]] std::string no_parameter(std::string_view name, const Model& model);

}  // namespace changeover
