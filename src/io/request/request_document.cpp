#include "io/request/request_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/printable.hpp"
#include "io/request/request_rows.hpp"
#include "io/scan/base64.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover {
namespace {

// Rows of set-ups as a run sheet has them, so that no name of a part is taken for one of its
// columns.
GivenRows::Fields sheet_header(std::size_t parts) {
  GivenRows::Fields header{"step", "take_out", "put_in", "cost_so_far", "result", "bench"};
  for (std::size_t i = 0; i < std::max<std::size_t>(1, parts); ++i) {
    header.push_back(fmt::format("slot_{}", i + 1));
  }
  return header;
}

}  // namespace

RequestDocument::RequestDocument(std::string_view format, std::string text, std::string name,
                                 Door door)
    : text_(std::make_shared<const std::string>(std::move(text))),
      name_(std::move(name)),
      door_(door) {
  const std::string shown_name = name_.empty() ? "<text>" : name_;
  object_ = json_tree({.text = *text_, .name = shown_name});
  if (!object_.is_object()) {
    throw BadInput((name_.empty() ? "" : name_ + ": ") + "give an object of JSON, {…}");
  }
  if (const JsonNode* const said = find("format"); said != nullptr && said->text != format) {
    fail(*said, "format", fmt::format("write {}", format));
  }
}

const JsonNode* RequestDocument::find(std::string_view key) const {
  const JsonNode* const found = object_.find(key);
  return found == nullptr || found->is_null() ? nullptr : found;
}

void RequestDocument::rename(std::string_view from, std::string_view to) {
  for (auto& [key, node] : object_.members) {
    if (key == from) {
      if (const JsonNode* const other = find(to)) {
        fail(*other, to, fmt::format("{} means the same; give one of them", from));
      }
      key = to;
      renamed_ = {from, to};
      return;
    }
  }
}

void RequestDocument::fail(const JsonNode& at, std::string_view key, std::string_view what) const {
  const std::string_view written = key == renamed_.second ? renamed_.first : key;
  const std::string line =
      written.empty() ? std::string(what) : fmt::format("{}: {}", written, what);
  if (name_.empty()) {
    throw BadInput(line);
  }
  changeover::fail(name_, place_of(*text_, at.offset), line);
}

RequestPlaces RequestDocument::places() const {
  if (name_.empty()) {
    return {};
  }
  RequestPlaces places{.name = name_, .text = text_, .offsets = {{"", {object_.offset}}}};
  for (const auto& [key, node] : object_.members) {
    std::vector<std::size_t>& offsets = places.offsets[key];
    offsets.push_back(node.offset);
    for (const auto& [none, row] : node.members) {
      offsets.push_back(row.offset);
    }
  }
  return places;
}

void RequestDocument::require_known(const std::vector<std::string_view>& keys,
                                    const std::vector<std::string_view>& taken) const {
  for (const auto& [key, node] : object_.members) {
    if (key != "format" && std::ranges::find(keys, key) == keys.end()) {
      fail(
          node, "",
          fmt::format("unknown key '{}'; the keys are {}", printable(key), fmt::join(taken, ", ")));
    }
  }
}

// The value of a key as a message quotes it; an object or an array is not quoted.
static std::string quoted(const JsonNode& node) {
  return node.text.empty() ? "this" : shown(node.text);
}

std::uint64_t RequestDocument::number(const OptionRecord& record, const JsonNode& node) const {
  if (!node.is_natural()) {
    fail(node, record.key,
         fmt::format("write a whole number from 0 to 2^64 - 1, not {}", quoted(node)));
  }
  return node.natural;
}

double RequestDocument::seconds(const OptionRecord& record, const JsonNode& node) const {
  double number = -1;
  if (node.is_number()) {
    std::from_chars(node.text.data(), node.text.data() + node.text.size(), number);
  }
  if (!std::isfinite(number) || number < 0) {
    fail(node, spelled(record, door_), "write a number of seconds");
  }
  if (number > most_seconds) {
    fail(node, spelled(record, door_), fmt::format("write at most {} seconds", most_seconds));
  }
  return number;
}

bool RequestDocument::flag(const OptionRecord& record, const JsonNode& node) const {
  if (node.type != JsonEvent::Type::boolean) {
    fail(node, record.key, "write true or false");
  }
  return node.text == "true";
}

std::string RequestDocument::text(const OptionRecord& record, const JsonNode& node) const {
  const bool is_amount = record.kind == ValueKind::amount;
  if (!node.is_text() && !(is_amount && node.is_number())) {
    fail(node, record.key,
         is_amount ? fmt::format("{} is not an amount; write one, as 12.50", quoted(node))
                   : fmt::format("{} is not a string; put it in quotes", quoted(node)));
  }
  if (is_amount && node.text.empty()) {
    fail(node, record.key, "it is empty; write an amount, as 12.50, or leave it out");
  }
  if (record.kind == ValueKind::word &&
      std::ranges::find(record.words, node.text) == record.words.end()) {
    fail(node, record.key, fmt::format("write one of {}", fmt::join(record.words, ", ")));
  }
  return node.text;
}

std::vector<std::string> RequestDocument::names(const OptionRecord& record,
                                                const JsonNode& node) const {
  auto fields = fields_of(node);
  if (!fields) {
    fail(node, record.key, "write an array of names, [a,b,…]");
  }
  return std::move(*fields);
}

RequestList RequestDocument::list(const OptionRecord& record, const JsonNode& node) const {
  RequestList list;
  const bool is_document = record.shape == RowShape::document;
  const std::string what =
      is_document
          ? std::string(R"(write a string, or {"file":…} or {"text":…})")
          : fmt::format(
                R"(write an array of {}, or {{"file":…}}, {{"text":…}} or {{"workbook":…}})",
                words_of_rows(record.shape));
  if (is_document && node.is_text()) {
    list.text = node.text;
    return list;
  }
  if (node.is_object()) {
    const auto& members = node.members;
    const bool one = members.size() == 1 && members.front().node.is_text();
    if (one && members.front().key == "file" && !members.front().node.text.empty()) {
      list.file = members.front().node.text;
    } else if (one && members.front().key == "text") {
      list.text = members.front().node.text;
    } else if (const JsonNode* const book = node.find("workbook");
               book != nullptr && book->is_text() && !is_document) {
      list.workbook = from_base64(book->text);
      const JsonNode* const sheet = node.find("sheet");
      list.sheet = sheet == nullptr ? "" : sheet->text;
      if (!list.workbook || list.workbook->empty() || (sheet != nullptr && !sheet->is_text()) ||
          members.size() != (sheet == nullptr ? 1U : 2U)) {
        fail(
            node, record.key,
            "write {\"workbook\":the bytes of an .xlsx file in base64}, and \"sheet\" if it is not "
            "the first");
      }
    } else {
      fail(node, record.key, what);
    }
    return list;
  }
  if (record.shape == RowShape::benches && node.is_number()) {
    list.number = number(record, node);
    return list;
  }
  if (!node.is_array() || is_document) {
    fail(node, record.key, what);
  }
  list.rows.emplace();
  for (const auto& [none, member] : node.members) {
    auto row = row_of(record.shape, member);
    if (!row) {
      fail(member, fmt::format("{}[{}]", record.key, list.rows->size()),
           fmt::format("write {}", words_of_rows(record.shape)));
    }
    list.rows->push_back(std::move(*row));
  }
  return list;
}

void write_list(JsonWriter& json, const OptionRecord& record, const RequestList& list) {
  if (!list.file.empty()) {
    json.begin_object().key("file").value(list.file).end_object();
    return;
  }
  if (list.text && record.shape == RowShape::document) {
    json.value(*list.text);
    return;
  }
  if (list.text) {
    json.begin_object().key("text").value(*list.text).end_object();
    return;
  }
  if (list.workbook) {
    json.begin_object().key("workbook").value(base64_of(*list.workbook));
    if (!list.sheet.empty()) {
      json.key("sheet").value(list.sheet);
    }
    json.end_object();
    return;
  }
  if (list.number) {
    json.value(*list.number);
    return;
  }
  json.list(*list.rows, [&](const ListRow& row) {
    switch (record.shape) {
      case RowShape::parts:
      case RowShape::slots:
        write_members(json, row, row_keys(record.shape));
        break;
      case RowShape::benches:
        write_bench_row(json, row);
        break;
      case RowShape::setups:
      case RowShape::tests:
        if (row.result || !row.bench.empty()) {
          json.begin_object().key("parts").value(row.fields);
          if (row.result) {
            json.key("result").value(*row.result);
          }
          if (!row.bench.empty()) {
            json.key("bench").value(row.bench);
          }
          json.end_object();
          break;
        }
        [[fallthrough]];
      case RowShape::sizes:
        if (row.fields.size() == 1) {
          json.value(row.fields.front());
          break;
        }
        [[fallthrough]];
      default:
        json.value(row.fields);
    }
  });
}

std::unique_ptr<Input> open(const RequestList& list, const OptionRecord& record,
                            const std::string& spelled) {
  if (!list.file.empty()) {
    if (record.shape == RowShape::document) {
      return open_input(list.file);
    }
    return open_list(list.file);
  }
  if (list.text) {
    return input_from_text(*list.text, list.name.empty() ? spelled : list.name);
  }
  if (list.workbook) {
    auto bytes = input_from_text(*list.workbook, spelled);
    if (list.sheet.empty()) {
      return bytes;
    }
    return std::make_unique<SheetInput>(std::move(bytes), list.sheet);
  }
  GivenRows::Fields header;
  std::vector<GivenRows::Fields> rows;
  std::vector<bool> says_nothing;  // by column after the first two
  std::size_t widest = 0;
  for (const ListRow& row : *list.rows) {
    widest = std::max(widest, row.fields.size());
  }
  // Benches of set-ups that come first have a column, too; without them rows are set-ups as they
  // stand.
  const bool has_benches =
      std::ranges::any_of(*list.rows, [](const ListRow& row) { return !row.bench.empty(); });
  const bool as_sheet =
      record.shape == RowShape::tests || (record.shape == RowShape::setups && has_benches);
  if (record.shape == RowShape::parts) {
    header = {"name", "change cost", "slot", "quantity"};
    header.resize(std::clamp<std::size_t>(widest, 1, header.size()));
    // A column for slots or quantities would say that parts have some.
    for (std::size_t column = header.size(); column-- > 2;) {
      says_nothing.push_back(std::ranges::none_of(*list.rows, [&](const ListRow& row) {
        return column < row.fields.size() && !row.fields[column].empty();
      }));
    }
    std::reverse(says_nothing.begin(), says_nothing.end());
  } else if (record.shape == RowShape::benches) {
    const std::vector<std::string_view>& keys = row_keys(record.shape);
    header.assign(keys.begin(), keys.end());
  } else if (as_sheet) {
    header = sheet_header(widest);
  }
  for (const ListRow& row : *list.rows) {
    GivenRows::Fields& fields = rows.emplace_back();
    if (as_sheet) {
      fields = {"", "", "", "", row.result.value_or("done"), row.bench};
    }
    fields.insert(fields.end(), row.fields.begin(), row.fields.end());
    if (!header.empty()) {
      fields.resize(header.size());
    }
  }
  for (std::size_t column = 2 + says_nothing.size(); column-- > 2;) {
    if (says_nothing[column - 2]) {
      const auto at = static_cast<std::ptrdiff_t>(column);
      header.erase(header.begin() + at);
      for (GivenRows::Fields& fields : rows) {
        fields.erase(fields.begin() + at);
      }
    }
  }
  return std::make_unique<GivenRows>(spelled, std::move(header), std::move(rows));
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (Field& field : split_row(text)) {
    if (!field.text.empty()) {
      names.push_back(std::move(field.text));
    }
  }
  return names;
}

}  // namespace changeover
