#include "plan/job/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/scope.hpp"
#include "io/scan/place.hpp"
#include "plan/job/plain_text.hpp"

namespace changeover {
namespace {

// No list of parts, pairs or set-ups is longer.
constexpr std::size_t longest_line = std::size_t{1} << 24;
constexpr std::uint64_t most_rows = std::uint64_t{1} << 22;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;

constexpr std::size_t most_workbook_bytes = std::size_t{1} << 26;
constexpr std::size_t mark_bytes = 8;        // by which a workbook is known
constexpr std::size_t most_columns = 2'048;  // of a sheet: a part in each, and what else is said

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
  if (sheet_) {
    throw BadInput(fmt::format("{}: {}", sheet_->place(offset, sheet_row_), what));
  }
  changeover::fail(lines_.name(), {std::max<std::uint64_t>(1, lines_.number()), offset + 1}, what);
}

void RowReader::fail(const Field& field, std::string_view what) const {
  throw BadInput(fmt::format("{}: {}", place(field), what));
}

std::string RowReader::place(const Field& field) const {
  return sheet_ ? sheet_->place(field.offset, field.line)
                : fmt::format("{}:{}:{}", lines_.name(), field.line, field.offset + 1);
}

RowReader::RowReader(Input& input) : input_(input, mark_bytes), lines_(input_, longest_line) {
  const auto* const part = dynamic_cast<const SheetInput*>(&input);
  if (begins_like_a_workbook(input_.beginning())) {
    sheet_.emplace(
        read_to_end(input_, most_workbook_bytes, "save only the sheet that is needed, or as CSV"),
        input.name(), part != nullptr ? std::optional(part->sheet()) : std::nullopt);
    separator_ = '\t';
  } else if (part != nullptr) {
    throw BadInput(
        fmt::format("{}: not a workbook (.xlsx), so it has no sheet {}; give the file alone",
                    input.name(), shown(part->sheet())));
  }
}

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

std::optional<Row> RowReader::next_of_sheet() {
  while (auto cells = sheet_->next()) {
    sheet_row_ = cells->number;
    Row row;
    for (SheetCell& cell : cells->cells) {
      const std::size_t start = cell.text.find_first_not_of(' ');
      if (start == std::string::npos) {
        continue;
      }
      if (cell.column >= most_columns) {
        fail(cell.column, fmt::format("a cell beyond column {}; remove it", most_columns));
      }
      if (const auto defect = first_defect(cell.text, false)) {
        fail(cell.column, defect->what);
      }
      while (row.size() <= cell.column) {
        row.push_back({.text = "", .offset = row.size(), .line = sheet_row_});
      }
      Field& field = row.back();
      field.in_quotes = true;
      const std::size_t end = cell.text.find_last_not_of(' ') + 1;
      field.text = cell.text.substr(start, end - start);
      if (field.text.size() < cell.text.size()) {
        field.in_full = std::move(cell.text);
      }
    }
    if (!row.empty()) {
      while (row.size() < width_) {
        row.push_back({.text = "", .offset = row.size(), .line = sheet_row_});
      }
      width_ = width_ == 0 ? row.size() : width_;
      return row;
    }
  }
  return std::nullopt;
}

std::optional<Row> RowReader::next() {
  if (sheet_) {
    return next_of_sheet();
  }
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
