// JSON as a sequence of events, each with the place where it begins.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "changeover/core/recipe.hpp"
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

}  // namespace changeover
