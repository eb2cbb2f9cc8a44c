// The rows of docs/limits.md, which tests hold to what the program does.
#pragma once

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace changeover::test {

struct LimitRow {
  std::uint64_t limit = 0;
  int code = 0;      ///< exit code, or status of HTTP
  std::string line;  ///< what one sees one beyond it
};

/// The rows between one heading and the next, by name. Numbers are written with commas; lines stand
/// between backticks.
inline std::map<std::string, LimitRow> limit_rows(const std::string& page,
                                                  const std::string& heading) {
  std::ifstream file(page);
  std::map<std::string, LimitRow> rows;
  bool here = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) {
      here = line == "## " + heading;
    }
    if (!here || !line.starts_with("| `")) {
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream words(line.substr(1));
    for (std::string cell; std::getline(words, cell, '|');) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
      std::erase(cell, '`');
      cells.push_back(cell);
    }
    if (cells.size() != 6) {
      rows["a row that has not six cells: " + line];
      continue;
    }
    std::erase(cells[2], ',');
    rows[cells[0]] = {std::stoull(cells[2]), std::stoi(cells[4]), cells[5]};
  }
  return rows;
}

}  // namespace changeover::test
