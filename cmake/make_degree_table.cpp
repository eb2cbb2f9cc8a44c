// Prints src/bounds/degree_table.cpp: what the degree program says of the cells that the catalog
// comes with. Takes minutes; docs/tools/degree_table.sh puts the answer in place.
#include <cstdio>
#include <string>

#include "bounds/degree_table.hpp"
#include "changeover/core/error.hpp"

int main() {
  using namespace changeover;
  std::string text =
      "// Written by docs/tools/degree_table.sh. Do not edit: a wrong number here is a wrong claim.\n"
      "#include \"bounds/degree_table.hpp\"\n\n"
      "namespace changeover {\n\n"
      "const DegreeTable& degree_table() {\n"
      "  static const DegreeTable table{{\n";
  for (std::uint64_t m = 1; m <= DegreeTable::largest_m; ++m) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t k = DegreeTable::smallest_k; k <= DegreeTable::largest_k; ++k) {
        text += "      \"";
        for (std::uint64_t v = k + 1; v <= DegreeTable::largest_v; ++v) {
          text += DegreeTable::written({v, k, m, kind, 2});
        }
        text += "\",\n";
        std::fprintf(stderr, "m = %d, k = %d\n", static_cast<int>(m), static_cast<int>(k));
      }
    }
  }
  text += "  }};\n  return table;\n}\n\n}  // namespace changeover\n";
  std::fwrite(text.data(), 1, text.size(), stdout);
}
