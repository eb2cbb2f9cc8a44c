#include "serve/api/request/json_body.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "io/scan/json_events.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {
namespace {

// What is no JSON, or too deep, is refused with its place before anything is built of it.
class Glance final : public JsonHandler {
 public:
  void on(const JsonEvent& /*event*/) override {}
};

[[noreturn]] void refuse_type(const std::string& name, std::string_view wanted) {
  throw Refusal{422, fmt::format("{}: write {}", name, wanted)};
}

}  // namespace

JsonBody::JsonBody(const std::string& text) {
  const std::string name = "<text>";
  Glance glance;
  parse_json({.text = text, .name = name}, glance);
  object_ = std::make_unique<nlohmann::json>(nlohmann::json::parse(text, nullptr, false));
  if (!object_->is_object()) {
    throw Refusal{422, "give an object of JSON, {…}"};
  }
}

JsonBody::~JsonBody() = default;

const nlohmann::json* JsonBody::find(const std::string& name) {
  asked_.insert(name);
  const auto found = object_->find(name);
  return found == object_->end() || found->is_null() ? nullptr : &*found;
}

std::optional<std::uint64_t> JsonBody::number(const std::string& name) {
  const nlohmann::json* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_number_unsigned()) {
    refuse_type(name, "a whole number");
  }
  return value->get<std::uint64_t>();
}

std::uint64_t JsonBody::needed_number(const std::string& name) {
  const auto value = number(name);
  if (!value) {
    throw Refusal{422, name + " is missing"};
  }
  return *value;
}

std::optional<std::string> JsonBody::decimal(const std::string& name) {
  const nlohmann::json* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (value->is_string()) {
    return value->get<std::string>();
  }
  if (!value->is_number()) {
    refuse_type(name, "an amount, as 12.50");
  }
  return value->dump();
}

std::optional<double> JsonBody::seconds(const std::string& name) {
  const nlohmann::json* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_number() || !std::isfinite(value->get<double>()) || value->get<double>() < 0) {
    refuse_type(name, "a number of seconds");
  }
  return value->get<double>();
}

std::optional<bool> JsonBody::boolean(const std::string& name) {
  const nlohmann::json* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_boolean()) {
    refuse_type(name, "true or false");
  }
  return value->get<bool>();
}

std::optional<std::string> JsonBody::text(const std::string& name) {
  const nlohmann::json* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_string()) {
    refuse_type(name, "a string");
  }
  return value->get<std::string>();
}

void JsonBody::finish() const {
  for (const auto& [name, value] : object_->items()) {
    if (!asked_.contains(name)) {
      throw Refusal{422, fmt::format("unknown key '{}'; the keys are {}", printable(name),
                                     fmt::join(asked_, ", "))};
    }
  }
}

}  // namespace changeover::serve
