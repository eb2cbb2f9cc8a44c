#include "io/request/request_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/request/request_document.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {
namespace {

// A field of a row: a text, or a number as written; null stands for an empty field.
std::optional<std::string> field_of(const JsonNode& node) {
  return node.is_text() || node.is_number() ? std::optional(node.text)
         : node.is_null()                   ? std::optional(std::string())
                                            : std::nullopt;
}

// Members of an object in an order, each a field; the first must be there and no other may be.
std::optional<std::vector<std::string>> members_of(const JsonNode& object,
                                                   const std::vector<std::string_view>& keys) {
  std::vector<std::string> fields(keys.size());
  for (const auto& [key, node] : object.members) {
    const auto at = std::ranges::find(keys, key);
    const auto field = field_of(node);
    if (at == keys.end() || !field) {
      return std::nullopt;
    }
    fields[static_cast<std::size_t>(at - keys.begin())] = *field;
  }
  const JsonNode* const first = object.find(keys.front());
  return first != nullptr && !first->is_null() ? std::optional(fields) : std::nullopt;
}

// The parts of a set-up, and beside them its result, if that may be, and its bench.
std::optional<ListRow> setup_of(const JsonNode& node, bool has_result) {
  if (!node.is_object()) {
    auto fields = fields_of(node);
    return fields ? std::optional(ListRow{std::move(*fields)}) : std::nullopt;
  }
  ListRow row;
  bool has_parts = false;
  for (const auto& [key, member] : node.members) {
    if (key == "parts") {
      auto fields = fields_of(member);
      if (!fields) {
        return std::nullopt;
      }
      row.fields = std::move(*fields);
      has_parts = true;
    } else if (key == "result" && has_result && (member.is_text() || member.is_null())) {
      row.result = member.is_text() ? member.text : "";
    } else if (const auto bench = field_of(member); key == "bench" && bench) {
      row.bench = *bench;
    } else {
      return std::nullopt;
    }
  }
  return has_parts ? std::optional(row) : std::nullopt;
}

// What a bench says under a key, as a field of a row: parts with commas between them, slots as
// CPU=1,disk=2..4.
std::optional<std::string> bench_field(const JsonNode& node) {
  if (node.type == JsonEvent::Type::boolean) {
    return node.text == "true" ? "yes" : "no";
  }
  if (!node.is_array()) {
    return field_of(node);
  }
  std::string text;
  for (const auto& [none, member] : node.members) {
    auto field = field_of(member);
    if (member.is_object()) {
      const auto slot = members_of(member, row_keys(RowShape::slots));
      field = slot ? std::optional(fmt::format("{}={}..{}", (*slot)[0], (*slot)[1], (*slot)[2]))
                   : std::nullopt;
    }
    if (!field || field->empty()) {
      return std::nullopt;
    }
    text += (text.empty() ? "" : ", ") + quoted_field(*field);
  }
  return text.empty() ? "," : text;  // no parts, which is more than saying nothing
}

std::optional<ListRow> bench_of(const JsonNode& node) {
  const std::vector<std::string_view>& keys = row_keys(RowShape::benches);
  ListRow row;
  row.fields.resize(keys.size());
  if (!node.is_object()) {
    row.fields.front() = node.is_text() ? node.text : "";
    return node.is_text() ? std::optional(row) : std::nullopt;
  }
  for (const auto& [key, member] : node.members) {
    const auto at = std::ranges::find(keys, key);
    const auto field = bench_field(member);
    if (at == keys.end() || !field) {
      return std::nullopt;
    }
    row.fields[static_cast<std::size_t>(at - keys.begin())] = *field;
  }
  return row;
}

bool is_one_of_parts(std::string_view key) {
  constexpr std::array<std::string_view, 4> all{"mounted", "start", "own", "without"};
  return std::ranges::find(all, key) != all.end();
}

// Writes a number as one if it has JSON's form; else as a text.
void write_field(JsonWriter& json, const std::string& field) {
  const bool plain = !field.empty() && field.find_first_not_of("0123456789") == std::string::npos &&
                     (field.front() != '0' || field.size() == 1) && field.size() < 19;
  plain ? json.raw(field) : json.value(field);
}

}  // namespace

std::optional<std::vector<std::string>> fields_of(const JsonNode& array) {
  if (!array.is_array()) {
    return std::nullopt;
  }
  std::vector<std::string> fields;
  for (const auto& [none, node] : array.members) {
    auto field = field_of(node);
    if (!field) {
      return std::nullopt;
    }
    fields.push_back(std::move(*field));
  }
  return fields;
}

const std::vector<std::string_view>& row_keys(RowShape shape) {
  static const std::vector<std::string_view> parts{"name", "cost", "slot", "quantity"};
  static const std::vector<std::string_view> slots{"name", "least", "most"};
  static const std::vector<std::string_view> benches{
      "name",  "at_once", "test_cost", "change_factor", "slots", "mounted",
      "start", "own",     "without",   "hours",         "down"};
  return shape == RowShape::parts ? parts : shape == RowShape::slots ? slots : benches;
}

std::string_view words_of_rows(RowShape shape) {
  switch (shape) {
    case RowShape::parts:
      return "\"name\" or {\"name\":…,\"cost\":…,\"slot\":…,\"quantity\":…}";
    case RowShape::pairs:
      return "[a,b]";
    case RowShape::sizes:
      return "[item,bytes], or bytes alone";
    case RowShape::costs:
      return "[a,b] or [a,b,cost]";
    case RowShape::groups:
      return "[a,b,…]";
    case RowShape::reasons:
      return "[a,b] or [a,b,why]";
    case RowShape::weights:
      return "[a,b,weight]";
    case RowShape::slots:
      return "{\"name\":…,\"least\":…,\"most\":…}";
    case RowShape::setups:
      return "[a,b,…], or {\"parts\":[…],\"bench\":…}";
    case RowShape::tests:
      return "[\"a\",\"b\",…] or {\"parts\":[…],\"result\":\"pass\" or \"fail\",\"bench\":…}";
    case RowShape::benches:
      return "\"name\" or {\"name\":…,\"start\":[…],\"hours\":…,…}";
    case RowShape::table:
      return "[field,…]";
    case RowShape::document:
    case RowShape::none:
      break;
  }
  return "";
}

std::optional<ListRow> row_of(RowShape shape, const JsonNode& node) {
  switch (shape) {
    case RowShape::parts:
    case RowShape::slots: {
      if (shape == RowShape::parts && node.is_text()) {
        return ListRow{{node.text}};
      }
      auto fields = node.is_object() ? members_of(node, row_keys(shape)) : std::nullopt;
      if (constexpr std::size_t without_quantity = 3; fields && fields->back().empty()) {
        fields->resize(without_quantity);
      }
      return fields ? std::optional(ListRow{std::move(*fields)}) : std::nullopt;
    }
    case RowShape::benches:
      return bench_of(node);
    case RowShape::tests:
      return setup_of(node, true);
    case RowShape::setups: {
      auto row = setup_of(node, false);
      return row && !row->fields.empty() ? row : std::nullopt;
    }
    case RowShape::sizes:
      if (node.is_text() || node.is_number()) {
        return ListRow{{node.text}};
      }
      [[fallthrough]];
    default: {
      auto fields = fields_of(node);
      const std::size_t size = fields ? fields->size() : 0;
      const bool two = shape == RowShape::pairs || shape == RowShape::sizes;
      const bool two_or_three = shape == RowShape::reasons || shape == RowShape::costs;
      const bool fits = two                          ? size == 2
                        : two_or_three               ? size == 2 || size == 3
                        : shape == RowShape::weights ? size == 3
                                                     : size > 0;
      return fits ? std::optional(ListRow{std::move(*fields)}) : std::nullopt;
    }
  }
}

void write_members(JsonWriter& json, const ListRow& row,
                   const std::vector<std::string_view>& keys) {
  json.begin_object().key(keys[0]).value(row.fields[0]);
  for (std::size_t i = 1; i < row.fields.size() && i < keys.size(); ++i) {
    if (!row.fields[i].empty()) {
      json.key(keys[i]);
      keys[i] == "slot" ? json.value(row.fields[i]), void() : write_field(json, row.fields[i]);
    }
  }
  json.end_object();
}

void write_bench_row(JsonWriter& json, const ListRow& row) {
  const std::vector<std::string_view>& keys = row_keys(RowShape::benches);
  json.begin_object();
  for (std::size_t i = 0; i < keys.size() && i < row.fields.size(); ++i) {
    const std::string& field = row.fields[i];
    if (field.empty()) {
      continue;
    }
    json.key(keys[i]);
    if (is_one_of_parts(keys[i])) {
      json.value(names_in(field));
    } else if (keys[i] == "down" && (field == "yes" || field == "no")) {
      json.value(field == "yes");
    } else if (keys[i] == "at_once") {
      write_field(json, field);
    } else {
      json.value(field);
    }
  }
  json.end_object();
}

}  // namespace changeover
