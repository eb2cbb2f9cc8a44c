// Bodies of JSON: an object whose members are asked for by name, and by type.
//
//     const JsonBody body(request.body);
//     const std::uint64_t items = body.needed_number("items");
//     body.finish();                                   // refuses members that were not read
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>

namespace changeover::serve {

class JsonBody {
 public:
  /// @throws Refusal 422 with line and column if it is no JSON, nests deeper than 256 levels or is
  /// no object.
  explicit JsonBody(const std::string& text);
  ~JsonBody();
  JsonBody(const JsonBody&) = delete;
  JsonBody& operator=(const JsonBody&) = delete;

  /// nullptr if it is missing or null.
  [[nodiscard]] const nlohmann::json* find(const std::string& name);

  /// A whole number that is not negative. @throws Refusal 422 if it is something else.
  [[nodiscard]] std::optional<std::uint64_t> number(const std::string& name);
  [[nodiscard]] std::uint64_t needed_number(const std::string& name);
  /// An amount in decimal: a number or a string, as it is written.
  [[nodiscard]] std::optional<std::string> decimal(const std::string& name);
  [[nodiscard]] std::optional<double> seconds(const std::string& name);
  [[nodiscard]] std::optional<bool> boolean(const std::string& name);
  [[nodiscard]] std::optional<std::string> text(const std::string& name);

  /// @throws Refusal 422 if there are members that were not read.
  void finish() const;

 private:
  std::unique_ptr<nlohmann::json> object_;
  std::set<std::string> asked_;
};

}  // namespace changeover::serve
