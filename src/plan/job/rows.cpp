#include "plan/job/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
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
  changeover::fail(input_->name(), {std::max<std::uint64_t>(1, line_number_), offset + 1}, what);
}

void RowReader::fail(const Field& field, std::string_view what) const {
  changeover::fail(input_->name(), {field.line, field.offset + 1}, what);
}

bool RowReader::next_line() {
  std::size_t searched = begin_;
  std::size_t end = buffer_.find('\n', searched);
  while (end == std::string::npos && !ended_) {
    constexpr std::size_t piece = std::size_t{1} << 16;
    buffer_.erase(0, std::exchange(begin_, 0));
    searched = buffer_.size();
    buffer_.resize(searched + piece);
    const std::size_t count = input_->read(std::span(buffer_).subspan(searched));
    buffer_.resize(searched + count);
    ended_ = count == 0;
    bytes_ += count;
    end = buffer_.find('\n', searched);
    if (buffer_.size() - begin_ > longest_line && end == std::string::npos) {
      ++line_number_;
      const auto defect = first_defect(std::string_view(buffer_).substr(begin_), true);
      fail(defect ? defect->offset : 0,
           defect ? defect->what : "a line of more than 16 MiB; this is no list");
    }
    if (bytes_ > most_bytes) {
      ++line_number_;
      fail(0, "more than 1 GiB; give a list without repetitions");
    }
  }
  if (end == std::string::npos && begin_ == buffer_.size()) {
    return false;
  }
  const std::size_t stop = std::min(end, buffer_.size());
  line_.assign(buffer_, begin_, stop - begin_);
  begin_ = std::min(stop + 1, buffer_.size());
  if (++line_number_ == 1) {
    line_ = std::string(without_byte_order_mark(line_));
  }
  if (line_.ends_with('\r')) {
    line_.pop_back();
  }
  return true;
}

std::optional<Row> RowReader::next() {
  while (next_line()) {
    constexpr std::uint64_t now_and_then = 256;
    if (line_number_ % now_and_then == 0) {
      stop_if_asked();
    }
    if (line_.starts_with('#') || std::all_of(line_.begin(), line_.end(), is_blank)) {
      continue;
    }
    if (const auto defect = first_defect(line_, true)) {
      fail(defect->offset, defect->what);
    }
    if (separator_ == '\0') {
      separator_ = first_separator(line_).value_or('\0');
    }
    Row row;
    if (const auto defect = split(line_, separator(), row, line_number_)) {
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
