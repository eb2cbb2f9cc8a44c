// Whether a file is what the end of its name says, looked at by readers that are not ours.
#pragma once

#include <expat.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "zip_files.hpp"

namespace changeover::test {

inline bool is_xml(const std::string& text) {
  XML_Parser parser = XML_ParserCreate("UTF-8");
  const bool good =
      XML_Parse(parser, text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_OK;
  XML_ParserFree(parser);
  return good;
}

/// The rows of CSV as RFC 4180 has it; none if a quote stands where it may not. Lines with # before
/// the first row are passed over.
inline std::vector<std::vector<std::string>> csv_rows(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row{""};
  bool quoted = false;
  bool closed = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (rows.empty() && row.size() == 1 && row[0].empty() && c == '#') {
      i = text.find('\n', i);
      continue;
    }
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      row.back() += text[++i];
    } else if (quoted && c == '"') {
      quoted = false;
      closed = true;
    } else if (quoted) {
      row.back() += c;
    } else if (c == '"' && row.back().empty() && !closed) {
      quoted = true;
    } else if (c == ',' || c == '\n') {
      closed = false;
      if (c == '\n') {
        rows.push_back(row);
        row.clear();
      }
      row.emplace_back();
    } else if (c == '"' || closed) {
      return {};
    } else {
      row.back() += c;
    }
  }
  return quoted || row.size() != 1 || !row[0].empty() ? std::vector<std::vector<std::string>>()
                                                      : rows;
}

inline bool is_csv(const std::string& text) {
  const auto rows = csv_rows(text);
  return rows.size() > 1 && std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
           return row.size() == rows[0].size() && row.size() > 1;
         });
}

inline bool is_json(const std::string& text) { return nlohmann::json::accept(text); }

/// One object per line.
inline bool is_json_lines(const std::string& text) {
  std::istringstream lines(text);
  bool good = true;
  for (std::string line; std::getline(lines, line);) {
    good = good && nlohmann::json::accept(line) && line.starts_with('{');
  }
  return good;
}

inline bool is_page(const std::string& text) {
  return text.starts_with("<!DOCTYPE html>") && text.ends_with("</html>\n");
}

/// With sheets of well-formed XML.
inline bool is_workbook(const std::string& text) {
  if (!text.starts_with("PK")) {
    return false;
  }
  const Members members = unzipped(text);
  return members.contains("xl/worksheets/sheet1.xml") && members.contains("[Content_Types].xml") &&
         std::all_of(members.begin(), members.end(), [](const auto& member) {
           return !member.first.ends_with(".xml") || is_xml(member.second);
         });
}

}  // namespace changeover::test
