// Documents as workbooks.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>
#include <xlsxwriter.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/tables.hpp"
#include "core/each.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "io/table/table_document.hpp"
#include "io/workbook/cell_text.hpp"

namespace changeover {
namespace {

// A file without a name: the library writes files only, and this one cannot be left behind.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("workbook", MFD_CLOEXEC)) {
    if (descriptor_ < 0) {
      throw MissingResource("no memory for the workbook; close other programs");
    }
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }
  [[nodiscard]] std::string bytes() const { return read_to_end(*open_input(path())); }

 private:
  int descriptor_;
};

void check(lxw_error error) {
  if (error == LXW_ERROR_MEMORY_MALLOC_FAILED) {
    throw std::bad_alloc();
  }
  if (error != LXW_NO_ERROR) {
    throw MissingResource(fmt::format("cannot make the workbook: {}; make room for temporary files",
                                      lxw_strerror(error)));
  }
}

class Workbook {
 public:
  Workbook() : book_(workbook_new(file_.path().c_str())) {
    if (book_ == nullptr) {
      throw std::bad_alloc();
    }
    wrapped = format([](lxw_format* f) {
      format_set_num_format(f, "@");
      format_set_text_wrap(f);
    });
    for (const bool bold : {false, true}) {
      for (const bool group : {false, true}) {
        texts[bold][group] = format([&](lxw_format* f) {
          constexpr lxw_color_t pale_yellow = 0xFFF2CC;
          format_set_num_format(f, "@");
          if (bold) {
            format_set_bold(f);
            format_set_bg_color(f, pale_yellow);
          }
          if (group) {
            format_set_left(f, LXW_BORDER_THIN);
          }
        });
      }
    }
    text = texts[0][0];
    right = format([](lxw_format* f) {
      format_set_num_format(f, "@");
      format_set_align(f, LXW_ALIGN_RIGHT);
    });
    for (const bool group : {false, true}) {
      heads[group] = format([&](lxw_format* f) {
        format_set_bold(f);
        format_set_text_wrap(f);
        format_set_bottom(f, LXW_BORDER_MEDIUM);
        if (group) {
          format_set_left(f, LXW_BORDER_THIN);
        }
      });
    }
    title = format([](lxw_format* f) {
      constexpr double large = 14;
      format_set_bold(f);
      format_set_font_size(f, large);
    });
    count = format([](lxw_format* f) { format_set_num_format(f, "0"); });
  }
  ~Workbook() {
    if (book_ != nullptr) {
      lxw_workbook_free(book_);
    }
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

  template <typename Set>
  lxw_format* format(Set&& set) {
    lxw_format* const made = workbook_add_format(book_);
    if (made == nullptr) {
      throw std::bad_alloc();
    }
    format_set_align(made, LXW_ALIGN_VERTICAL_TOP);
    set(made);
    return made;
  }

  // The format of costs with this number of decimals.
  lxw_format* cost(std::size_t decimals) {
    const std::string code = decimals == 0 ? "#,##0" : "#,##0." + std::string(decimals, '0');
    return format([&](lxw_format* f) { format_set_num_format(f, code.c_str()); });
  }

  lxw_worksheet* sheet(const char* name) {
    lxw_worksheet* const made = workbook_add_worksheet(book_, name);
    if (made == nullptr) {
      throw std::bad_alloc();
    }
    return made;
  }

  // The same document makes the same bytes: the date is that of the members of the archive.
  void describe(const std::string& what) {
    std::string words = what.substr(0, longest_property(what));
    lxw_doc_properties properties = {};
    properties.title = words.data();
    std::tm date = {};
    date.tm_year = 80;
    date.tm_mday = 1;
    properties.created = timegm(&date);
    check(workbook_set_properties(book_, &properties));
  }

  std::string bytes() {
    lxw_workbook* const book = std::exchange(book_, nullptr);
    check(workbook_close(book));  // and frees it
    return file_.bytes();
  }

  std::array<std::array<lxw_format*, 2>, 2>
      texts;  // bold, at the beginning of a group; stay text when edited
  std::array<lxw_format*, 2> heads;
  lxw_format* text;
  lxw_format* right;  // among numbers: times on a clock, and numbers of too many digits
  lxw_format* wrapped;
  lxw_format* title;
  lxw_format* count;

 private:
  // At most so many bytes, and whole letters.
  static std::size_t longest_property(const std::string& text) {
    constexpr std::size_t most = 200;
    std::size_t end = 0;
    while (end < text.size()) {
      const std::size_t next = end + first_code_point(std::string_view(text).substr(end)).bytes;
      if (next > most) {
        break;
      }
      end = next;
    }
    return end;
  }

  MemoryFile file_;
  lxw_workbook* book_;
};

// What a number in words is to a workbook: nothing if its 15 digits do not hold it, or if it is
// more than a number.
std::optional<double> number_in(const std::string& words) {
  constexpr double most = 1e9;  // with six decimals
  const auto number = parsed<double>(words);
  return number && *number < most ? number : std::nullopt;
}

// Writes one sheet and remembers how wide its columns must be.
class SheetWriter {
 public:
  SheetWriter(Workbook& book, const std::string& name)
      : book_(&book), sheet_(book.sheet(name.c_str())) {}

  // Cells below each other, and beside each other.
  void title(const std::string& words) { text(row_++, 0, words, book_->title); }

  void figure(const Figure& figure) {
    wide_text(++row_, 0, figure.name, book_->text);
    number(row_, 1, figure.words, figure.kind);
  }

  void gap() { ++row_; }

  // A line over the first seven columns, as high as it needs.
  void paragraph(const std::string& words) {
    constexpr lxw_col_t last = 6;
    constexpr std::size_t letters_a_line = 90;
    constexpr double height = 15;
    const std::size_t lines = 1 + display_width(words) / letters_a_line;
    ++row_;
    check(worksheet_merge_range(sheet_, row_, 0, row_, last, with_escapes(words).c_str(),
                                book_->wrapped));
    check(worksheet_set_row(sheet_, row_, height * static_cast<double>(lines), nullptr));
  }

  void table(const Table& table) {
    const std::vector<const TableColumn*> columns = columns_in(table, in_workbook);
    const lxw_row_t head = row_;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      wide_text(head, c, head_line(*columns[c], in_workbook),
                book_->heads[columns[c]->style.begins_group]);
    }
    for (std::size_t i = 0; i < table.rows; ++i) {
      ++row_;
      for (std::size_t c = 0; c < columns.size(); ++c) {
        cell(row_, c, columns[c]->style, columns[c]->cell(i));
      }
    }
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c]->style.kind == ColumnKind::list) {
        constexpr std::size_t of_lists = 24;
        widen(c, of_lists);
      }
      if (table.rows > 0 && !columns[c]->style.choices.words.empty()) {
        offer(columns[c]->style.choices, c, head + 1, row_);
      }
    }
  }

  // The table is the sheet: its head stays in sight, and is on each page.
  void table_alone(const Table& whole, const std::string& page_head) {
    constexpr std::size_t most_upright = 12;
    table(whole);
    const std::vector<const TableColumn*> columns = columns_in(whole, in_workbook);
    print_set_up(page_head, columns.size() > most_upright);
    worksheet_gridlines(sheet_, LXW_SHOW_ALL_GRIDLINES);
    worksheet_freeze_panes(sheet_, 1, 0);
    check(worksheet_repeat_rows(sheet_, 0, 0));
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c]->style.kind == ColumnKind::notes) {
        constexpr double of_notes = 40;
        check(worksheet_set_column(sheet_, at(c), at(c), of_notes, book_->wrapped));
      }
    }
    if (whole.rows > 0) {  // Numbers that are names are meant as text.
      check(worksheet_ignore_errors(sheet_, LXW_IGNORE_NUMBER_STORED_AS_TEXT,
                                    fmt::format("A2:XFD{}", whole.rows + 1).c_str()));
    }
  }

  void hide() { worksheet_hide(sheet_); }

  // Pages as wide as the sheet.
  void print_set_up(const std::string& page_head, bool landscape) {
    constexpr std::uint8_t a4 = 9;
    for (std::size_t column = 0; column < widths_.size(); ++column) {
      check(worksheet_set_column(sheet_, at(column), at(column),
                                 static_cast<double>(widths_[column]) + 1.5, nullptr));
    }
    worksheet_set_paper(sheet_, a4);
    landscape ? worksheet_set_landscape(sheet_) : worksheet_set_portrait(sheet_);
    worksheet_fit_to_pages(sheet_, 1, 0);
    constexpr std::size_t longest_header = 200;
    std::string header = "&L";
    for (const char c : page_head) {
      header += c == '&' ? "&&" : std::string(1, c);
    }
    if (header.size() <= longest_header) {
      check(worksheet_set_header(sheet_, header.c_str()));
    }
    check(worksheet_set_footer(sheet_, "&CPage &P of &N"));
  }

 private:
  static constexpr std::size_t least_width = 4;
  static constexpr std::size_t most_width = 32;

  [[nodiscard]] static lxw_col_t at(std::size_t column) { return static_cast<lxw_col_t>(column); }

  void text(lxw_row_t row, std::size_t column, const std::string& words, lxw_format* format) {
    if (!words.empty()) {
      check(worksheet_write_string(sheet_, row, at(column), with_escapes(words).c_str(), format));
    }
  }

  // A column is as wide as what is written with this.
  void wide_text(lxw_row_t row, std::size_t column, const std::string& words, lxw_format* format) {
    text(row, column, words, format);
    widen(column, display_width(words));
  }

  void number(lxw_row_t row, std::size_t column, const std::string& words, ColumnKind kind) {
    const std::optional<double> number = number_in(words);
    if (!number) {
      return wide_text(row, column, words, book_->right);
    }
    const bool is_cost = kind == ColumnKind::cost;
    check(worksheet_write_number(sheet_, row, at(column), *number,
                                 is_cost ? cost_format(words) : book_->count));
    widen(column, words.size() + (is_cost ? words.size() / 3 : 0));
  }

  void cell(lxw_row_t row, std::size_t column, const ColumnStyle& style, const TableCell& cell) {
    const ColumnKind kind = style.kind;
    const bool bold = !cell.bold.empty() && cell.bold.front();
    if (kind == ColumnKind::list) {
      text(row, column, list_line(cell.words), book_->wrapped);
    } else if (kind == ColumnKind::number || kind == ColumnKind::cost) {
      number(row, column, joined(cell.words), kind);
    } else {
      if (cell.words.empty() && style.begins_group) {
        check(worksheet_write_blank(sheet_, row, at(column), book_->texts[0][1]));
      }
      wide_text(row, column, joined(cell.words), book_->texts[bold][style.begins_group]);
    }
  }

  lxw_format* cost_format(const std::string& words) {
    const std::size_t point = words.find('.');
    const std::size_t decimals = point == std::string::npos ? 0 : words.size() - point - 1;
    costs_.resize(std::max(costs_.size(), decimals + 1), nullptr);
    lxw_format*& format = costs_[decimals];
    format = format == nullptr ? book_->cost(decimals) : format;
    return format;
  }

  // A list to choose from; other words are taken, too.
  void offer(const Choices& choices, std::size_t column, lxw_row_t first, lxw_row_t last) {
    Choices said = choices;  // the library asks for characters that it may write to
    // Pointers to char or const char, as the version of the library has it.
    std::vector<std::remove_pointer_t<decltype(lxw_data_validation::value_list)>> list;
    list.reserve(said.words.size() + 1);
    for (std::string& word : said.words) {
      list.push_back(word.data());
    }
    list.push_back(nullptr);
    lxw_data_validation choice = {};
    choice.validate = LXW_VALIDATION_TYPE_LIST;
    choice.value_list = list.data();
    choice.error_type = LXW_VALIDATION_ERROR_TYPE_INFORMATION;
    choice.error_title = said.title.data();
    choice.error_message = said.message.data();
    check(worksheet_data_validation_range(sheet_, first, at(column), last, at(column), &choice));
  }

  void widen(std::size_t column, std::size_t letters_wide) {
    widths_.resize(std::max(widths_.size(), column + 1), least_width);
    widths_[column] = std::max(widths_[column], std::min(letters_wide, most_width));
  }

  Workbook* book_;
  lxw_worksheet* sheet_;
  lxw_row_t row_ = 0;
  std::vector<lxw_format*> costs_;  // by decimals
  std::vector<std::size_t> widths_;
};

void write_overview(Workbook& book, const TableDocument& document) {
  SheetWriter writer(book, document.overview);
  writer.title(document.title);
  const auto figures = std::ranges::count_if(
      document.figures, [](const Figure& figure) { return (figure.in & in_workbook) != 0; });
  for (const Figure& figure : document.figures) {
    if ((figure.in & in_workbook) != 0) {
      writer.figure(figure);
    }
  }
  if (figures > 0) {
    writer.gap();
  }
  for (const std::string& line : all_lines(document)) {
    writer.paragraph(line);
  }
  for (const TableSection& section : document.sections) {
    if ((section.in & in_workbook) != 0 && section.sheet.empty()) {
      writer.gap();
      writer.gap();
      writer.table(section.table);
    }
  }
  writer.print_set_up(document.title, true);
}

}  // namespace

std::string document_workbook(const TableDocument& document) {
  Workbook book;
  book.describe(document.title);
  bool has_overview = false;
  for (const TableSection& section : document.sections) {
    if ((section.in & in_workbook) == 0) {
      continue;
    }
    if (!section.sheet.empty()) {
      SheetWriter writer(book, section.sheet);
      writer.table_alone(section.table,
                         section.sheet_head.empty() ? document.title : section.sheet_head);
      if (section.hidden) {
        writer.hide();
      }
    } else if (!std::exchange(has_overview, true)) {
      write_overview(book, document);
    }
  }
  return book.bytes();
}

}  // namespace changeover
