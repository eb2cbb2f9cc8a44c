// The exactly known minima of tests/data/minimum.csv.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "changeover/core/parameters.hpp"

namespace changeover::test {

struct OracleMinimum {
  Parameters parameters;
  std::uint64_t b = 0;
};

inline std::vector<OracleMinimum> oracle_minima() {
  const std::string path = CHANGEOVER_TEST_DATA "/minimum.csv";
  std::ifstream file(path);
  std::vector<OracleMinimum> minima;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#' || line.rfind("change,", 0) == 0) {
      continue;
    }
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) {
      cells.push_back(cell);
    }
    minima.push_back({{.v = std::stoull(cells.at(2)),
                       .k = std::stoull(cells.at(3)),
                       .change = std::stoull(cells.at(0)),
                       .kind = kind_from_string(cells.at(1)).value()},
                      std::stoull(cells.at(4))});
  }
  if (minima.size() < 100) {
    throw std::runtime_error("too few rows in " + path);
  }
  return minima;
}

}  // namespace changeover::test
