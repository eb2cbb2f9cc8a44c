// Makes a catalog's database from files of lines, when the library is built.
// usage: make_catalog IMAGE FILE…
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: make_catalog IMAGE FILE...\n", stderr);
    return 2;
  }
  try {
    std::vector<changeover::CatalogEntry> entries;
    for (int i = 2; i < count; ++i) {
      std::ifstream file(arguments[i], std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      changeover::CatalogText lines = changeover::read_catalog(text, arguments[i]);
      std::move(lines.entries.begin(), lines.entries.end(), std::back_inserter(entries));
    }
    const std::vector<std::byte> image = changeover::make_catalog(entries);
    std::ofstream file(arguments[1], std::ios::binary);
    file.write(reinterpret_cast<const char*>(image.data()),
               static_cast<std::streamsize>(image.size()));
    file.close();
    return file ? 0 : 1;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "make_catalog: %s\n", fault.what());
    return 1;
  }
}
