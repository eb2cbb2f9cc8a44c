// Makes a JSON Schema and the table of docs/doors.md from the records of a request.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"
#include "core/each.hpp"

namespace changeover {

/// The records of a table, in their order.
template <typename Request>
std::vector<OptionRecord> records_of(const RequestTable<Request>& table) {
  return each_of<OptionRecord>(table.options, [&](const auto& option) { return option.record; });
}

/// A JSON Schema (draft 2020-12) of the documents of this format: types, words, and every rule
/// between two keys.
[[nodiscard]] std::string request_schema(std::string_view format, std::string_view title,
                                         const std::vector<OptionRecord>& records,
                                         const std::vector<OptionRule>& rules);

/// A table in Markdown: a row for each key, with its names on the command line, at the server and
/// in Python; then why it is missing where it is.
[[nodiscard]] std::string doors_table(const std::vector<OptionRecord>& records);

}  // namespace changeover
