#include "loadorder/pairs/item_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_name = 255;

/// An invisible character in a name, as "U+200B", with which two names can look alike; nullopt if
/// there is none. `word` is UTF-8.
std::optional<std::string> invisible_character(std::string_view word) {
  constexpr auto ranges = std::to_array<std::pair<char32_t, char32_t>>({{0xA0, 0xA0},
                                                                        {0xAD, 0xAD},
                                                                        {0x34F, 0x34F},
                                                                        {0x61C, 0x61C},
                                                                        {0x115F, 0x1160},
                                                                        {0x17B4, 0x17B5},
                                                                        {0x180B, 0x180F},
                                                                        {0x2000, 0x200F},
                                                                        {0x2028, 0x202F},
                                                                        {0x205F, 0x206F},
                                                                        {0x3000, 0x3000},
                                                                        {0x3164, 0x3164},
                                                                        {0xFE00, 0xFE0F},
                                                                        {0xFEFF, 0xFEFF},
                                                                        {0xFFA0, 0xFFA0},
                                                                        {0xE0000, 0xE0FFF}});
  while (!word.empty()) {
    const CodePoint point = first_code_point(word);
    word.remove_prefix(point.bytes);
    for (const auto& [first, last] : ranges) {
      if (point.value >= first && point.value <= last) {
        return fmt::format("U+{:04X}", std::uint32_t{point.value});
      }
    }
  }
  return std::nullopt;
}

}  // namespace

RowOptions item_row_options() {
  RowOptions options = RowOptions::of_any_length();
  options.any_separator = options.blanks = options.percent_too = true;
  return options;
}

void take_fields(Row& row, const RowReader& rows) {
  std::erase_if(row, [](const Field& field) { return field.text.empty(); });
  if (row.size() == 1 && !row.front().in_quotes && !rows.is_given()) {
    row = at_blanks(row.front(), rows);
  }
}

namespace {

void note_first_row(const RowReader& rows, const Row& row, std::string_view read_as,
                    std::vector<std::string>* notes) {
  if (notes != nullptr) {
    notes->push_back(fmt::format("{}: the first row was read as {}: {}", rows.place(row[0]),
                                 read_as,
                                 joined(row, [](const Field& field) { return field.text; })));
  }
}

}  // namespace

void note_heading(const RowReader& rows, const Row& heading, std::vector<std::string>* notes) {
  note_first_row(rows, heading, "names of columns", notes);
}

void note_first_pair(const RowReader& rows, const Row& row, std::vector<std::string>* notes) {
  note_first_row(rows, row, "a pair of items", notes);
}

std::unordered_map<std::string, Element> items_by_name(const PairGraph* graph) {
  std::unordered_map<std::string, Element> items;
  if (graph != nullptr) {
    for (const std::string& name : graph->names()) {
      items.emplace(name, static_cast<Element>(items.size()));
    }
  }
  return items;
}

std::optional<Element> item_number(const Field& field) {
  const std::string_view word = field.text;
  Element number = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  const bool plain = error == std::errc() && stop == end && (word[0] != '0' || word.size() == 1);
  return plain && number < most_items ? std::optional(number) : std::nullopt;
}

std::optional<std::string> as_number(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) {
    word.remove_prefix(1);
  }
  const std::size_t point = std::min(word.find('.'), word.size());
  const std::string_view whole = word.substr(0, point);
  std::string_view part = point < word.size() ? word.substr(point + 1) : std::string_view();
  const auto digits = [](std::string_view text) { return std::ranges::all_of(text, is_digit); };
  if (whole.empty() || !digits(whole) || !digits(part)) {
    return std::nullopt;
  }
  std::string number(whole.substr(std::min(whole.find_first_not_of('0'), whole.size() - 1)));
  part = part.substr(0, part.find_last_not_of('0') + 1);
  if (!part.empty()) {
    number += '.';
    number += part;
  }
  return negative && number != "0" ? '-' + number : number;
}

void check_item_name(const RowReader& rows, const Field& field) {
  const std::string& word = field.text;
  if (word.size() > longest_name) {
    rows.fail(field, "a name of more than 255 bytes; shorten it");
  }
  if (const auto character = invisible_character(word)) {
    rows.fail(field, fmt::format("the name '{}' has a character that cannot be seen, {}; "
                                 "remove it",
                                 word, *character));
  }
}

void check_written_plainly(const RowReader& rows, const Field& field) {
  if (const auto number = as_number(field.text); number && *number != field.text) {
    rows.fail(field, fmt::format("'{}' is not written like the whole numbers before it; write "
                                 "{}, or begin all items with a letter if they are names",
                                 field.text, *number));
  }
}

void WrittenNumbers::add(const RowReader& rows, const Field& field) {
  const auto number = as_number(field.text);
  if (!number) {
    return;
  }
  const auto [other, first] = names_.try_emplace(*number, field.text);
  if (!first) {
    rows.fail(field, fmt::format("'{}' and '{}' are one number and two names; write it in one way",
                                 other->second, field.text));
  }
}

}  // namespace changeover
