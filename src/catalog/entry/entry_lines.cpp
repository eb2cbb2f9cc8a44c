// Lines of a catalog, written and read.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "catalog/entry/day.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "core/lines.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/read/recipe_handler.hpp"
#include "io/scan/json_events.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {
namespace {

using Type = JsonEvent::Type;

constexpr std::string_view format = "changeover-catalog/1";

// The most bytes of a text: a reason, a note, a name.
constexpr std::size_t longest_text = 2000;
constexpr std::size_t most_cites = 32;

using CreditField = std::pair<std::string_view, std::string Credit::*>;
constexpr std::array<CreditField, 4> credit_fields = {
    CreditField{"who", &Credit::who}, CreditField{"date", &Credit::date},
    CreditField{"program", &Credit::program}, CreditField{"command", &Credit::command}};

void write_credit(JsonWriter& json, const Credit& credit) {
  json.begin_object();
  for (const auto& [key, field] : credit_fields) {
    if (!(credit.*field).empty()) {
      json.key(key).value(credit.*field);
    }
  }
  json.end_object();
}

// Whether all words of a recipe are printable.
bool words_are_printable(const Recipe& recipe) {
  return is_printable(recipe.construction) && is_printable(recipe.provenance) &&
         std::ranges::all_of(recipe.arguments,
                             [](const auto& each) { return is_printable(each.first); }) &&
         std::ranges::all_of(recipe.inputs, words_are_printable);
}

// A reason as bounds say it now: rows keep the words of the program that wrote them.
std::string in_present_words(std::string reason) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 3> renamed{{
      {"(elements in every block do not help)",
       "(a design with elements in every block needs no fewer)"},
      {"counting with this excess, least at 0 elements in every block, gives",
       "counting pairs with this excess gives"},
      {"counting with this excess, least at ", "counting pairs with this excess, least with "},
  }};
  for (const auto& [before, now] : renamed) {
    if (const std::size_t at = reason.find(before); at != std::string::npos) {
      reason.replace(at, before.size(), now);
    }
  }
  return reason;
}

// The object of one line, key by key.
class LineHandler final : public JsonHandler {
 public:
  explicit LineHandler(const JsonText& json)
      : json_(json), recipe_(json, RecipeHandler::Needs::all_keys) {}

  void on(const JsonEvent& event) override {
    switch (where_) {
      case Where::start:
        if (event.type != Type::begin_object) {
          json_.fail_expecting(event, "an entry, {…}");
        }
        where_ = Where::keys;
        break;
      case Where::keys:
        if (event.type == Type::key) {
          on_key(event);
        } else {
          where_ = Where::end;
        }
        break;
      case Where::value:
        where_ = Where::keys;
        on_value(event);
        break;
      case Where::recipe:
        recipe_.on(event);
        if (recipe_.done()) {
          entry.recipe = recipe_.take();
          where_ = Where::keys;
        }
        break;
      case Where::cites:
        if (event.type == Type::end_array) {
          where_ = Where::keys;
        } else {
          entry.cites.push_back(text(event));
          if (entry.cites.size() > most_cites) {
            json_.fail(event.offset,
                       fmt::format("more than {} citations; leave some out", most_cites));
          }
        }
        break;
      case Where::credit:
        if (event.type == Type::end_object) {
          where_ = Where::keys;
        } else {
          once(event);
          where_ = Where::credit_value;
        }
        break;
      case Where::credit_value:
        on_credit(event);
        where_ = Where::credit;
        break;
      case Where::end:
        break;  // Nothing follows: parse_json() ensures that.
    }
  }

  [[nodiscard]] bool has(std::string_view key) const {
    return std::ranges::find(seen_, key) != seen_.end();
  }
  [[nodiscard]] const std::vector<std::string>& seen() const { return seen_; }

  CatalogEntry entry;
  std::string label;
  std::string format_name;

 private:
  enum class Where : std::uint8_t { start, keys, value, recipe, cites, credit, credit_value, end };

  void once(const JsonEvent& event) {
    // Distinguishes the keys of the credit from those of the entry.
    std::string name = (where_ == Where::credit ? "credit." : "") + std::string(event.text);
    if (has(name)) {
      json_.fail(event.offset, fmt::format("{} is given twice; give it once", shown(event.text)));
    }
    seen_.push_back(std::move(name));
    key_ = event.text;
    key_offset_ = event.offset;
  }

  void on_key(const JsonEvent& event) {
    once(event);
    where_ = key_ == "recipe" ? Where::recipe : Where::value;
  }

  [[nodiscard]] std::string text(const JsonEvent& event) const {
    if (event.type != Type::string) {
      json_.fail_expecting(event, fmt::format("a string for {}", key_));
    }
    if (event.text.size() > longest_text || !is_printable(event.text)) {
      json_.fail(event.offset,
                 fmt::format("{} is longer than {} bytes or has unprintable characters; write one "
                             "plain line",
                             key_, longest_text));
    }
    return std::string(event.text);
  }

  [[nodiscard]] std::uint64_t number(const JsonEvent& event) const {
    if (event.type != Type::natural) {
      json_.fail_expecting(event, fmt::format("a whole number for {}", key_));
    }
    return event.natural;
  }

  void on_value(const JsonEvent& event) {
    if (key_ == "label") {
      label = text(event);
    } else if (key_ == "format") {
      format_name = text(event);
    } else if (key_ == "b") {
      entry.b = number(event);
    } else if (key_ == "lower_bound") {
      entry.lower_bound = number(event);
    } else if (key_ == "reason") {
      entry.reason = in_present_words(text(event));
    } else if (key_ == "note") {
      entry.note = text(event);
    } else if (key_ == "retracted") {
      entry.retracted = text(event);
    } else if (key_ == "sha256") {
      const auto checksum = checksum_from_hex(text(event));
      if (!checksum) {
        json_.fail(event.offset, "sha256 is not 64 digits 0-9, a-f; correct it");
      }
      entry.checksum = *checksum;
    } else if (key_ == "cites") {
      if (event.type != Type::begin_array) {
        json_.fail_expecting(event, "an array for cites");
      }
      where_ = Where::cites;
    } else if (key_ == "credit") {
      if (event.type != Type::begin_object) {
        json_.fail_expecting(event, "an object for credit");
      }
      entry.credit = {};
      where_ = Where::credit;
    } else {
      json_.fail(key_offset_,
                 fmt::format("unknown key {}; remove it, or use a newer program", shown(key_)));
    }
  }

  void on_credit(const JsonEvent& event) {
    const auto* const field = std::ranges::find(credit_fields, key_, &CreditField::first);
    if (field == credit_fields.end()) {
      json_.fail(key_offset_, fmt::format("unknown key {} in the credit; use who, date, "
                                          "program or command",
                                          shown(key_)));
    }
    entry.credit.*field->second = text(event);
    if (key_ == "date" && !is_day(event.text)) {
      json_.fail(event.offset, "the date is not a day like 2026-11-22; correct it");
    }
  }

  JsonText json_;
  RecipeHandler recipe_;
  Where where_ = Where::start;
  std::string key_;
  std::size_t key_offset_ = 0;
  std::vector<std::string> seen_;
};

}  // namespace

std::string line_of(const CatalogEntry& entry, const Credit& shared) {
  JsonWriter json;
  json.begin_object().key("label").value(entry.label()).key("b").value(entry.b);
  json.key("lower_bound").value(entry.lower_bound).key("reason").value(entry.reason);
  json.key("recipe").raw(recipe_to_json(entry.recipe));
  json.key("sha256").value(to_hex(entry.checksum));
  if (!entry.cites.empty()) {
    json.key("cites").value(entry.cites);
  }
  if (!entry.note.empty()) {
    json.key("note").value(entry.note);
  }
  if (entry.credit != shared) {
    json.key("credit");
    write_credit(json, entry.credit);
  }
  if (!entry.retracted.empty()) {
    json.key("retracted").value(entry.retracted);
  }
  json.end_object();
  return json.take();
}

CatalogEntry entry_from_line(std::string_view line, const std::string& name, std::uint64_t number,
                             const Credit& shared) {
  const Place origin{.line = number, .column = 1};
  const JsonText json{line, name, origin};
  if (line.size() > longest_catalog_line) {
    json.fail(0, fmt::format("a line of more than {} MiB; leave the entry out",
                             longest_catalog_line >> 20));
  }
  LineHandler handler(json);
  handler.entry.credit = shared;
  parse_json(json, handler);
  CatalogEntry entry = std::move(handler.entry);
  for (const std::string_view needed :
       {"label", "b", "lower_bound", "reason", "recipe", "sha256"}) {
    if (!handler.has(needed)) {
      json.fail(0, fmt::format("the entry lacks {}; add it", needed));
    }
  }
  if (handler.has("format")) {
    json.fail(0, "only the first line has a format; remove it");
  }
  entry.parameters = entry.recipe.parameters;
  try {
    check(entry.parameters);
  } catch (const ImpossibleParameters& fault) {
    json.fail(0, std::string(fault.what()) + "; correct the recipe");
  }
  if (!words_are_printable(entry.recipe)) {
    json.fail(0, "the recipe has unprintable characters; remove them");
  }
  if (entry.b == 0 || entry.b < entry.lower_bound) {
    json.fail(0, fmt::format("{}, where the lower bound is {}; correct the line",
                             count_of(entry.b, "block"), entry.lower_bound));
  }
  if (handler.label != entry.label()) {
    json.fail(0, fmt::format("the label {} does not fit its entry, which is {}; correct it",
                             shown(handler.label), entry.label()));
  }
  return entry;
}

std::string header_line(const Credit& shared) {
  JsonWriter json;
  json.begin_object().key("format").value(format);
  if (shared != Credit{}) {
    json.key("credit");
    write_credit(json, shared);
  }
  json.end_object();
  return json.take();
}

Credit shared_from_header(std::string_view line, const std::string& name) {
  const JsonText json{line, name};
  LineHandler handler(json);
  parse_json(json, handler);
  if (!handler.format_name.starts_with("changeover-catalog/")) {
    json.fail(0,
              fmt::format("not a catalog; the first line must be {{\"format\":\"{}\"}}", format));
  }
  if (handler.format_name != format) {
    json.fail(0, fmt::format("a catalog of the unknown format {}; use a newer program",
                             shown(handler.format_name)));
  }
  for (const std::string& key : handler.seen()) {
    if (key != "format" && !key.starts_with("credit")) {
      json.fail(0, fmt::format("the first line has the key {}; remove it: there are format and "
                               "credit only",
                               shown(key)));
    }
  }
  return handler.entry.credit;
}

CatalogText read_catalog(std::string_view text, const std::string& name) {
  CatalogText catalog;
  Lines lines(text);
  if (!lines.next()) {
    throw BadInput(fmt::format(
        "{}: the file is empty; the first line of a catalog must be {{\"format\":\"{}\"}}", name,
        format));
  }
  catalog.shared = shared_from_header(lines.line(), name);
  while (lines.next()) {
    if (!lines.line().empty()) {
      catalog.entries.push_back(
          entry_from_line(lines.line(), name, lines.number(), catalog.shared));
    }
  }
  return catalog;
}

}  // namespace changeover
