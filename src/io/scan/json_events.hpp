// JSON as a sequence of events, each with the place where it begins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/design.hpp"
#include "io/scan/place.hpp"

namespace changeover {

struct JsonEvent {
  enum class Type : std::uint8_t {
    begin_object,
    end_object,
    begin_array,
    end_array,
    key,
    string,
    natural,
    other_number,
    boolean,
    null
  };
  Type type = Type::null;
  std::string_view text;      ///< of a key or string, decoded; of a number as written
  std::uint64_t natural = 0;  ///< value of a whole number that is not negative and fits
  std::size_t offset = 0;     ///< of its first byte
};

/// "an object", "a string", …
[[nodiscard]] std::string_view to_string(JsonEvent::Type type);

/// Receives the events of one document. Its exceptions pass through parse_json().
class JsonHandler {
 public:
  virtual ~JsonHandler() = default;
  virtual void on(const JsonEvent& event) = 0;

 protected:
  JsonHandler() = default;
  JsonHandler(const JsonHandler&) = default;
  JsonHandler& operator=(const JsonHandler&) = default;
};

inline constexpr std::size_t max_json_depth = 256;

/// A piece of JSON within a file.
struct JsonText {
  std::string_view text;
  const std::string& name;
  Place origin = {};  ///< of its first byte

  [[nodiscard]] Place place(std::size_t offset) const;
  [[noreturn]] void fail(std::size_t offset, std::string_view what) const {
    changeover::fail(name, place(offset), what);
  }
  /// @throws BadInput: something else than `wanted` is at the event.
  [[noreturn]] void fail_expecting(const JsonEvent& event, std::string_view wanted) const;
};

/// Parses one JSON value and nothing after it. Needs no stack for nesting.
/// @throws BadInput with line and column if it is not JSON or nests deeper than max_json_depth.
void parse_json(const JsonText& json, JsonHandler& handler);

/// The recipe in a piece of JSON. @throws BadInput
[[nodiscard]] Recipe recipe_at(std::string_view json, const std::string& name, Place origin);

// A small JSON document in memory, with places, and with numbers as written.

struct JsonMember;

struct JsonNode {
  JsonEvent::Type type = JsonEvent::Type::null;  ///< begin_object and begin_array for these
  std::string text;           ///< of a string, decoded; of a number or true and false as written
  std::uint64_t natural = 0;  ///< of a whole number
  std::size_t offset = 0;     ///< of its first byte
  std::vector<JsonMember> members;  ///< of an object; keys of an array are empty

  [[nodiscard]] bool is_object() const { return type == JsonEvent::Type::begin_object; }
  [[nodiscard]] bool is_array() const { return type == JsonEvent::Type::begin_array; }
  [[nodiscard]] bool is_null() const { return type == JsonEvent::Type::null; }
  [[nodiscard]] bool is_text() const { return type == JsonEvent::Type::string; }
  [[nodiscard]] bool is_natural() const { return type == JsonEvent::Type::natural; }
  [[nodiscard]] bool is_number() const {
    return is_natural() || type == JsonEvent::Type::other_number;
  }
  [[nodiscard]] const JsonNode* find(std::string_view key) const;
};

struct JsonMember {
  std::string key;
  JsonNode node;
};

/// Parses JSON. @throws BadInput with line and column if it is not JSON, nests deeper than
/// max_json_depth, or has a key twice.
[[nodiscard]] JsonNode json_tree(const JsonText& json);

}  // namespace changeover
