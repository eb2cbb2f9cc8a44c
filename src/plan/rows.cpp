#include "plan/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "io/place.hpp"

namespace changeover::plan_detail {
namespace {

struct Defect {
  std::size_t offset = 0;
  std::string what;
};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Reads the fields of one line, which begins at `start` in the text; a defect if they are malformed.
std::optional<Defect> split(std::string_view line, std::size_t start, char separator, Row& row) {
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank(line[at])) {
      ++at;
    }
  };
  for (;;) {
    skip_blanks();
    Field field{"", start + at};
    if (at < line.size() && line[at] == '"') {
      for (++at;; ++at) {
        if (at >= line.size()) {
          return Defect{field.offset, "a quote is opened and not closed on this line; close it"};
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
        return Defect{start + at, "text after a closing quote; double each quote within quotes"};
      }
    } else {
      const std::size_t end = std::min(line.find(separator, at), line.size());
      field.text = line.substr(at, end - at);
      while (!field.text.empty() && is_blank(field.text.back())) {
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

RowText::RowText(std::string_view text, std::string name)
    : text_(io_detail::without_byte_order_mark(text)), name_(std::move(name)) {}

void RowText::fail(std::size_t offset, std::string_view what) const {
  io_detail::fail(name_, io_detail::place_of(text_, offset), what);
}

std::vector<Row> RowText::rows() const {
  std::vector<Row> rows;
  char separator = '\0';
  for (std::size_t start = 0; start < text_.size();) {
    const std::size_t end = std::min(text_.find('\n', start), text_.size());
    std::string_view line = std::string_view(text_).substr(start, end - start);
    line.remove_suffix(line.ends_with('\r') ? 1 : 0);
    const std::size_t begin = std::exchange(start, end + 1);
    if (line.starts_with('#') || std::all_of(line.begin(), line.end(), is_blank)) {
      continue;
    }
    const auto control = std::find_if(line.begin(), line.end(), [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return (byte < 0x20 && byte != '\t') || byte == 0x7f;
    });
    if (control != line.end()) {
      fail(begin + static_cast<std::size_t>(control - line.begin()),
           fmt::format("control byte 0x{:02x}; the input must be plain text",
                       static_cast<unsigned char>(*control)));
    }
    if (separator == '\0') {
      const std::size_t first = line.find_first_of(",;");
      separator = first != std::string_view::npos && line[first] == ';' ? ';' : ',';
    }
    Row row;
    if (const auto defect = split(line, begin, separator, row)) {
      fail(defect->offset, defect->what);
    }
    const bool empty =
        std::all_of(row.begin(), row.end(), [](const Field& f) { return f.text.empty(); });
    if (!empty) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Row split_row(std::string_view line) {
  Row row;
  if (const auto defect = split(line, 0, ',', row)) {
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

}  // namespace changeover::plan_detail
