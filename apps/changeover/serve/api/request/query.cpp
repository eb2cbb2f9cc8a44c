#include "serve/api/request/query.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "cli/cli.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "io/scan/json_events.hpp"
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
  const std::uint64_t strength = number_of(request, "strength").value_or(2);
  if (strength < 2 || strength > max_strength) {
    throw Refusal{400, fmt::format("strength={}: give 2 to {}", strength, max_strength)};
  }
  const Parameters p{.v = needed_number(request, "v"),
                     .k = needed_number(request, "k"),
                     .change = number_of(request, "change").value_or(2),
                     .kind = kind,
                     .strength = static_cast<std::uint32_t>(strength)};
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

Parameters cell_of(const Request& request) {
  const auto kind = kind_of(request);
  if (!kind) {
    throw Refusal{400, "kind is missing; write kind=circular or kind=linear"};
  }
  return parameters_of(request, *kind);
}

std::vector<Parameters> cells_of(const Request& request) {
  std::vector<Parameters> cells;
  for (const Kind kind : cli::kinds_of(kind_of(request))) {
    cells.push_back(parameters_of(request, kind));
  }
  return cells;
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

template <typename Value, typename Fits>
std::optional<Value> JsonBody::read(const std::string& name, std::string_view what, Fits&& fits) {
  const nlohmann::json* const value = find(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!fits(*value)) {
    refuse_type(name, what);
  }
  return value->get<Value>();
}

std::optional<std::uint64_t> JsonBody::number(const std::string& name) {
  return read<std::uint64_t>(name, "a whole number",
                             [](const auto& value) { return value.is_number_unsigned(); });
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
  return read<double>(name, "a number of seconds", [](const auto& value) {
    return value.is_number() && std::isfinite(value.template get<double>()) &&
           value.template get<double>() >= 0;
  });
}

std::optional<bool> JsonBody::boolean(const std::string& name) {
  return read<bool>(name, "true or false", [](const auto& value) { return value.is_boolean(); });
}

std::optional<std::string> JsonBody::text(const std::string& name) {
  return read<std::string>(name, "a string", [](const auto& value) { return value.is_string(); });
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
