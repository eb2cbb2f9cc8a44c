#include "io/table/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <numeric>
#include <utility>

#include "changeover/io/tables.hpp"
#include "core/each.hpp"
#include "io/scan/row_reader.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/latex_prose.hpp"

namespace changeover {
namespace {

// A row of a table whose cells are texts.
std::string row_of(const std::vector<std::string>& cells, std::string_view start,
                   std::string_view between, std::string_view end) {
  return fmt::format("{}{}{}", start, fmt::join(cells, between), end);
}

// The heads and then the rows, each as `write` makes it of its texts.
template <typename Head, typename Cell, typename Write>
void each_row(const Table& table, const std::vector<const TableColumn*>& columns, Head&& head,
              Cell&& cell, Write&& write) {
  std::vector<std::string> cells(columns.size());
  std::ranges::transform(columns, cells.begin(),
                         [&](const TableColumn* column) { return head(*column); });
  write(cells);
  for (std::size_t row = 0; row < table.rows; ++row) {
    std::ranges::transform(columns, cells.begin(), [&](const TableColumn* column) {
      return cell(*column, column->cell(row));
    });
    write(cells);
  }
}

std::string class_of(std::string_view a, std::string_view b) {
  return a.empty() && b.empty()
             ? std::string()
             : fmt::format(" class=\"{}{}{}\"", a, a.empty() || b.empty() ? "" : " ", b);
}

// A head as a page has it, in one line.
std::string head_on_page(const TableColumn& column) {
  std::string text = head_line(column, in_html);
  if (!column.style.head_is_a_name) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return text;
}

std::string html_head(const TableColumn& column) {
  std::string text = html_text(head_on_page(column));
  if (const std::size_t at = column.head.find('\n'); at != std::string::npos) {
    text = html_text(head_on_page(column).substr(0, at)) + "<br>" +
           html_text(column.head.substr(at + 1));
  }
  return fmt::format("<th{}>{}</th>", class_of(is_right(column) ? "n" : "", column.style.head_css),
                     text);
}

// The style puts dots between names that stand side by side.
std::string html_list(const TableCell& cell) {
  constexpr std::size_t wide_name = 26;
  std::string text;
  for (std::size_t i = 0; i < cell.words.size(); ++i) {
    const bool bold = !cell.bold.empty() && cell.bold[i];
    const bool remarked = !cell.remarks.empty() && !cell.remarks[i].empty();
    std::string word = html_text(cell.words[i]);
    if (remarked) {
      word = fmt::format("<span class=\"name{}\">{}</span> <span class=\"small{}\">{}</span>",
                         bold ? " in" : "", word,
                         display_width(cell.remarks[i]) > wide_name ? "" : " name",
                         html_text(cell.remarks[i]));
    }
    text += fmt::format("{}<span class=\"part{}{}\">{}</span>", i == 0 ? "" : " ",
                        bold && !remarked ? " in" : "",
                        remarked || display_width(cell.words[i]) > wide_name ? " wide" : "", word);
  }
  return text;
}

std::string html_boxes(const TableColumn& column) {
  std::string text;
  const auto boxes = 1 + std::ranges::count(column.head, ' ');
  for (std::ptrdiff_t i = 0; i < boxes; ++i) {
    text += std::string(i == 0 ? "" : " ") + "<span class=\"box\"></span>";
  }
  return text;
}

// Words in bold, commas between them.
std::string markdown_cell(const TableCell& cell) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < cell.words.size(); ++i) {
    const bool bold = !cell.bold.empty() && cell.bold[i];
    const bool remarked = !cell.remarks.empty() && !cell.remarks[i].empty();
    words.push_back(fmt::format("{0}{1}{0}{2}{3}", bold ? "**" : "", markdown_text(cell.words[i]),
                                remarked ? " " : "",
                                remarked ? markdown_text(cell.remarks[i]) : ""));
  }
  return joined(words);
}

std::string html_cell(const TableColumn& column, const TableCell& cell) {
  switch (column.style.kind) {
    case ColumnKind::list:
      return html_list(cell);
    case ColumnKind::choice:
      return html_boxes(column);
    default:
      return html_text(joined(cell.words));
  }
}

}  // namespace

Table table_of(std::vector<std::pair<std::string, ColumnStyle>> heads,
               std::vector<std::vector<std::string>> rows) {
  Table table{.rows = rows.size(), .columns = {}};
  const auto cells = std::make_shared<const std::vector<std::vector<std::string>>>(std::move(rows));
  for (std::size_t c = 0; c < heads.size(); ++c) {
    table.columns.push_back({std::move(heads[c].first),
                             [cells, c](std::size_t row) { return cells->at(row).at(c); },
                             std::move(heads[c].second)});
  }
  return table;
}

Table kept_with(Table table, const std::shared_ptr<const void>& owner) {
  for (TableColumn& column : table.columns) {
    column.cell = [owner, cell = std::move(column.cell)](std::size_t row) { return cell(row); };
  }
  return table;
}

std::vector<const TableColumn*> columns_in(const Table& table, TableFormats format) {
  std::vector<const TableColumn*> columns;
  for (const TableColumn& column : table.columns) {
    if ((column.style.in & format) != 0) {
      columns.push_back(&column);
    }
  }
  return columns;
}

std::string head_line(const TableColumn& column, TableFormats format) {
  std::string head =
      (format & for_programs) != 0 && !column.style.name.empty() ? column.style.name : column.head;
  std::ranges::replace(head, '\n', ' ');
  return head;
}

bool is_right(const TableColumn& column) {
  const ColumnKind kind = column.style.kind;
  return kind == ColumnKind::number || kind == ColumnKind::cost || kind == ColumnKind::formula;
}

std::string table_csv(const Table& table) {
  std::string text;
  each_row(
      table, columns_in(table, in_csv),
      [](const TableColumn& column) { return csv_cell(head_line(column, in_csv)); },
      [](const TableColumn& column, const TableCell& cell) {
        return csv_cell(column.style.kind == ColumnKind::list ? list_line(cell.words)
                                                              : joined(cell.words));
      },
      [&](const std::vector<std::string>& cells) { text += row_of(cells, "", ",", "\n"); });
  return text;
}

std::string table_markdown(const Table& table) {
  const std::vector<const TableColumn*> columns = columns_in(table, in_markdown);
  std::string rule = "|";
  for (const TableColumn* column : columns) {
    rule += is_right(*column) ? "---:|" : ":---|";
  }
  rule += "\n";
  std::string text;
  each_row(
      table, columns,
      [](const TableColumn& column) { return markdown_text(head_line(column, in_markdown)); },
      [](const TableColumn&, const TableCell& cell) { return markdown_cell(cell); },
      [&](const std::vector<std::string>& cells) {
        text += row_of(cells, "| ", " | ", " |\n") + std::exchange(rule, "");
      });
  return text;
}

namespace {

// How wide LaTeX is set, in digits. Signs above and below each other share their place.
double latex_digits(std::string_view latex) {
  constexpr double index = 0.75;
  double digits = 0;
  double aside = 0;  // signs above and below what was set last
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const char sign = latex[i];
    if (sign == '^' || sign == '_') {
      const std::string_view rest = latex.substr(i + 1);
      const std::size_t length = rest.starts_with('{') ? std::min(rest.find('}'), rest.size()) : 1;
      aside = std::max(aside, index * latex_digits(rest.substr(0, length)));
      i += length;
      continue;
    }
    digits += std::exchange(aside, 0);
    if (sign == '\\') {
      while (i + 1 < latex.size() && std::isalpha(static_cast<unsigned char>(latex[i + 1])) != 0) {
        ++i;
      }
      digits += i + 1 < latex.size() && latex[i + 1] == '{' ? 0 : 1.5;
    } else if (sign == '=') {
      digits += 2.5;  // with the space around it
    } else if (sign != '{' && sign != '}' && sign != '$') {
      digits += 1;
    }
  }
  return digits + aside;
}

constexpr double broken_digits = 26;  // of a column of lists that has several lines in a cell

double column_digits(const Table& table, const TableColumn& column) {
  double digits = latex_digits(head_line(column, in_latex));
  for (std::size_t row = 0; row < table.rows; ++row) {
    digits = std::max(digits, latex_digits(joined(column.cell(row).words)));
  }
  return digits;
}

bool is_long(const TableColumn& column) {
  return column.style.kind == ColumnKind::list || column.style.kind == ColumnKind::remark;
}

bool is_broken(const Table& table, const TableColumn& column) {
  return is_long(column) && column_digits(table, column) > broken_digits;
}

std::string columns_latex(const Table& table, const std::vector<const TableColumn*>& columns) {
  constexpr std::size_t most_on_a_page = 40;
  const std::string environment = table.rows > most_on_a_page ? "longtable" : "tabular";
  std::string text = "\\begin{" + environment + "}{";
  std::vector<bool> broken;
  for (const TableColumn* column : columns) {
    broken.push_back(is_broken(table, *column));
    text += broken.back() ? "p{0.4\\linewidth}" : is_right(*column) ? "r" : "l";
  }
  text += "}\n\\toprule\n";
  std::string rule = environment == "tabular" ? "\\midrule\n" : "\\midrule\n\\endhead\n";
  const auto written = [](const TableColumn& column, const std::string& words) {
    if (column.style.kind == ColumnKind::formula) {
      return words;
    }
    // A bracket or a star at the start of a row would be an argument of the line break before it.
    const std::string before = words.starts_with('[') || words.starts_with('*') ? "{}" : "";
    // Names are no formulas: "A-1" and "A - 1" are two parts.
    return before +
           (column.style.kind == ColumnKind::list ? latex_escaped(words) : latex_prose(words));
  };
  each_row(
      table, columns,
      [&](const TableColumn& column) { return written(column, head_line(column, in_latex)); },
      [&](const TableColumn& column, const TableCell& cell) {
        return written(column, joined(cell.words));
      },
      [&](std::vector<std::string> cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
          cells[i] = broken[i] ? "{\\raggedright " + cells[i] + "\\par}" : cells[i];
        }
        text += row_of(cells, "", " & ", " \\\\\n") + std::exchange(rule, "");
      });
  return text + "\\bottomrule\n\\end{" + environment + "}\n";
}

}  // namespace

std::string table_latex(const Table& table) {
  // Widths in points in the class article: a line without an indent, a digit, and the space between
  // columns; then a digit and the space in small print.
  constexpr double line = 330;
  constexpr double digit = 5;
  constexpr double between = 12;
  constexpr double small_digit = 4.8;
  constexpr double small_between = 6;
  const std::vector<const TableColumn*> columns = columns_in(table, in_latex);
  std::vector<double> digits;
  for (const TableColumn* column : columns) {
    digits.push_back(column_digits(table, *column));
    if (is_long(*column)) {
      digits.back() = std::min(digits.back(), broken_digits);
    }
  }
  const auto all = std::accumulate(digits.begin(), digits.end(), 0.0);
  if (columns.size() < 2 || digit * all + between * static_cast<double>(columns.size()) <= line) {
    return columns_latex(table, columns);
  }
  // Small, and in as many tables as needed; each begins with the first column.
  std::string text = "\\begingroup\n\\small\\setlength{\\tabcolsep}{3pt}\n";
  for (std::size_t next = 1; next < columns.size();) {
    std::vector<const TableColumn*> some{columns.front()};
    double width = small_digit * digits.front() + small_between;
    do {
      width += small_digit * digits[next] + small_between;
      some.push_back(columns[next++]);
    } while (next < columns.size() && width + small_digit * digits[next] + small_between <= line);
    text += columns_latex(table, some) + (next < columns.size() ? "\n\\bigskip\n\n" : "");
  }
  return text + "\\endgroup\n";
}

std::string table_html(const Table& table) {
  const std::vector<const TableColumn*> columns = columns_in(table, in_html);
  std::string text = table.frame.empty() ? "" : fmt::format("<div{}>\n", class_of(table.frame, ""));
  text += fmt::format("<table{}>\n<thead><tr>", class_of(table.css, ""));
  for (const TableColumn* column : columns) {
    text += column->style.kind == ColumnKind::remark ? "" : html_head(*column);
  }
  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < table.rows; ++row) {
    std::string remarks;
    for (const TableColumn* column : columns) {
      if (column->style.kind == ColumnKind::remark) {
        remarks += fmt::format("<br><span class=\"small\">{}</span>",
                               html_cell(*column, column->cell(row)));
      }
    }
    text += "<tr>";
    for (const TableColumn* column : columns) {
      if (column->style.kind != ColumnKind::remark) {
        text += fmt::format(
            "<td{}{}>{}{}</td>", class_of(is_right(*column) ? "n" : "", column->style.css),
            table.css.empty() || column->style.kind == ColumnKind::choice ||
                    column->style.kind == ColumnKind::notes
                ? ""
                : fmt::format(" data-head=\"{}\"", html_text(head_on_page(*column))),
            html_cell(*column, column->cell(row)), column == columns.front() ? remarks : "");
      }
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table>\n" + (table.frame.empty() ? "" : "</div>\n");
}

std::string list_line(const std::vector<std::string>& words) { return joined(words, quoted_field); }

std::string markdown_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|~&").find(c) != std::string_view::npos) {
      escaped += '\\';
    }
    escaped += c;
  }
  return escaped;
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace changeover
