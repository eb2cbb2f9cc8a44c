// What stands on a sheet: a title, figures, lines and tables, made once and written in every
// format.
//
//     TableDocument document{.title = "Pump bench", .lines = {"15 tests, 20 changes, cost 117"}};
//     document.sections.push_back({.heading = "Compared", .table = table});
//     document_markdown(document);
//
// Formats differ in what they can show; the fields say which shows what, nothing else does.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/table/table.hpp"

namespace changeover {

/// A number with its name: on a page in a row of large figures, in a workbook one line each.
struct Figure {
  std::string name;
  std::string words;
  ColumnKind kind = ColumnKind::number;
  unsigned in = in_html | in_workbook;
};

struct TableSection {
  std::string heading = {};                  ///< not in a workbook
  std::vector<std::string> page_lines = {};  ///< on pages only, above the table
  Table table = {};
  std::vector<std::string> notes = {};  ///< below the table
  unsigned in = everywhere;
  std::string css = {};         ///< class of the heading on a page
  std::string sheet = {};       ///< of the workbook; empty: below the title and the lines
  std::string sheet_head = {};  ///< printed at the top of the pages of that sheet; empty: the title
  bool hidden = false;          ///< that sheet is not shown
};

struct TableDocument {
  std::string title = {};
  std::string headline = {};  ///< the first of the lines; where a page has figures they say it
  std::vector<std::string> lines = {};  ///< where a page has figures, at its end
  std::vector<std::string> lists =
      {};  ///< lines with names of parts: the last of the lines, but not on a page
  std::vector<Figure> figures = {};
  std::vector<std::string> page_lines = {};  ///< on pages only, below the figures
  std::vector<TableSection> sections = {};
  std::string style = {};  ///< of a page
  std::string overview =
      {};  ///< the sheet of a workbook that has title, figures, lines and sections without a sheet
};

/// Headline, lines and lists.
[[nodiscard]] std::vector<std::string> all_lines(const TableDocument& document);

/// For a terminal: lists are broken between names where a line would be longer than `width`. A
/// table without rows is left out.
[[nodiscard]] std::string document_text(const TableDocument& document, std::size_t width);

/// The tables alone, one after the other.
[[nodiscard]] std::string document_csv(const TableDocument& document);

[[nodiscard]] std::string document_markdown(const TableDocument& document);

/// One page that needs nothing from outside.
[[nodiscard]] std::string document_html(const TableDocument& document);

/// The bytes of a workbook (.xlsx); the same for the same document. Texts are text, whatever they
/// look like, and so are
/// numbers of more than 15 digits. @throws MissingResource if there is no room for temporary files.
[[nodiscard]] std::string document_workbook(const TableDocument& document);

/// In the format of this word, "table", "csv", "markdown", "html" or "xlsx"; nothing for another
/// word.
[[nodiscard]] std::optional<std::string> document_as(std::string_view format,
                                                     const TableDocument& document,
                                                     std::size_t width);

}  // namespace changeover
