// JSON text, key by key, in the order of the calls.
//
//     JsonWriter json;
//     json.begin_object().key("b").value(366).key("kind").value("circular").end_object();
//     json.text();                               // {"b":366,"kind":"circular"}
//
// Compact, one line. Strings are escaped, so that nothing in them is a command to a terminal
// (core/printable.hpp); bytes that are not UTF-8 become U+FFFD. It adds commas and colons; the
// caller balances keys and ends.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// Appends `text` to `out` as a JSON string with its quotes.
void append_json_string(std::string& out, std::string_view text);

/// Writes one JSON value.
class JsonWriter {
 public:
  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }

  JsonWriter& key(std::string_view name);

  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(bool truth);
  JsonWriter& value(double number);  ///< shortest form that reads back the same; null if not finite
  JsonWriter& null();

  template <std::unsigned_integral T>
  requires(!std::same_as<T, bool> && !std::same_as<T, char>) JsonWriter& value(T number) {
    return unsigned_value(number);
  }
  template <std::signed_integral T>
  requires(!std::same_as<T, char>) JsonWriter& value(T number) { return signed_value(number); }

  /// null for nothing.
  template <typename T>
  JsonWriter& value(const std::optional<T>& maybe) {
    return maybe ? value(*maybe) : null();
  }

  /// null for an empty text.
  JsonWriter& value_or_null(std::string_view text) { return text.empty() ? null() : value(text); }

  /// The keys v, k, change and kind.
  JsonWriter& cell(const Parameters& p);
  /// And strength, if it is not 2.
  JsonWriter& parameters(const Parameters& p);

  /// An array of the members of a range: numbers, strings, truth values or ranges of them.
  template <std::ranges::input_range Range>
  requires(!std::convertible_to<Range, std::string_view>) JsonWriter& value(Range&& range) {
    begin_array();
    for (auto&& member : range) {
      value(member);
    }
    return end_array();
  }

  /// An array, for which write(member) writes a value for each member of a range.
  template <std::ranges::input_range Range, typename Write>
  JsonWriter& list(Range&& range, Write&& write) {
    begin_array();
    for (auto&& member : range) {
      write(member);
    }
    return end_array();
  }

  /// An array of objects, of each of which write(member) writes the keys.
  template <std::ranges::input_range Range, typename Write>
  JsonWriter& objects(Range&& range, Write&& write) {
    return list(range, [&](auto&& member) {
      begin_object();
      write(member);
      end_object();
    });
  }

  /// A key with such an array.
  template <std::ranges::input_range Range, typename Write>
  JsonWriter& list(std::string_view name, Range&& range, Write&& write) {
    return key(name).list(range, write);
  }
  template <std::ranges::input_range Range, typename Write>
  JsonWriter& objects(std::string_view name, Range&& range, Write&& write) {
    return key(name).objects(range, write);
  }

  /// Appends text that is JSON already.
  JsonWriter& raw(std::string_view json);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// Returns the text so far and continues after it: a long document can be written in pieces.
  [[nodiscard]] std::string take();

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  JsonWriter& unsigned_value(std::uint64_t number);
  JsonWriter& signed_value(std::int64_t number);
  void separate();

  std::string text_;
  bool first_ = true;  // nothing was written at this level yet, or a key was written last
};

}  // namespace changeover
