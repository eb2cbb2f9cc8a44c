#include "io/workbook/workbook_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/row_reader.hpp"
#include "io/scan/xml_events.hpp"
#include "io/workbook/merged_cells.hpp"
#include "io/workbook/workbook_parts.hpp"

namespace changeover {
namespace {

constexpr std::string_view zip_mark = "PK\x03\x04";
constexpr std::string_view empty_zip_mark = "PK\x05\x06";
constexpr std::string_view old_mark = "\xD0\xCF\x11\xE0";  // .xls, and .xlsx with a password
constexpr std::uint64_t most_sheet_bytes = std::uint64_t{1} << 29;
constexpr std::uint64_t most_row_bytes = std::uint64_t{1} << 24;
constexpr std::uint64_t most_text_bytes = std::uint64_t{1} << 30;

// The archive, once it is clear that it is one.
ZipArchive open_archive(std::string bytes, const std::string& file) {
  if (bytes.starts_with(old_mark)) {
    std::string encrypted;
    for (const char c : std::string_view("EncryptedPackage")) {  // in UTF-16
      encrypted += c;
      encrypted += '\0';
    }
    throw BadInput(
        file + (bytes.find(encrypted) != std::string::npos
                    ? ": the workbook has a password; save it without one"
                    : ": an old workbook (.xls); save it as an Excel workbook (.xlsx) or as CSV"));
  }
  return {std::move(bytes), file};
}

// The cells of a sheet as rows.
class Rows final : public XmlHandler {
 public:
  Rows(const WorkbookParts& parts, std::string place, std::vector<MergedRange> merged)
      : parts_(&parts), place_(std::move(place)), merged_(std::move(merged), place_) {}

  void begin(std::string_view name, const XmlAttributes& attributes) override {
    if (name == "sheetData") {
      in_data_ = true;
    } else if (!in_data_) {
      return;
    } else if (name == "row") {
      begin_row(attributes);
    } else if (name == "c") {
      begin_cell(attributes);
    } else if (name == "rPh") {
      aloud_ = true;
    } else if (name == "f") {
      has_formula_ = true;
    }
    in_value_ = in_cell_ && (name == "v" || (name == "t" && !aloud_));
  }

  void end(std::string_view name) override {
    in_value_ = false;
    if (name == "sheetData") {
      in_data_ = false;
    } else if (name == "rPh") {
      aloud_ = false;
    } else if (name == "c" && in_cell_) {
      end_cell();
    } else if (name == "row" && !row_.cells.empty()) {
      count(merged_.fill(row_));
      rows_.push_back(std::move(row_));
      row_.cells.clear();
      row_.across.clear();
    }
  }

  void text(std::string_view piece) override {
    if (in_value_) {
      value_ += piece;
      if (value_.size() > longest_cell) {
        fail("more than 32,767 characters; this is not a list");
      }
    }
  }

  [[nodiscard]] std::deque<SheetRow>& rows() { return rows_; }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    throw BadInput(fmt::format("{}!{}: {}", place_, cell_name(column_, row_.number), what));
  }

  void begin_row(const XmlAttributes& attributes) {
    const std::uint64_t before = row_.number;
    std::uint64_t number = before + 1;
    if (const auto given = attributes.find("r")) {
      number = parsed<std::uint64_t>(*given).value_or(0);
    }
    if (number <= before || number > most_sheet_rows) {
      throw BadInput(
          fmt::format("{}: the row after row {} is misnumbered; save it again", place_, before));
    }
    row_.number = number;
    row_bytes_ = 0;
    next_column_ = 0;
  }

  void begin_cell(const XmlAttributes& attributes) {
    column_ = next_column_;
    if (const auto given = attributes.find("r")) {
      const auto place = cell_place(*given);
      if (!place || place->row != row_.number || place->column < next_column_) {
        throw BadInput(fmt::format("{}: row {} has a cell called {}; save it again", place_,
                                   row_.number, shown(*given)));
      }
      column_ = place->column;
    }
    if (column_ >= most_sheet_columns) {
      fail("a column beyond the last; save it again");
    }
    next_column_ = column_ + 1;
    type_ = attributes.find("t").value_or("n");
    style_ = attributes.find("s").value_or("0");
    value_.clear();
    has_formula_ = false;
    in_cell_ = true;
  }

  void end_cell() {
    in_cell_ = false;
    if (has_formula_ && value_.empty() && type_ != "str") {
      fail(
          "the value of this formula is not stored in the file; open it in a spreadsheet program "
          "and save it");
    }
    std::string text = on_one_line(content());
    if (text.empty()) {
      return;
    }
    count(text.size());
    row_.cells.push_back({column_, std::move(text)});
  }

  void count(std::uint64_t bytes) {
    row_bytes_ += bytes;
    bytes_ += bytes;
    if (row_bytes_ > most_row_bytes) {
      fail("a row of more than 16 MiB; this is not a list");
    }
    if (bytes_ > most_text_bytes) {
      fail("more than 1 GiB; give a list without repetitions");
    }
  }

  [[nodiscard]] std::string content() const {
    if (type_ == "inlineStr" || type_ == "str") {
      return without_escapes(value_);
    }
    if (value_.empty()) {
      return {};
    }
    if (type_ == "s") {
      const auto number = number_in<std::uint64_t>(value_);
      if (!number || *number >= parts_->texts.size()) {
        fail("a text that the workbook does not have; save it again");
      }
      return parts_->texts[*number];
    }
    if (type_ == "b") {
      return value_ == "1" || value_ == "true" ? "TRUE" : "FALSE";
    }
    if (type_ == "e") {
      fail(fmt::format("the formula here results in {}; correct it", shown(value_)));
    }
    if (type_ == "d") {
      return value_;  // a date that is written out
    }
    if (type_ != "n") {
      fail(fmt::format("a cell of the unknown type {}; save it again", shown(type_)));
    }
    const auto number = number_in<double>(value_);
    if (!number || !std::isfinite(*number)) {
      fail(fmt::format("{} where a number belongs; save it again", shown(value_)));
    }
    const auto style = number_in<std::uint64_t>(style_);
    const bool is_date =
        style && *style < parts_->styles.size() && parts_->styles[*style] == NumberStyle::date;
    return is_date ? date_text(*number, parts_->from_1904) : number_text(*number);
  }

  template <typename Number>
  static std::optional<Number> number_in(std::string_view text) {
    const std::size_t start = std::min(text.find_first_not_of(" \n\r\t"), text.size());
    text.remove_prefix(start);
    return parsed<Number>(text.substr(0, text.find_last_not_of(" \n\r\t") + 1));
  }

  const WorkbookParts* parts_;
  std::string place_;
  MergedCells merged_;
  std::deque<SheetRow> rows_;
  SheetRow row_;
  std::uint64_t row_bytes_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t next_column_ = 0;
  std::uint64_t column_ = 0;
  std::string type_;
  std::string style_;
  std::string value_;
  bool has_formula_ = false;
  bool in_data_ = false;
  bool in_cell_ = false;
  bool in_value_ = false;
  bool aloud_ = false;
};

const WorkbookParts::Sheet& find_sheet(const WorkbookParts& parts, const std::string& file,
                                       const std::optional<std::string>& wanted) {
  std::string names;
  for (const WorkbookParts::Sheet& sheet : parts.sheets) {
    const bool found = wanted ? lower_case(sheet.name) == lower_case(*wanted)
                              : !sheet.hidden && !sheet.member.empty();
    if (found && sheet.member.empty()) {
      throw BadInput(
          fmt::format("{}: the sheet {} has no cells; name another", file, shown(sheet.name)));
    }
    if (found) {
      return sheet;
    }
    constexpr std::size_t enough = 200;
    if (!sheet.member.empty() && names.size() < enough) {
      names += (names.empty() ? "" : ", ") + shown(sheet.name);
    }
  }
  throw BadInput(!wanted ? file + ": the workbook has no sheet that can be read; save it again"
                         : fmt::format("{}: there is no sheet {}; there is {}", file,
                                       shown(*wanted), names.empty() ? "none" : names));
}

}  // namespace

bool begins_like_a_workbook(std::string_view beginning) {
  return beginning.starts_with(zip_mark) || beginning.starts_with(empty_zip_mark) ||
         beginning.starts_with(old_mark);
}

std::vector<SheetName> workbook_sheets(std::string bytes, const std::string& file) {
  std::vector<SheetName> names;
  for (const WorkbookParts::Sheet& sheet :
       workbook_parts(open_archive(std::move(bytes), file), file).sheets) {
    if (!sheet.member.empty()) {
      names.push_back({sheet.name, sheet.hidden});
    }
  }
  return names;
}

struct WorkbookSheet::State {
  State(std::string bytes, const std::string& file, const std::optional<std::string>& wanted)
      : archive(open_archive(std::move(bytes), file)),
        parts(workbook_parts(archive, file)),
        sheet(find_sheet(parts, file, wanted)),
        place(fmt::format("{}:{}", file, sheet.name)),
        rows(parts, place, merged_ranges(archive, sheet.member, most_sheet_bytes, place)),
        reader(fmt::format("{}:{}", file, sheet.member), rows),
        member(archive.open(sheet.member, most_sheet_bytes)) {
    if (!member) {
      throw BadInput(fmt::format("{}: its part {} is missing; save it again", file, sheet.member));
    }
  }

  ZipArchive archive;
  WorkbookParts parts;
  const WorkbookParts::Sheet& sheet;
  std::string place;
  Rows rows;
  XmlReader reader;
  std::optional<ZipArchive::Member> member;
  bool ended = false;
};

WorkbookSheet::WorkbookSheet(std::string bytes, const std::string& file,
                             const std::optional<std::string>& sheet)
    : state_(std::make_unique<State>(std::move(bytes), file, sheet)) {}

WorkbookSheet::~WorkbookSheet() = default;

std::optional<SheetRow> WorkbookSheet::next() {
  std::deque<SheetRow>& rows = state_->rows.rows();
  while (rows.empty() && !state_->ended) {
    const std::string piece = state_->member->next();
    if (piece.empty()) {
      state_->reader.finish();
      state_->ended = true;
    } else {
      state_->reader.feed(piece);
    }
  }
  if (rows.empty()) {
    return std::nullopt;
  }
  SheetRow row = std::move(rows.front());
  rows.pop_front();
  return row;
}

std::string WorkbookSheet::place(std::uint64_t column, std::uint64_t row) const {
  return fmt::format("{}!{}", state_->place, cell_name(column, row));
}

// A list is a file, or one sheet of a workbook.

namespace {

// Where "parts.xlsx:Costs" splits into a file and a sheet: at the last colon (names of sheets have
// none), if there is no file of the whole name, but one of the name before the colon.
std::optional<std::size_t> end_of_file(const std::string& path) {
  std::error_code ignored;
  const std::size_t colon = path.rfind(':');
  const bool splits = colon != std::string::npos && colon > 0 && colon + 1 < path.size() &&
                      !std::filesystem::exists(path, ignored) &&
                      std::filesystem::exists(path.substr(0, colon), ignored);
  return splits ? std::optional(colon) : std::nullopt;
}

}  // namespace

std::string list_file(const std::string& path) {
  return path.substr(0, end_of_file(path).value_or(path.size()));
}

std::unique_ptr<Input> open_list(const std::string& path) {
  if (const auto colon = end_of_file(path)) {
    return std::make_unique<SheetInput>(open_input(path.substr(0, *colon)),
                                        path.substr(*colon + 1));
  }
  return open_input(path);
}

}  // namespace changeover
