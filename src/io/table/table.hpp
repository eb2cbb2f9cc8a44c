// A table that every format can write: what its columns are, and how each makes its cells.
//
//     const Table table{.rows = names.size(),
//                       .columns = {{"part", [&](std::size_t i) { return TableCell(names[i]); }},
//                                   {"change cost",
//                                    [&](std::size_t i) { return TableCell(costs[i]); },
//                                    {.kind = ColumnKind::cost}}}};
//     table_text(table, 80);      // for a terminal of 80 columns
//     table_markdown(table);      // the same cells, escaped as Markdown asks
//
// A cell is made when a format asks for it, so that a table of many rows needs no additional memory
// and a column that a
// format leaves out costs nothing. What the functions refer to must outlive the table.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace changeover {

/// What a column holds, which says how each format writes it.
enum class ColumnKind {
  text,
  list,     ///< names: lines break between them, a file quotes those with commas in them
  number,   ///< decimal, to the right; words in it ("+1 (0.9 %)") are to the right as well
  formula,  ///< LaTeX that stands as it is, to the right; for LaTeX only
  cost,     ///< a number whose thousands a workbook sets apart
  /// a text of some length: a page has it in small letters below the first cell of the row
  remark,
  choice,  ///< to be filled in with a word: a page has a box for each word of the head
  notes,   ///< to be filled in by hand
};

/// The formats, and those that a column or a piece of a document is in.
enum TableFormats : unsigned {
  in_text = 1,
  in_csv = 2,
  in_markdown = 4,
  in_html = 8,
  in_workbook = 16,
  in_latex = 32,
  for_people = in_text | in_markdown | in_html | in_latex,
  for_programs = in_csv | in_workbook,
  everywhere = for_people | for_programs,
};

/// Words that are never broken: one of a text or a number, any number of a list, none of an empty
/// cell.
struct TableCell {
  TableCell() = default;
  TableCell(std::string word) : words{std::move(word)} {}
  TableCell(std::vector<std::string> list, std::vector<bool> which = {})
      : words(std::move(list)), bold(std::move(which)) {}

  std::vector<std::string> words;
  std::vector<bool> bold;    ///< by word, in all but texts; all false if empty
  std::vector<bool> breaks;  ///< by word: on a terminal it begins a line; all false if empty
  std::vector<std::string>
      remarks;  ///< by word: what stands after it where people read, never bold; none if empty
};

/// What a workbook offers for the cells of a column; other words are taken too, with this message.
struct Choices {
  std::vector<std::string> words;
  std::string title;
  std::string message;
};

struct ColumnStyle {
  ColumnKind kind = ColumnKind::text;
  unsigned in = everywhere;
  std::string name = {};        ///< the head for programs, if not the same
  std::size_t least_width = 0;  ///< on a terminal
  std::string css = {};         ///< class of its cells on a page
  std::string head_css = {};    ///< class of its head
  Choices choices = {};
  bool begins_group = false;    ///< a workbook has a line before the column, if it is of texts
  bool head_is_a_name = false;  ///< a page does not begin it with a capital
};

inline const ColumnStyle number_column{.kind = ColumnKind::number};
inline const ColumnStyle cost_column{.kind = ColumnKind::cost};

struct TableColumn {
  std::string head;  ///< a line break in it is one on a page and a blank elsewhere
  std::function<TableCell(std::size_t row)> cell;
  ColumnStyle style = {};
};

struct Table {
  std::size_t rows = 0;
  std::vector<TableColumn> columns;
  std::string css = {};    ///< class of the table on a page
  std::string frame = {};  ///< class of what stands around it there; empty: nothing does
};

/// A table of texts that are there already, by row.
[[nodiscard]] Table table_of(std::vector<std::pair<std::string, ColumnStyle>> heads,
                             std::vector<std::vector<std::string>> rows);

/// The table with an owner of the data that its cells refer to.
[[nodiscard]] Table kept_with(Table table, const std::shared_ptr<const void>& owner);

/// The columns that a format shows.
[[nodiscard]] std::vector<const TableColumn*> columns_in(const Table& table, TableFormats format);

/// The head in a line; the name where a program reads it.
[[nodiscard]] std::string head_line(const TableColumn& column, TableFormats format);

/// Whether a column is set to the right.
[[nodiscard]] bool is_right(const TableColumn& column);

/// For a terminal: no wider than `width` unless words are.
[[nodiscard]] std::string table_text(const Table& table, std::size_t width);

/// In LF lines; no cell is a formula (io/write/csv_cell.hpp).
[[nodiscard]] std::string table_csv(const Table& table);

/// In the style of GitHub.
[[nodiscard]] std::string table_markdown(const Table& table);

/// <table>, for the page of table_document.hpp.
[[nodiscard]] std::string table_html(const Table& table);

/// For the package booktabs; a table of more than 40 rows is a longtable (package longtable).
[[nodiscard]] std::string table_latex(const Table& table);

/// Words with commas between them, each quoted where it must be so that row readers
/// (io/scan/row_reader.hpp) find the words again.
[[nodiscard]] std::string list_line(const std::vector<std::string>& words);

/// A text in Markdown, or in HTML: nothing in it is markup.
[[nodiscard]] std::string markdown_text(std::string_view text);
[[nodiscard]] std::string html_text(std::string_view text);

/// A whole page; `body` is HTML.
[[nodiscard]] std::string html_page(std::string_view title, std::string_view style,
                                    std::string_view body);

}  // namespace changeover
