#include "io/scan/row_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/printable.hpp"
#include "io/scan/place.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_workbook_bytes = std::size_t{1} << 26;
constexpr std::size_t mark_bytes = 8;        // how a workbook begins
constexpr std::size_t most_columns = 2'048;  // of a sheet: a part in each, and what else is there

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Where the quotes that open at `at` end; the end of the line if they are not closed.
std::size_t end_of_quotes(std::string_view line, std::size_t at) {
  for (++at; at < line.size(); ++at) {
    if (line[at] == '"') {
      if (at + 1 >= line.size() || line[at + 1] != '"') {
        return at + 1;
      }
      ++at;
    }
  }
  return line.size();
}

// The first separator of a line outside quotes, which open it or, if blanks may separate, follow
// one; none if it is a single field.
std::optional<char> first_separator(std::string_view line, bool blanks) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  std::size_t at = begin;
  while (at < line.size() && line[at] != ',' && line[at] != ';' && line[at] != '\t') {
    const bool opens = line[at] == '"' && (at == begin || (blanks && is_blank(line[at - 1])));
    at = opens ? end_of_quotes(line, at) : at + 1;
  }
  if (at == line.size()) {
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

// The separators of a row.
struct AtOne {
  char separator;
  bool operator()(char c) const { return c == separator; }
};
struct AtAny {
  bool operator()(char c) const { return c == ',' || c == ';' || c == '\t'; }
};
struct AtBlanks {
  bool operator()(char c) const { return is_blank(c); }
};

// What a row has outside quotes, which open it, follow a blank or follow a separator.
enum class Found { separator, quotes, neither };

template <typename Separates>
Found look(std::string_view line, Separates separates) {
  Found found = Found::neither;
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == '"' && (at == 0 || separates(line[at - 1]) || is_blank(line[at - 1]))) {
      at = end_of_quotes(line, at);
      found = Found::quotes;
    } else if (separates(line[at])) {
      return Found::separator;
    } else {
      ++at;
    }
  }
  return found;
}

// Reads the fields of one line into a row, whose fields are used again; a defect if they are
// malformed.
template <typename Separates>
std::optional<TextDefect> split_at(std::string_view line, Separates separates, Row& row,
                                   std::uint64_t number = 1) {
  std::size_t at = 0;
  std::size_t count = 0;
  const auto is_blank_here = [&](char c) { return is_blank(c) && !separates(c); };
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank_here(line[at])) {
      ++at;
    }
  };
  for (;;) {
    skip_blanks();
    Field& field = count < row.size() ? row[count] : row.emplace_back();
    ++count;
    field.text.clear();
    field.in_full.clear();
    field.offset = at;
    field.line = number;
    field.in_quotes = at < line.size() && line[at] == '"';
    if (field.in_quotes) {
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
      if (at < line.size() && !separates(line[at])) {
        return TextDefect{at, "text after a closing quote; double each quote within quotes"};
      }
    } else {
      const std::size_t begin = at;
      while (at < line.size() && !separates(line[at])) {
        ++at;
      }
      std::size_t end = at;
      while (end > begin && is_blank_here(line[end - 1])) {
        --end;
      }
      field.text.assign(line.substr(begin, end - begin));
    }
    if (at >= line.size()) {
      row.resize(count);
      return std::nullopt;
    }
    ++at;
  }
}

std::string in_quotes(std::string_view field) {
  std::string text = "\"";
  for (const char c : field) {
    text += c == '"' ? "\"\"" : std::string(1, c);
  }
  return text + "\"";
}

bool is_empty(const Field& field) { return field.text.empty(); }

}  // namespace

void RowReader::fail(std::size_t offset, std::string_view what) const {
  if (given_ != nullptr) {
    fail(Field{.text = "", .offset = offset, .line = given_next_ == 0 ? 0 : given_next_ - 1}, what);
  }
  if (sheet_) {
    throw BadInput(fmt::format("{}: {}", sheet_->place(offset, sheet_row_), what));
  }
  changeover::fail(lines_.name(), {std::max<std::uint64_t>(1, lines_.number()), offset + 1}, what);
}

void RowReader::fail(const Field& field, std::string_view what) const {
  throw BadInput(fmt::format("{}: {}", place(field), what));
}

std::string RowReader::place(const Field& field) const {
  if (given_ != nullptr) {
    return field.line == 0 ? given_->name() : fmt::format("{}[{}]", given_->name(), field.line - 1);
  }
  return sheet_ ? sheet_->place(field.offset, field.line)
                : fmt::format("{}:{}:{}", lines_.name(), field.line, field.offset + 1);
}

std::optional<std::string> RowReader::merged_with_others(const Field& field) const {
  const auto range = std::ranges::find_if(across_, [&](const MergedRange& each) {
    return each.first_column < field.offset && field.offset <= each.last_column;
  });
  return range == across_.end() ? std::nullopt : std::optional(range_name(*range));
}

RowReader::RowReader(Input& input, const RowOptions& options)
    : options_(options), input_(input, mark_bytes), lines_(input_, options.longest_line) {
  given_ = dynamic_cast<const GivenRows*>(&input);
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

std::optional<Row> RowReader::next_given() {
  const GivenRows& given = *given_;
  if (given_next_ == 0 && given.header().empty()) {
    ++given_next_;
  }
  while (given_next_ <= given.rows().size()) {
    const std::uint64_t number = given_next_++;
    const auto& fields = number == 0 ? given.header() : given.rows()[number - 1];
    Row row;
    for (const std::string& text : fields) {
      Field& field = row.emplace_back();
      field = {.text = text, .offset = row.size() - 1, .line = number, .in_quotes = true};
      if (const auto defect = first_defect(text, false)) {
        fail(field, defect->what);
      }
    }
    if (!row.empty()) {
      return row;
    }
  }
  return std::nullopt;
}

bool RowReader::next_line() {
  if (given_ != nullptr) {
    of_sheet_ = next_given();
    return of_sheet_.has_value();
  }
  if (sheet_) {
    of_sheet_ = next_of_sheet();
    return of_sheet_.has_value();
  }
  switch (lines_.next()) {
    case InputLines::Next::end:
      return false;
    case InputLines::Next::too_long: {
      const auto defect = first_defect(lines_.line(), true);
      fail(defect ? defect->offset : 0, defect ? defect->what : options_.too_long);
    }
    case InputLines::Next::line:
      break;
  }
  if (lines_.bytes() > options_.most_bytes) {
    constexpr unsigned gib = 30;
    const bool is_large = options_.most_bytes >> gib != 0;
    fail(0, fmt::format("more than {} {}; give a list without repetitions",
                        options_.most_bytes >> (is_large ? gib : 20U), is_large ? "GiB" : "MiB"));
  }
  return true;
}

std::optional<Row> RowReader::next_of_sheet() {
  const std::uint64_t before = sheet_row_;
  while (auto cells = sheet_->next()) {
    sheet_row_ = cells->number;
    after_blank_ = sheet_row_ > before + 1;
    across_ = std::move(cells->across);
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

bool RowReader::is_row_all_the_same(std::string_view line, Row& row) const {
  if (!options_.is_no_comment || first_defect(line, true)) {
    return false;
  }
  const char separator =
      separator_ != '\0' ? separator_ : first_separator(line, options_.blanks).value_or('\0');
  return separator != '\0' && !split_at(line, AtOne{separator}, row, lines_.number()) &&
         options_.is_no_comment(row);
}

bool RowReader::split(Row& row) {
  if (of_sheet_) {
    row = *std::exchange(of_sheet_, std::nullopt);
    return true;
  }
  constexpr std::uint64_t now_and_then = 256;
  if (lines_.number() % now_and_then == 0) {
    stop_if_asked();
  }
  const std::string_view line = lines_.line();
  const std::size_t begin =
      options_.percent_too ? std::min(line.find_first_not_of(" \t"), line.size()) : 0;
  const std::string_view rest = line.substr(begin);
  if ((rest.starts_with('#') && !is_row_all_the_same(line, row)) ||
      (options_.percent_too && rest.starts_with('%')) || std::ranges::all_of(rest, is_blank)) {
    if (const std::size_t at = line.find('\r'); at != std::string_view::npos) {
      fail(at, lone_carriage_return);
    }
    after_blank_ = after_blank_ || std::ranges::all_of(rest, is_blank);
    return false;
  }
  if (const auto defect = first_defect(line, true)) {
    fail(defect->offset, defect->what);
  }
  if (separator_ == '\0' && !options_.any_separator) {
    separator_ = first_separator(line, options_.blanks).value_or('\0');
  }
  const auto split_here = [&](auto separates) {
    return options_.blanks && look(line, separates) == Found::quotes
               ? split_at(line, AtBlanks(), row, lines_.number())
               : split_at(line, separates, row, lines_.number());
  };
  const auto defect = options_.any_separator ? split_here(AtAny()) : split_here(AtOne{separator()});
  if (defect) {
    fail(defect->offset, defect->what);
  }
  if (++rows_ > options_.most_rows) {
    fail(0, fmt::format("more than {} rows; give a list without repetitions", options_.most_rows));
  }
  const bool is_blank_row = std::ranges::all_of(row, is_empty);
  after_blank_ = after_blank_ || is_blank_row;
  return !is_blank_row;
}

std::optional<Row> RowReader::next() {
  after_blank_ = false;
  Row row;
  while (next_line()) {
    if (split(row)) {
      return row;
    }
  }
  return std::nullopt;
}

Row at_blanks(const Field& field, const RowReader& reader) {
  Row row;
  if (const auto defect = split_at(field.text, AtBlanks(), row, field.line)) {
    reader.fail(field, defect->what);
  }
  std::erase_if(row, is_empty);
  for (Field& part : row) {
    part.offset = field.offset + (reader.is_workbook() ? 0 : part.offset);
  }
  return row;
}

Row split_row(std::string_view line) {
  Row row;
  if (const auto defect = split_at(line, AtOne{','}, row)) {
    throw BadInput(defect->what);
  }
  return row;
}

std::string quoted_field(std::string_view field) {
  const bool plain = !field.empty() && field.find_first_of(",;\t\"") == std::string_view::npos &&
                     !is_blank(field.front()) && !is_blank(field.back()) && field.front() != '#';
  return plain ? std::string(field) : in_quotes(field);
}

std::string quoted_among_blanks(std::string_view field) {
  return std::ranges::any_of(field, is_blank) || field.starts_with('%') ? in_quotes(field)
                                                                        : quoted_field(field);
}

}  // namespace changeover
