#include "io/write/csv_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "changeover/io/formats.hpp"
#include "io/scan/text_scanner.hpp"
#include "io/write/element_text.hpp"

namespace changeover {
namespace {

// The last four are the wide forms of = + - @, which East Asian spreadsheets treat like the narrow
// ones.
constexpr std::array<std::string_view, 11> formula_beginnings = {
    "=",           "+", "-", "@", "\t", "\r", "\n", "\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D",
    "\xEF\xBC\xA0"};

std::size_t digits_at_front(std::string_view text) {
  return std::min(text.find_first_not_of("0123456789"), text.size());
}

// Optional sign, digits with at most one point, optional exponent.
bool is_decimal(std::string_view text) {
  text.remove_prefix(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
  std::size_t digits = digits_at_front(text);
  text.remove_prefix(digits);
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    const std::size_t more = digits_at_front(text);
    digits += more;
    text.remove_prefix(more);
  }
  if (digits == 0) {
    return false;
  }
  if (text.starts_with('e') || text.starts_with('E')) {
    text.remove_prefix(1);
    text.remove_prefix(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
    const std::size_t exponent = digits_at_front(text);
    text.remove_prefix(exponent);
    return exponent > 0 && text.empty();
  }
  return text.empty();
}

// Some programs skip blanks before a formula, so this does, too.
bool is_formula(std::string_view text) {
  const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
  const std::string_view rest = text.substr(blanks);
  return std::ranges::any_of(
             formula_beginnings,
             [&](std::string_view beginning) { return rest.starts_with(beginning); }) &&
         !is_decimal(rest);
}

// Whether the text would be a formula without apostrophes in front.
bool is_formula_behind_apostrophes(std::string_view text) {
  return is_formula(text.substr(std::min(text.find_first_not_of('\''), text.size())));
}

bool needs_quotes(std::string_view cell) {
  const auto special = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return c == ',' || c == ';' || c == '"' || byte < 0x20 || byte == 0x7f;
  };
  return std::ranges::any_of(cell, special) || cell.starts_with(' ') || cell.ends_with(' ');
}

}  // namespace

std::string csv_cell(std::string_view text) {
  std::string cell = is_formula_behind_apostrophes(text) ? "'" : "";
  cell += text;
  if (!needs_quotes(cell)) {
    return cell;
  }
  std::string quoted = "\"";
  for (const char c : cell) {
    quoted += c;
    if (c == '"') {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string_view csv_text(std::string_view cell) {
  const bool escaped = cell.starts_with('\'') && is_formula_behind_apostrophes(cell);
  return cell.substr(escaped ? 1 : 0);
}

namespace {

// The words of the elements are names, not the numbers 0, …, v−1 in some order.
bool are_names(const std::vector<std::string>& labels) {
  return !labels.empty() && !element_set(labels).labels.empty();
}

}  // namespace

std::uint64_t write_csv(BlockSource& source, Sink& sink, const std::vector<std::string>& labels) {
  const Parameters& p = source.parameters();
  std::vector<std::string> cells(labels);
  std::ranges::transform(cells, cells.begin(), csv_cell);
  ElementText text(sink, p.v, cells, ',');
  text.put("block,");
  for (std::uint64_t i = 1; i <= p.k; ++i) {
    text.put("element_");
    text.put_number(i);
    text.put(',');
  }
  text.put("v,change,kind");
  std::string tail = fmt::format("{},{},{}", p.v, p.change, to_string(p.kind));
  if (p.strength != 2) {
    text.put(",strength");
    tail += fmt::format(",{}", p.strength);
  }
  if (are_names(labels)) {
    text.put(",elements");
    tail += ",labels";
  }
  text.put('\n');
  tail += '\n';
  std::uint64_t blocks = 0;
  for_each_block(source, [&](std::span<const Element> block) {
    text.put_number(++blocks);
    text.put(',');
    text.elements(block, ',');
    text.put(tail);
  });
  text.flush();
  return blocks;
}

void write_csv(const Design& design, Sink& sink) {
  DesignSource source(design);
  write_csv(source, sink, design.labels());
}

}  // namespace changeover
