// Names as people give them to parts, at random, none twice: with what separates fields, what a
// spreadsheet computes, what begins a comment, numbers, and words of headers.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <string>
#include <vector>

#include "damage.hpp"

namespace changeover::test {

inline std::string some_name() {
  return *rc::gen::element<std::string>("Pump", "Valve, large", "=1+1", "'=1", "''@", "-1", "#5",
                                        "say \"hi\"", "step", "set_up", "part", "漢", "é", "a;b",
                                        "1e5", "00", "x  y", "'", "\"\"", "&<b>", "_x0041_") +
         (some_number(2) == 0 ? "" : std::to_string(some_number(9)));
}

inline std::vector<std::string> some_names(std::uint64_t count) {
  std::vector<std::string> names;
  while (names.size() < count) {
    const std::string name = some_name();
    if (std::ranges::find(names, name) == names.end()) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace changeover::test
