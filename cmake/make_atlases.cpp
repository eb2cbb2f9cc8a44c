// Writes the map of what the catalog comes with, a document a line, when the program is built.
// usage: make_atlases FILE
#include <cstdio>
#include <exception>
#include <fstream>

#include "construct/known_documents.hpp"

int main(int count, char** arguments) {
  using namespace changeover;
  if (count != 2) {
    std::fputs("usage: make_atlases FILE\n", stderr);
    return 2;
  }
  try {
    choose_catalog("");  // not the one of the user who builds
    std::ofstream file(arguments[1], std::ios::binary);
    for (const std::uint64_t change : {1U, 2U, 3U}) {
      for (const Kind kind : {Kind::circular, Kind::linear}) {
        const CellRange range = stored_cells(change, kind);
        const BestKnownTable table = best_known_table(Registry::standard(), range);
        Cells cells;
        for (const KnownCell& cell : table.cells()) {
          cells.push_back(&cell);
        }
        file << atlas_json(range, cells) << '\n';
      }
    }
    file.close();
    return file ? 0 : 1;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "make_atlases: %s\n", fault.what());
    return 1;
  }
}
