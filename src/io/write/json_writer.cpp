#include "io/write/json_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "changeover/io/formats.hpp"
#include "core/printable.hpp"
#include "io/write/element_text.hpp"

namespace changeover {

void append_json_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text[0]);
    if (byte == '"' || byte == '\\') {
      out += '\\';
      out += text[0];
    } else if (byte == '\n') {
      out += "\\n";
    } else if (byte == '\t') {
      out += "\\t";
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\u{:04x}", byte);
    } else if (byte < 0x80) {
      out += text[0];
    } else {
      const CodePoint point = first_code_point(text);
      if (is_printable(point)) {
        out += text.substr(0, point.bytes);
      } else if (point.valid) {  // all below U+10000, so one escape is enough
        out += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(point.value));
      } else {
        out += "\xEF\xBF\xBD";  // U+FFFD
      }
      text.remove_prefix(point.bytes);
      continue;
    }
    text.remove_prefix(1);
  }
  out += '"';
}

void JsonWriter::separate() {
  if (!first_) {
    text_ += ',';
  }
  first_ = false;
}

JsonWriter& JsonWriter::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  append_json_string(text_, name);
  text_ += ':';
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  separate();
  append_json_string(text_, text);
  return *this;
}

JsonWriter& JsonWriter::value(bool truth) { return raw(truth ? "true" : "false"); }

JsonWriter& JsonWriter::value(double number) {
  return std::isfinite(number) ? raw(fmt::format("{}", number)) : null();
}

JsonWriter& JsonWriter::null() { return raw("null"); }

JsonWriter& JsonWriter::unsigned_value(std::uint64_t number) {
  return raw(fmt::format_int(number).c_str());
}

JsonWriter& JsonWriter::signed_value(std::int64_t number) {
  return raw(fmt::format_int(number).c_str());
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

JsonWriter& JsonWriter::cell(const Parameters& p) {
  key("v").value(p.v).key("k").value(p.k).key("change").value(p.change);
  return key("kind").value(to_string(p.kind));
}

JsonWriter& JsonWriter::parameters(const Parameters& p) {
  cell(p);
  return p.strength == 2 ? *this : key("strength").value(p.strength);
}

std::string JsonWriter::take() { return std::exchange(text_, std::string()); }

namespace {

void write_recipe(JsonWriter& json, const Recipe& recipe) {
  json.begin_object().key("construction").value(recipe.construction).parameters(recipe.parameters);
  json.key("arguments").begin_object();
  for (const auto& [name, value] : recipe.arguments) {
    json.key(name).value(value);
  }
  json.end_object();
  json.list("inputs", recipe.inputs, [&](const Recipe& input) { write_recipe(json, input); });
  if (!recipe.blocks.empty()) {
    json.key("blocks").value(recipe.blocks);
  }
  if (!recipe.provenance.empty()) {
    json.key("provenance").value(recipe.provenance);
  }
  json.end_object();
}

// An element as its label or its number.
void write_element(JsonWriter& json, Element x, const std::vector<std::string>& labels) {
  if (x < labels.size()) {
    json.value(labels[x]);
  } else {
    json.value(x);
  }
}

void write_elements(JsonWriter& json, const Block& block, const std::vector<std::string>& labels) {
  json.list(block, [&](Element x) { write_element(json, x, labels); });
}

}  // namespace

std::uint64_t write_json(BlockSource& source, Sink& sink, const TextHeader& header,
                         const std::function<std::optional<DesignVerdict>()>& verdict) {
  const Parameters& p = source.parameters();
  const std::vector<std::string> numbers_only;
  ElementText text(sink, p.v, numbers_only, ',');
  JsonWriter json;
  json.begin_object().key("format").value("changeover-design/1").parameters(p);
  json.key("blocks").begin_array();
  text.put(json.take());
  std::uint64_t blocks = 0;
  for_each_block(source, [&](std::span<const Element> block) {
    text.put(blocks++ == 0 ? "\n[" : ",\n[");
    text.elements(block, ']');
  });
  text.put('\n');
  json.end_array();
  if (!header.labels.empty()) {
    json.key("labels").value(header.labels);
  }
  if (header.recipe) {
    json.key("recipe").raw(recipe_to_json(*header.recipe));
  }
  if (const auto found = verdict ? verdict() : std::nullopt) {
    json.key("verdict").raw(verdict_to_json(*found));
  }
  json.end_object();
  text.put(json.take());
  text.put('\n');
  text.flush();
  return blocks;
}

void write_json(const Design& design, Sink& sink, const std::optional<DesignVerdict>& verdict) {
  DesignSource source(design);
  write_json(source, sink, {design.labels(), design.recipe}, [&] { return verdict; });
}

std::string verdict_to_json(const DesignVerdict& verdict) {
  JsonWriter json;
  json.begin_object();
  json.key("valid").value(verdict.valid).key("tight").value(verdict.tight);
  json.key("economical").value(verdict.economical).key("b").value(verdict.b);
  json.key("lower_bound").value(verdict.lower_bound);
  json.key("minimum").value(verdict.minimum_proved ? "proved" : "unknown");
  json.end_object();
  return json.take();
}

std::string verdict_to_json(const Verdict& verdict, const std::vector<std::string>& labels) {
  JsonWriter json;
  json.begin_object().cell(verdict.parameters).key("strength").value(verdict.parameters.strength);
  json.key("valid").value(verdict.valid()).key("tight").value(verdict.tight());
  json.key("economical").value(verdict.economical()).key("b").value(verdict.b);
  json.key("counting_bound").value(verdict.counting_bound);
  json.key("bad_steps").value(verdict.bad_steps);
  json.objects("bad_step_examples", verdict.bad_step_examples, [&](const BadStep& step) {
    json.key("from").value(step.from).key("to").value(step.to);
    json.key("changes").value(step.changes);
  });
  json.key("subsets").value(verdict.subsets).key("uncovered").value(verdict.uncovered);
  json.list("uncovered_examples", verdict.uncovered_examples,
            [&](const Block& subset) { write_elements(json, subset, labels); });
  json.key("covered").value(verdict.covered);
  json.key("never_newly_covered").value(verdict.never_newly_covered);
  json.key("excess").value(verdict.excess).key("fixed");
  write_elements(json, verdict.fixed, labels);
  json.key("degree_identity");
  verdict.parameters.strength == 2 ? json.value(verdict.degree_identity) : json.null();
  json.key("unchanged_subsets").value(verdict.unchanged_subsets).key("never_unchanged");
  write_elements(json, verdict.never_unchanged, labels);
  Element x = 0;
  json.objects("elements", verdict.elements, [&](const ElementCount& count) {
    json.key("element");
    write_element(json, x++, labels);
    json.key("introductions").value(count.introductions).key("blocks").value(count.blocks);
    json.key("covered").value(count.covered).key("excess").value(count.excess);
  });
  json.end_object();
  return json.take();
}

std::string recipe_to_json(const Recipe& recipe) {
  JsonWriter json;
  write_recipe(json, recipe);
  return json.take();
}

}  // namespace changeover
