#include "io/table/table_document.hpp"

#include <fmt/format.h>

namespace changeover {
namespace {

// The sections that a format shows.
template <typename Write>
void each_section(const TableDocument& document, TableFormats format, Write&& write) {
  for (const TableSection& section : document.sections) {
    if ((section.in & format) != 0) {
      write(section);
    }
  }
}

std::string paragraphs(const std::vector<std::string>& lines, std::string_view start) {
  std::string text;
  for (const std::string& line : lines) {
    text += fmt::format("{}{}</p>\n", start, html_text(line));
  }
  return text;
}

constexpr std::string_view small = "<p class=\"small\">";

}  // namespace

std::vector<std::string> all_lines(const TableDocument& document) {
  std::vector<std::string> lines;
  if (!document.headline.empty()) {
    lines.push_back(document.headline);
  }
  lines.insert(lines.end(), document.lines.begin(), document.lines.end());
  lines.insert(lines.end(), document.lists.begin(), document.lists.end());
  return lines;
}

std::string document_text(const TableDocument& document, std::size_t width) {
  std::string text = document.title.empty() ? "" : document.title + "\n";
  for (const std::string& line : all_lines(document)) {
    text += line + "\n";
  }
  each_section(document, in_text, [&](const TableSection& section) {
    std::string part = section.heading.empty() ? "" : section.heading + "\n";
    part += section.table.rows == 0 ? "" : table_text(section.table, width);
    text += (text.empty() || part.empty() ? "" : "\n") + part;
    for (const std::string& note : section.notes) {
      text += note + "\n";
    }
  });
  return text;
}

std::string document_csv(const TableDocument& document) {
  std::string text;
  each_section(document, in_csv,
               [&](const TableSection& section) { text += table_csv(section.table); });
  return text;
}

std::string document_markdown(const TableDocument& document) {
  std::string text = document.title.empty() ? "" : "# " + markdown_text(document.title) + "\n\n";
  for (const std::string& line : all_lines(document)) {
    text += "- " + markdown_text(line) + "\n";
  }
  each_section(document, in_markdown, [&](const TableSection& section) {
    text += text.empty() ? "" : "\n";
    text += section.heading.empty() ? "" : "## " + markdown_text(section.heading) + "\n\n";
    text += table_markdown(section.table) + (section.notes.empty() ? "" : "\n");
    for (const std::string& note : section.notes) {
      text += "- " + markdown_text(note) + "\n";
    }
  });
  return text;
}

std::string document_html(const TableDocument& document) {
  std::string figures;
  for (const Figure& figure : document.figures) {
    if ((figure.in & in_html) != 0) {
      figures += fmt::format("  <div><dt>{}</dt><dd>{}</dd></div>\n", figure.name,
                             html_text(figure.words));
    }
  }
  std::string body =
      figures.empty() ? paragraphs({document.headline}, small) + paragraphs(document.lines, small)
                      : "<dl>\n" + figures + "</dl>\n";
  body += paragraphs(document.page_lines, "<p>");
  each_section(document, in_html, [&](const TableSection& section) {
    if (!section.heading.empty()) {
      body += fmt::format("<h2{}>{}</h2>\n",
                          section.css.empty() ? "" : fmt::format(" class=\"{}\"", section.css),
                          html_text(section.heading));
    }
    body += paragraphs(section.page_lines, "<p>") + table_html(section.table) +
            paragraphs(section.notes, "<p>");
  });
  body += figures.empty() ? "" : paragraphs(document.lines, small);
  return html_page(document.title, document.style, body);
}

std::string html_page(std::string_view title, std::string_view style, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{2}"
      "</body>\n</html>\n",
      html_text(title), style, body);
}

std::optional<std::string> document_as(std::string_view format, const TableDocument& document,
                                       std::size_t width) {
  if (format == "table") {
    return document_text(document, width);
  }
  const auto write = format == "csv"        ? document_csv
                     : format == "markdown" ? document_markdown
                     : format == "html"     ? document_html
                     : format == "xlsx"     ? document_workbook
                                            : nullptr;
  return write == nullptr ? std::nullopt : std::optional(write(document));
}

}  // namespace changeover
