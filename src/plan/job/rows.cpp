#include "plan/job/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/scope.hpp"
#include "io/read/place.hpp"
#include "plan/job/plain_text.hpp"

namespace changeover {
namespace {

// No list of parts, pairs or set-ups is longer.
constexpr std::size_t longest_line = std::size_t{1} << 24;
constexpr std::uint64_t most_rows = std::uint64_t{1} << 22;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// The first separator of a line outside quotes; none if it is a single field.
std::optional<char> first_separator(std::string_view line) {
  std::size_t at = std::min(line.find_first_not_of(" \t"), line.size());
  if (at < line.size() && line[at] == '"') {
    for (++at; at < line.size() && (line[at] != '"' || line.substr(at).starts_with("\"\"")); ++at) {
      at += line[at] == '"' ? 1U : 0U;
    }
    at = std::min(at + 1, line.size());
  }
  at = line.find_first_of(",;\t", at);
  if (at == std::string_view::npos) {
    return std::nullopt;
  }
  // A tab before another separator, or at the end, is a blank.
  const std::size_t next = line.find_first_not_of(" \t", at);
  if (line[at] != '\t') {
    return line[at];
  }
  if (next == std::string_view::npos) {
    return std::nullopt;
  }
  return line[next] == ',' || line[next] == ';' ? line[next] : '\t';
}

// Reads the fields of one line; a defect if they are malformed.
std::optional<TextDefect> split(std::string_view line, char separator, Row& row,
                                std::uint64_t number = 1) {
  std::size_t at = 0;
  const auto is_blank_here = [&](char c) { return c != separator && is_blank(c); };
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank_here(line[at])) {
      ++at;
    }
  };
  for (;;) {
    skip_blanks();
    Field field{.text = "", .offset = at, .line = number};
    if (at < line.size() && line[at] == '"') {
      field.in_quotes = true;
      for (++at;; ++at) {
        if (at >= line.size()) {
          return TextDefect{field.offset,
                            "a quote is opened and not closed on this line; close it"};
        }
        if (line[at] == '"') {
          if (at + 1 >= line.size() || line[at + 1] != '"') {
            ++at;
            break;
          }
          ++at;
        }
        field.text += line[at];
      }
      skip_blanks();
      if (at < line.size() && line[at] != separator) {
        return TextDefect{at, "text after a closing quote; double each quote within quotes"};
      }
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      field.text = line.substr(at, end - at);
      while (!field.text.empty() && is_blank_here(field.text.back())) {
        field.text.pop_back();
      }
      at = end;
    }
    row.push_back(std::move(field));
    if (at >= line.size()) {
      return std::nullopt;
    }
    ++at;
  }
}

}  // namespace

void RowReader::fail(std::size_t offset, std::string_view what) const {
  changeover::fail(lines_.name(), {std::max<std::uint64_t>(1, lines_.number()), offset + 1}, what);
}

void RowReader::fail(const Field& field, std::string_view what) const {
  changeover::fail(lines_.name(), {field.line, field.offset + 1}, what);
}

RowReader::RowReader(Input& input) : lines_(input, longest_line) {}

bool RowReader::next_line() {
  switch (lines_.next()) {
    case InputLines::Next::end:
      return false;
    case InputLines::Next::too_long: {
      const auto defect = first_defect(lines_.line(), true);
      fail(defect ? defect->offset : 0,
           defect ? defect->what : "a line of more than 16 MiB; this is no list");
    }
    case InputLines::Next::line:
      break;
  }
  if (lines_.bytes() > most_bytes) {
    fail(0, "more than 1 GiB; give a list without repetitions");
  }
  return true;
}

std::optional<Row> RowReader::next() {
  while (next_line()) {
    constexpr std::uint64_t now_and_then = 256;
    if (lines_.number() % now_and_then == 0) {
      stop_if_asked();
    }
    const std::string_view line = lines_.line();
    if (line.starts_with('#') || std::all_of(line.begin(), line.end(), is_blank)) {
      continue;
    }
    if (const auto defect = first_defect(line, true)) {
      fail(defect->offset, defect->what);
    }
    if (separator_ == '\0') {
      separator_ = first_separator(line).value_or('\0');
    }
    Row row;
    if (const auto defect = split(line, separator(), row, lines_.number())) {
      fail(defect->offset, defect->what);
    }
    if (++rows_ > most_rows) {
      fail(0, fmt::format("more than {} rows; give a list without repetitions", most_rows));
    }
    if (std::any_of(row.begin(), row.end(), [](const Field& f) { return !f.text.empty(); })) {
      return row;
    }
  }
  return std::nullopt;
}

Row split_row(std::string_view line) {
  Row row;
  if (const auto defect = split(line, ',', row)) {
    throw BadInput(defect->what);
  }
  return row;
}

std::string quoted(std::string_view field) {
  const bool plain = !field.empty() && field.find_first_of(",;\"") == std::string_view::npos &&
                     !is_blank(field.front()) && !is_blank(field.back()) && field.front() != '#';
  if (plain) {
    return std::string(field);
  }
  std::string text = "\"";
  for (const char c : field) {
    text += c == '"' ? "\"\"" : std::string(1, c);
  }
  return text + "\"";
}

}  // namespace changeover
