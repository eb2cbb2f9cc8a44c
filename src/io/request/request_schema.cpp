#include "io/request/request_schema.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "io/request/request_document.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {
namespace {

constexpr std::string_view field = R"({"type":["string","number","null"]})";
constexpr std::string_view amount =
    R"({"anyOf":[{"type":"number","minimum":0},{"type":"string","pattern":"^[0-9]*\\.?[0-9]*$"}]})";

std::string fields(std::string_view least, std::string_view most) {
  return fmt::format(R"({{"type":"array","items":{}{}{}}})", field,
                     least.empty() ? "" : fmt::format(R"(,"minItems":{})", least),
                     most.empty() ? "" : fmt::format(R"(,"maxItems":{})", most));
}

std::string row(RowShape shape) {
  switch (shape) {
    case RowShape::parts:
      return fmt::format(R"({{"anyOf":[{{"type":"string"}},{{"type":"object","required":["name"],)"
                         R"("additionalProperties":false,)"
                         R"("properties":{{"name":{0},"cost":{0},"slot":{0},"quantity":{0}}}}}]}})",
                         field);
    case RowShape::slots:
      return fmt::format(R"({{"type":"object","required":["name"],"additionalProperties":false,)"
                         R"("properties":{{"name":{0},"least":{0},"most":{0}}}}})",
                         field);
    case RowShape::pairs:
      return fields("2", "2");
    case RowShape::sizes:
      return fmt::format(R"({{"anyOf":[{{"type":["string","integer"]}},{}]}})", fields("2", "2"));
    case RowShape::costs:
    case RowShape::reasons:
      return fields("2", "3");
    case RowShape::weights:
      return fields("3", "3");
    case RowShape::setups:
      return fmt::format(
          R"({{"anyOf":[{0},{{"type":"object","required":["parts"],"additionalProperties":false,)"
          R"("properties":{{"parts":{0},"bench":{1}}}}}]}})",
          fields("1", ""), field);
    case RowShape::tests:
      return fmt::format(
          R"({{"anyOf":[{0},{{"type":"object","required":["parts"],"additionalProperties":false,)"
          R"("properties":{{"parts":{0},"result":{{"type":["string","null"]}},"bench":{1}}}}}]}})",
          fields("", ""), field);
    case RowShape::benches:
      return fmt::format(
          R"({{"anyOf":[{{"type":"string"}},{{"type":"object","additionalProperties":false,)"
          R"("properties":{{)"
          R"("name":{0},"at_once":{0},"test_cost":{0},"change_factor":{0},"slots":{{"anyOf":[{0},)"
          R"({{"type":"array","items":{1}}}]}},)"
          R"("mounted":{2},"start":{2},"own":{2},"without":{2},"hours":{0},)"
          R"("down":{{"type":["boolean","string","null"]}}}}}}]}})",
          field, row(RowShape::slots),
          fmt::format(R"({{"anyOf":[{},{}]}})", field, fields("", "")));
    default:
      return fields("1", "");
  }
}

std::string list(const OptionRecord& record) {
  if (record.shape == RowShape::document) {
    return R"({"anyOf":[{"type":"string"},)"
           R"({"type":"object","required":["file"],"additionalProperties":false,)"
           R"("properties":{"file":{"type":"string","minLength":1}}},)"
           R"({"type":"object","required":["text"],"additionalProperties":false,)"
           R"("properties":{"text":{"type":"string"}}}]})";
  }
  constexpr std::string_view one_of =
      R"({{"anyOf":[{}{{"type":"array","items":{}}},)"
      R"({{"type":"object","required":["file"],"additionalProperties":false,)"
      R"("properties":{{"file":{{"type":"string","minLength":1}}}}}},)"
      R"({{"type":"object","required":["text"],"additionalProperties":false,)"
      R"("properties":{{"text":{{"type":"string"}}}}}},)"
      R"({{"type":"object","required":["workbook"],"additionalProperties":false,)"
      R"("properties":{{"workbook":{{"type":"string","contentEncoding":"base64"}},)"
      R"("sheet":{{"type":"string"}}}}}}]}})";
  return fmt::format(fmt::runtime(one_of),
                     record.shape == RowShape::parts || record.shape == RowShape::benches
                         ? R"({"type":"integer","minimum":0},)"
                         : "",
                     row(record.shape));
}

std::string type_of(const OptionRecord& record) {
  switch (record.kind) {
    case ValueKind::number:
      return R"({"type":"integer","minimum":0})";
    case ValueKind::amount:
      return std::string(amount);
    case ValueKind::seconds:
      return fmt::format(R"({{"type":"number","minimum":0,"maximum":{}}})", most_seconds);
    case ValueKind::flag:
      return R"({"type":"boolean"})";
    case ValueKind::text:
      return R"({"type":"string"})";
    case ValueKind::word: {
      JsonWriter words;
      words.begin_object().key("enum").value(record.words).end_object();
      return words.take();
    }
    case ValueKind::names:
      return fields("", "");
    case ValueKind::list:
      return list(record);
  }
  return "{}";
}

// The condition that a key of a rule is given.
std::string given(std::string_view key, const std::vector<OptionRecord>& records) {
  const std::string_view wanted = value_in(key);
  key = key.substr(0, key.find('='));
  const auto record = std::ranges::find(records, key, &OptionRecord::key);
  const std::string value = record->kind == ValueKind::flag ? R"("const":true)"
                            : wanted.empty()                ? R"("not":{"type":"null"})"
                            : record->kind == ValueKind::number
                                ? fmt::format(R"("const":{})", wanted)
                                : fmt::format(R"("const":"{}")", wanted);
  return fmt::format(R"({{"required":["{0}"],"properties":{{"{0}":{{{1}}}}}}})", key, value);
}

// The condition that one of them is.
std::string one_given(const OptionRule& rule, const std::vector<std::string_view>& keys,
                      const std::vector<OptionRecord>& records) {
  std::string any = joined(keys, ",", [&](std::string_view key) { return given(key, records); });
  if (!rule.or_in_file_of.empty() && &keys == &rule.others) {
    any += fmt::format(R"(,{{"required":["{0}"],"properties":{{"{0}":{{"type":"object"}}}}}})",
                       rule.or_in_file_of);
  }
  return fmt::format(R"({{"anyOf":[{}]}})", any);
}

// What a rule asks of a request that gives the key number `i` of it.
std::string asked(const OptionRule& rule, std::size_t i, const std::vector<OptionRecord>& records) {
  switch (rule.says) {
    case OptionRule::Says::exclude: {
      const std::vector<std::string_view> rest(rule.keys.begin() + std::ptrdiff_t(i) + 1,
                                               rule.keys.end());
      return rest.empty() ? "" : fmt::format(R"({{"not":{}}})", one_given(rule, rest, records));
    }
    case OptionRule::Says::never_with:
      return fmt::format(R"({{"not":{}}})", one_given(rule, rule.others, records));
    case OptionRule::Says::needs:
    case OptionRule::Says::only_with:
      return one_given(rule, rule.others, records);
  }
  return "";
}

}  // namespace

std::string request_schema(std::string_view format, std::string_view title,
                           const std::vector<OptionRecord>& records,
                           const std::vector<OptionRule>& rules) {
  JsonWriter json;
  json.begin_object().key("$schema").value("https://json-schema.org/draft/2020-12/schema");
  json.key("title").value(title).key("type").value("object");
  json.key("additionalProperties").value(false).key("properties").begin_object();
  json.key("format").begin_object().key("const").value(format).end_object();
  for (const OptionRecord& record : records) {
    json.key(record.key).begin_object().key("description").value(help_of(record));
    if (!record.unit.empty()) {
      json.key("unit").value(record.unit);
    }
    json.key("anyOf").begin_array().raw(type_of(record)).raw(R"({"type":"null"})").end_array();
    json.end_object();
  }
  json.end_object().key("allOf").begin_array();
  // Not what every request needs: options may come on top of a document.
  for (const OptionRule& rule : rules) {
    for (std::size_t i = 0; i < rule.keys.size(); ++i) {
      const std::string then = asked(rule, i, records);
      std::string condition = given(rule.keys[i], records);
      if (!rule.where.empty()) {
        condition =
            fmt::format(R"({{"allOf":[{},{}]}})", condition, one_given(rule, rule.where, records));
      }
      if (!then.empty()) {
        json.raw(fmt::format(R"({{"if":{},"then":{}}})", condition, then));
      }
    }
  }
  return json.end_array().end_object().take() + "\n";
}

namespace {

// "`pairs` (numbers only)".
std::string in_python(const OptionRecord& record) {
  return fmt::format("`{}`{}", record.python.empty() ? record.key : record.python,
                     record.in_python.empty() ? "" : fmt::format(" ({})", record.in_python));
}

}  // namespace

std::string doors_table(const std::vector<OptionRecord>& records) {
  const bool in_c =
      std::ranges::any_of(records, [](const OptionRecord& record) { return !record.c.empty(); });
  std::string text = fmt::format(
      "| key | command line | server | Python |{} meaning | unit | default |\n"
      "|:---|:---|:---|:---|{}:---|:---|:---|\n",
      in_c ? " C |" : "", in_c ? ":---|" : "");
  std::string reasons;
  for (const OptionRecord& record : records) {
    const std::string key(record.key);
    std::string help(record.help);
    for (std::size_t at = help.find('|'); at != std::string::npos; at = help.find('|', at + 2)) {
      help.insert(at, "\\");
    }
    const std::string c = record.c.empty() ? " no |" : fmt::format(" `{}` |", record.c);
    text += fmt::format("| `{}` | `{}` | {} | {} |{} {} | {} | {} |\n", key,
                        spelled_with_value(record, Door::command_line),
                        record.not_in_server.empty() ? "yes" : "no",
                        record.not_in_python.empty() ? in_python(record) : "no", in_c ? c : "",
                        help, record.unit, record.by_default);
    if (!record.not_in_server.empty()) {
      reasons += fmt::format("- The server does not take `{}`: {}.\n", key, record.not_in_server);
    }
    if (!record.not_in_python.empty()) {
      reasons +=
          fmt::format("- `{}` is not an argument in Python: {}.\n", key, record.not_in_python);
    }
  }
  return text + (reasons.empty() ? "" : "\n") + reasons;
}

}  // namespace changeover
