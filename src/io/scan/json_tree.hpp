// A small JSON document in memory, with places, and with numbers as written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/scan/json_events.hpp"

namespace changeover {

struct JsonNode {
  JsonEvent::Type type = JsonEvent::Type::null;  ///< begin_object and begin_array for these
  std::string text;           ///< of a string, decoded; of a number or true and false as written
  std::uint64_t natural = 0;  ///< of a whole number
  std::size_t offset = 0;     ///< of its first byte
  std::vector<std::pair<std::string, JsonNode>>
      members;  ///< of an object; keys of an array are empty

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

/// Parses JSON. @throws BadInput with line and column if it is not JSON, nests deeper than
/// max_json_depth, or has a key twice.
[[nodiscard]] JsonNode json_tree(const JsonText& json);

}  // namespace changeover
