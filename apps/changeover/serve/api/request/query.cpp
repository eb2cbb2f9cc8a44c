#include "serve/api/request/query.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "cli/cli.hpp"
#include "core/each.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "io/write/json_writer.hpp"
#include "request/parameters.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {
namespace {

// What is quoted in a message is short.
std::string shown(const std::string& value) {
  constexpr std::size_t most = 40;
  return printable(value.size() > most ? value.substr(0, most) + "…" : value);
}

Parameters parameters_of(const Request& request, Kind kind) {
  const Parameters p{.v = needed_number(request, "v"),
                     .k = needed_number(request, "k"),
                     .change = number_of(request, "change").value_or(2),
                     .kind = kind,
                     .strength = strength_of(request)};
  check(p);
  return p;
}

}  // namespace

Refusal malformed(const std::string& message) {
  Refusal refusal{422, message};
  constexpr std::string_view name = name_of_body;
  if (!message.starts_with(name)) {
    return refusal;
  }
  refusal.message = message.substr(name.size());
  std::uint64_t line = 0;
  std::uint64_t column = 0;
  const char* const end = message.data() + message.size();
  const char* at = message.data() + name.size();
  const auto number = [&](std::uint64_t& value) {
    if (at == end || *at != ':') {
      return false;
    }
    const auto [rest, failure] = std::from_chars(at + 1, end, value);
    at = rest;
    return failure == std::errc();
  };
  if (number(line) && number(column)) {
    refusal.line = line;
    refusal.column = column;
    refusal.message = std::string(at, end);
  }
  refusal.message.erase(0, refusal.message.find_first_not_of(": "));
  return refusal;
}

std::optional<std::uint64_t> number_of(const Request& request, std::string_view name) {
  const auto text = request.parameter(name);
  if (!text) {
    return std::nullopt;
  }
  const auto value = parsed<std::uint64_t>(*text);
  if (!value) {
    throw Refusal{400, fmt::format("{}={}: write a whole number", name, shown(*text))};
  }
  return value;
}

std::uint64_t needed_number(const Request& request, std::string_view name) {
  const auto number = number_of(request, name);
  if (!number) {
    throw Refusal{400, fmt::format("{} is missing; write {}=N", name, name)};
  }
  return *number;
}

std::string word_of(const Request& request, std::string_view name,
                    const std::vector<std::string>& words) {
  const auto word = request.parameter(name);
  if (word && std::ranges::find(words, *word) == words.end()) {
    throw Refusal{400, fmt::format("{}={}: write {}", name, shown(*word), fmt::join(words, ", "))};
  }
  return word.value_or(words.front());
}

std::optional<Kind> kind_of(const Request& request) {
  const auto word = request.parameter("kind");
  if (!word) {
    return std::nullopt;
  }
  const auto kind = kind_from_string(*word);
  if (!kind) {
    throw Refusal{400, fmt::format("kind={}: write circular or linear", shown(*word))};
  }
  return kind;
}

Kind needed_kind(const Request& request) {
  const auto kind = kind_of(request);
  if (!kind) {
    throw Refusal{400, "kind is missing; write kind=circular or kind=linear"};
  }
  return *kind;
}

std::uint32_t strength_of(const Request& request) {
  const std::uint64_t strength = number_of(request, "strength").value_or(2);
  if (strength < 2 || strength > max_strength) {
    throw Refusal{400, fmt::format("strength={}: give 2 to {}", strength, max_strength)};
  }
  return static_cast<std::uint32_t>(strength);
}

Parameters cell_of(const Request& request) { return parameters_of(request, needed_kind(request)); }

std::vector<Parameters> cells_of(const Request& request) {
  return each_of<Parameters>(cli::kinds_of(kind_of(request)),
                             [&](const Kind kind) { return parameters_of(request, kind); });
}

cli::Range range_of(const Request& request, std::string_view name, const cli::Range& usual) {
  const auto text = request.parameter(name);
  if (!text) {
    return usual;
  }
  try {
    return cli::range_of(std::string(name) + ":", shown(*text), 2);
  } catch (const cli::UsageError& fault) {
    throw Refusal{400, fault.message};
  }
}

namespace {

[[noreturn]] void refuse_type(const std::string& name, std::string_view wanted) {
  throw Refusal{422, fmt::format("{}: write {}", name, wanted)};
}

}  // namespace

JsonBody::JsonBody(const std::string& text)
    : JsonBody(json_tree({.text = text, .name = "<text>"})) {}

JsonBody::JsonBody(JsonNode object) : object_(std::move(object)) {
  if (!object_.is_object()) {
    throw Refusal{422, "give an object of JSON, {…}"};
  }
}

const JsonNode* JsonBody::find(const std::string& name) {
  asked_.insert(name);
  const JsonNode* const found = object_.find(name);
  return found == nullptr || found->is_null() ? nullptr : found;
}

const JsonNode* JsonBody::find_of_type(const std::string& name, JsonEvent::Type type,
                                       std::string_view what) {
  const JsonNode* const value = find(name);
  if (value != nullptr && value->type != type) {
    refuse_type(name, what);
  }
  return value;
}

std::optional<std::uint64_t> JsonBody::number(const std::string& name) {
  const JsonNode* const value = find_of_type(name, JsonEvent::Type::natural, "a whole number");
  return value == nullptr ? std::nullopt : std::optional(value->natural);
}

std::uint64_t JsonBody::needed_number(const std::string& name) {
  const auto value = number(name);
  if (!value) {
    throw Refusal{422, name + " is missing; add it"};
  }
  return *value;
}

std::optional<double> JsonBody::seconds(const std::string& name) {
  const JsonNode* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  double number = -1;
  if (value->is_number()) {
    std::from_chars(value->text.data(), value->text.data() + value->text.size(), number);
  }
  if (!std::isfinite(number) || number < 0) {
    refuse_type(name, "a number of seconds");
  }
  return number;
}

std::optional<bool> JsonBody::boolean(const std::string& name) {
  const JsonNode* const value = find_of_type(name, JsonEvent::Type::boolean, "true or false");
  return value == nullptr ? std::nullopt : std::optional(value->text == "true");
}

std::optional<std::string> JsonBody::text(const std::string& name) {
  const JsonNode* const value = find_of_type(name, JsonEvent::Type::string, "a string");
  return value == nullptr ? std::nullopt : std::optional(value->text);
}

void JsonBody::finish() const {
  for (const auto& [name, value] : object_.members) {
    if (!asked_.contains(name)) {
      throw Refusal{422, fmt::format("unknown key '{}'; the keys are {}", printable(name),
                                     fmt::join(asked_, ", "))};
    }
  }
}

namespace {

void append(std::string& out, const JsonNode& node) {
  if (node.is_object() || node.is_array()) {
    out += node.is_object() ? '{' : '[';
    for (std::size_t i = 0; i < node.members.size(); ++i) {
      out += i == 0 ? "" : ",";
      if (node.is_object()) {
        append_json_string(out, node.members[i].key);
        out += ':';
      }
      append(out, node.members[i].node);
    }
    out += node.is_object() ? '}' : ']';
  } else if (node.is_text()) {
    append_json_string(out, node.text);
  } else {
    out += node.is_null() ? "null" : node.text;
  }
}

}  // namespace

std::string json_text(const JsonNode& node) {
  std::string text;
  append(text, node);
  return text;
}

}  // namespace changeover::serve
