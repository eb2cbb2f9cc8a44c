// Requests as JSON documents, and their rules: what all kinds of requests share (io/request.hpp).
//
//     const RequestDocument document(job_table().format, text, "job.json");
//     JobRequest request = read_request(job_table(), document);
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/io/request.hpp"
#include "io/scan/json_events.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

/// A request as a JSON object, with the places of its parts for messages.
class RequestDocument {
 public:
  /// Parses `text`. `name` is that of the file; if it is empty, messages have no place. @throws
  /// BadInput unless it is a JSON object, of this format if it names one.
  RequestDocument(std::string_view format, std::string text, std::string name,
                  Door door = Door::document);

  [[nodiscard]] const JsonNode& object() const { return object_; }
  /// The value of a key; nothing if it is missing or null.
  [[nodiscard]] const JsonNode* find(std::string_view key) const;
  /// Takes `from` as another name of the key `to`, by which messages go on to call it. Both are
  /// literals.
  void rename(std::string_view from, std::string_view to);
  [[noreturn]] void fail(const JsonNode& at, std::string_view key, std::string_view what) const;

  /// @throws BadInput for a member that is not one of the keys, in a line that names those that are
  /// taken here.
  void require_known(const std::vector<std::string_view>& keys,
                     const std::vector<std::string_view>& taken) const;

  /// Messages do not name keys that the server does not take.
  void for_server() { is_for_server_ = true; }
  [[nodiscard]] bool is_for_server() const { return is_for_server_; }

  [[nodiscard]] std::uint64_t number(const OptionRecord& record, const JsonNode& node) const;
  [[nodiscard]] double seconds(const OptionRecord& record, const JsonNode& node) const;
  [[nodiscard]] bool flag(const OptionRecord& record, const JsonNode& node) const;
  /// The text of an amount, a text or a word.
  [[nodiscard]] std::string text(const OptionRecord& record, const JsonNode& node) const;
  [[nodiscard]] std::vector<std::string> names(const OptionRecord& record,
                                               const JsonNode& node) const;
  [[nodiscard]] RequestList list(const OptionRecord& record, const JsonNode& node) const;

  /// Where it has its values; nothing without a name.
  [[nodiscard]] RequestPlaces places() const;

 private:
  std::shared_ptr<const std::string> text_;
  std::string name_;
  Door door_;
  JsonNode object_;
  std::pair<std::string_view, std::string_view> renamed_;  // from, to
  bool is_for_server_ = false;
};

/// The value as JSON.
void write_list(JsonWriter& json, const OptionRecord& record, const RequestList& list);

/// A list as an input for the readers of its file: `spelled` names it in messages if it has no
/// file. @throws as open_list()
[[nodiscard]] std::unique_ptr<Input> open(const RequestList& list, const OptionRecord& record,
                                          const std::string& spelled);

/// The names in a text with commas between them; they may be quoted. @throws BadInput (without a
/// place)
[[nodiscard]] std::vector<std::string> names_in(std::string_view text);

/// Whether a key of a request is given.
template <typename Request>
bool is_given(const Request& request, const RequestOption<Request>& option) {
  return std::visit(
      [&](auto field) {
        const auto& value = request.*field;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>) {
          return value;
        } else if constexpr (std::is_same_v<Value, RequestList>) {
          return value.is_given();
        } else if constexpr (requires { value.has_value(); }) {
          return value.has_value();
        } else {
          return !value.empty();
        }
      },
      option.field);
}

/// The value that stands with a key of a rule, "3" of "strength=3"; or nothing.
[[nodiscard]] inline std::string_view value_in(std::string_view key) {
  return key.substr(std::min(key.find('='), key.size() - 1) + 1);
}

/// The option of a key, which may stand with a value (OptionRule).
template <typename Request>
const RequestOption<Request>& option_of(const RequestTable<Request>& table, std::string_view key) {
  key = key.substr(0, key.find('='));
  for (const auto& option : table.options) {
    if (option.record.key == key) {
      return option;
    }
  }
  throw InternalError("no option has the key " + std::string(key));
}

/// The same for a key that may stand with a value (OptionRule).
template <typename Request>
bool is_given(const RequestTable<Request>& table, const Request& request, std::string_view key) {
  const auto& option = option_of(table, key);
  const std::string_view wanted = value_in(key);
  return wanted.empty() ? is_given(request, option)
                        : std::visit(
                              [&](auto field) {
                                const auto& value = request.*field;
                                if constexpr (requires { value == wanted; }) {
                                  return value == wanted;
                                } else if constexpr (requires { std::to_string(*value); }) {
                                  return value && std::to_string(*value) == wanted;
                                } else {
                                  return false;
                                }
                              },
                              option.field);
}

/// Reads a request. @throws BadInput for keys that are not in the table, or values of another kind.
template <typename Request>
Request read_request(const RequestTable<Request>& table, const RequestDocument& document) {
  Request request;
  std::vector<std::string_view> keys;
  std::vector<std::string_view> taken;
  for (const auto& option : table.options) {
    const OptionRecord& record = option.record;
    keys.push_back(record.key);
    if (record.not_in_server.empty() || !document.is_for_server()) {
      taken.push_back(record.key);
    }
    const JsonNode* const node = document.find(record.key);
    if (node == nullptr) {
      continue;
    }
    std::visit(
        [&](auto field) {
          auto& value = request.*field;
          using Value = std::remove_cvref_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, bool>) {
            value = document.flag(record, *node);
          } else if constexpr (std::is_same_v<Value, RequestList>) {
            value = document.list(record, *node);
          } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>>) {
            value = document.number(record, *node);
          } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
            value = document.seconds(record, *node);
          } else if constexpr (std::is_same_v<Value, std::string>) {
            value = document.text(record, *node);
          } else {
            value = document.names(record, *node);
          }
        },
        option.field);
  }
  document.require_known(keys, taken);
  request.places = document.places();
  return request;
}

/// The given keys as JSON, with the format first; read_request() reads it back.
template <typename Request>
std::string request_as_json(const RequestTable<Request>& table, const Request& request) {
  JsonWriter json;
  json.begin_object().key("format").value(table.format);
  for (const auto& option : table.options) {
    if (!is_given(request, option)) {
      continue;
    }
    json.key(option.record.key);
    std::visit(
        [&](auto field) {
          const auto& value = request.*field;
          using Value = std::remove_cvref_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, RequestList>) {
            write_list(json, option.record, value);
          } else {
            json.value(value);
          }
        },
        option.field);
  }
  return json.end_object().take() + "\n";
}

/// Takes the keys that `request` does not give from `other`.
template <typename Request>
void complete(const RequestTable<Request>& table, Request& request, Request other) {
  if constexpr (requires { request.items_are_parts; }) {
    request.items_are_parts = request.items ? request.items_are_parts : other.items_are_parts;
  }
  RequestPlaces places = std::move(other.places);
  for (const auto& option : table.options) {
    if (is_given(request, option)) {
      places.offsets.erase(std::string(option.record.key));
    } else {
      std::visit([&](auto field) { request.*field = std::move(other.*field); }, option.field);
    }
  }
  if (request.places.name.empty()) {
    request.places = std::move(places);
  }
}

}  // namespace changeover
