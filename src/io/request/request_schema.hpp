// What the records of a request are made into for other programs and for readers: a JSON Schema, and a table of doors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"

namespace changeover {

/// The records of a table, in their order.
template <typename Request>
std::vector<OptionRecord> records_of(const RequestTable<Request>& table) {
  std::vector<OptionRecord> records;
  for (const auto& option : table.options) {
    records.push_back(option.record);
  }
  return records;
}

/// A JSON Schema (draft 2020-12) of the documents of this format: types, words, and every rule between two keys.
[[nodiscard]] std::string request_schema(std::string_view format, std::string_view title,
                                         const std::vector<OptionRecord>& records,
                                         const std::vector<OptionRule>& rules);

/// A table in Markdown: a row for each key, with what it is called at each door; then why a door lacks one.
[[nodiscard]] std::string doors_table(const std::vector<OptionRecord>& records);

}  // namespace changeover
