// Rows of lists in requests, as JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"
#include "io/scan/json_events.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

/// The keys of the rows of such a list, where these are objects with fields: of parts, slots and
/// benches.
[[nodiscard]] const std::vector<std::string_view>& row_keys(RowShape shape);

/// What a row of such a list is, for messages.
[[nodiscard]] std::string_view words_of_rows(RowShape shape);

/// The fields of an array; nothing if one of them is none.
[[nodiscard]] std::optional<std::vector<std::string>> fields_of(const JsonNode& array);

/// A row; nothing if the node is none of this shape.
[[nodiscard]] std::optional<ListRow> row_of(RowShape shape, const JsonNode& node);

/// Writes a row as an object with these keys.
void write_members(JsonWriter& json, const ListRow& row, const std::vector<std::string_view>& keys);

/// Writes a bench as an object.
void write_bench_row(JsonWriter& json, const ListRow& row);

}  // namespace changeover
