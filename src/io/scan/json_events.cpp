#include "io/scan/json_events.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

#include "core/printable.hpp"

namespace changeover {
namespace {

// Follows the parser through the text: it reports events without saying where they begin, but
// between two of them there is nothing but blanks, commas and colons.
class Adapter {
 public:
  using json = nlohmann::json;

  // The parser skips a byte order mark silently.
  Adapter(const JsonText& source, JsonHandler& handler)
      : source_(source),
        handler_(&handler),
        cursor_(source.text.size() - without_byte_order_mark(source.text).size()) {}

  // The parser's interface, so its names.
  bool null() { return emit(JsonEvent::Type::null, literal()); }
  bool boolean(bool /*value*/) { return emit(JsonEvent::Type::boolean, literal()); }
  bool number_integer(json::number_integer_t value) {
    const std::string_view text = literal();
    return value == 0 ? emit(JsonEvent::Type::natural, text)  // −0
                      : emit(JsonEvent::Type::other_number, text);
  }
  bool number_unsigned(json::number_unsigned_t value) {
    return emit(JsonEvent::Type::natural, literal(), value);
  }
  bool number_float(json::number_float_t /*value*/, const json::string_t& /*text*/) {
    return emit(JsonEvent::Type::other_number, literal());
  }
  bool string(json::string_t& value) {
    skip_string();
    return emit(JsonEvent::Type::string, value);
  }
  bool binary(json::binary_t& /*value*/) { return false; }  // not in JSON text
  bool key(json::string_t& value) {
    skip_string();
    return emit(JsonEvent::Type::key, value);
  }
  bool start_object(std::size_t /*size*/) { return open(JsonEvent::Type::begin_object); }
  bool start_array(std::size_t /*size*/) { return open(JsonEvent::Type::begin_array); }
  bool end_object() { return close(JsonEvent::Type::end_object); }
  bool end_array() { return close(JsonEvent::Type::end_array); }

  bool parse_error(std::size_t byte, const std::string& /*token*/, const json::exception& fault) {
    const std::string what = in_short(fault.what());
    if (byte <= 1 && what.starts_with("unexpected end of input")) {
      source_.fail(0, "the input is empty; give a JSON object");
    }
    source_.fail(byte > 0 ? byte - 1 : 0, "not JSON: " + what + "; correct it");
  }

 private:
  // Shortens "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while
  // parsing value - unexpected ']'; expected '[', '{', or a literal": the place is left out, and so
  // is the quoted text of the file, which can be as long as the file.
  static std::string in_short(std::string_view what) {
    for (const std::string_view end : {"] ", ": syntax error", " - "}) {
      const std::size_t at = what.find(end);
      what = at == std::string_view::npos ? what : what.substr(at + end.size());
    }
    for (const std::string_view begin : {"; last read", " parsing '"}) {
      what = what.substr(0, what.find(begin));
    }
    std::string line;
    for (const char c : what) {
      line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    constexpr std::string_view expected = "; expected ";
    if (const std::size_t at = line.find(expected); at != std::string::npos) {
      line.replace(at, expected.size(), " instead of ");
    }
    return line;
  }

  bool emit(JsonEvent::Type type, std::string_view text, std::uint64_t natural = 0) {
    handler_->on({type, text, natural, start_});
    return true;
  }

  bool open(JsonEvent::Type type) {
    start_token();
    ++cursor_;
    if (++depth_ > max_json_depth) {
      source_.fail(start_,
                   fmt::format("JSON nested more than {} deep; use fewer levels", max_json_depth));
    }
    return emit(type, {});
  }

  bool close(JsonEvent::Type type) {
    start_token();
    ++cursor_;
    --depth_;
    return emit(type, {});
  }

  void start_token() {
    cursor_ = std::min(source_.text.find_first_not_of(" \t\r\n,:", cursor_), source_.text.size());
    start_ = cursor_;
  }

  std::string_view literal() {
    start_token();
    cursor_ = std::min(source_.text.find_first_of(" \t\r\n,:]}", cursor_), source_.text.size());
    return source_.text.substr(start_, cursor_ - start_);
  }

  void skip_string() {
    start_token();
    for (++cursor_; cursor_ < source_.text.size() && source_.text[cursor_] != '"'; ++cursor_) {
      cursor_ += source_.text[cursor_] == '\\' ? 1U : 0U;
    }
    ++cursor_;
  }

  const JsonText& source_;
  JsonHandler* handler_;
  std::size_t cursor_;     // after the last event
  std::size_t start_ = 0;  // of the last event
  std::size_t depth_ = 0;
};

}  // namespace

void JsonText::fail_expecting(const JsonEvent& event, std::string_view wanted) const {
  fail(event.offset,
       fmt::format("expected {}, found {}; correct it", wanted, to_string(event.type)));
}

Place JsonText::place(std::size_t offset) const {
  Place place = place_of(text, offset);
  if (place.line == 1) {
    place.column += origin.column - 1;
  }
  place.line += origin.line - 1;
  return place;
}

std::string_view to_string(JsonEvent::Type type) {
  switch (type) {
    case JsonEvent::Type::begin_object:
    case JsonEvent::Type::end_object:
      return "an object";
    case JsonEvent::Type::begin_array:
    case JsonEvent::Type::end_array:
      return "an array";
    case JsonEvent::Type::key:
    case JsonEvent::Type::string:
      return "a string";
    case JsonEvent::Type::natural:
    case JsonEvent::Type::other_number:
      return "a number";
    case JsonEvent::Type::boolean:
      return "true or false";
    case JsonEvent::Type::null:
      return "null";
  }
  return "";
}

void parse_json(const JsonText& json, JsonHandler& handler) {
  Adapter adapter(json, handler);
  nlohmann::json::sax_parse(json.text.begin(), json.text.end(), &adapter);
}

namespace {

class Builder final : public JsonHandler {
 public:
  explicit Builder(const JsonText& json) : json_(json) {}

  void on(const JsonEvent& event) override {
    using Type = JsonEvent::Type;
    if (event.type == Type::end_object || event.type == Type::end_array) {
      open_.pop_back();
      keys_.pop_back();
      return;
    }
    if (event.type == Type::key) {
      key_ = event.text;
      if (!keys_.back().insert(key_).second) {
        json_.fail(event.offset, fmt::format("the key {} is given twice; remove one", shown(key_)));
      }
      return;
    }
    JsonNode node{.type = event.type,
                  .text = std::string(event.text),
                  .natural = event.natural,
                  .offset = event.offset,
                  .members = {}};
    JsonNode* place = &root_;
    if (!open_.empty()) {
      JsonNode& parent = *open_.back();
      parent.members.push_back(
          {.key = parent.is_object() ? key_ : std::string(), .node = std::move(node)});
      place = &parent.members.back().node;
    } else {
      root_ = std::move(node);
    }
    if (place->is_object() || place->is_array()) {
      // Only the last member of each open node grows, so these pointers stay valid.
      open_.push_back(place);
      keys_.emplace_back();
    }
  }

  [[nodiscard]] JsonNode take() { return std::move(root_); }

 private:
  const JsonText& json_;
  JsonNode root_;
  std::vector<JsonNode*> open_;
  std::vector<std::set<std::string>> keys_;  // of each open node
  std::string key_;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const {
  const auto found = std::ranges::find_if(members, [&](const auto& m) { return m.key == key; });
  return found == members.end() ? nullptr : &found->node;
}

JsonNode json_tree(const JsonText& json) {
  Builder builder(json);
  parse_json(json, builder);
  return builder.take();
}

}  // namespace changeover
