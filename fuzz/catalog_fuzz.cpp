// Any bytes, read as the lines of a catalog: what is read is written, and read as it was.
#include "changeover/catalog/entry.hpp"
#include "changeover/curator/curator.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::catalog_fuzz {
namespace {

const Target target("catalog", [](const std::string& bytes) {
  CatalogText text;
  if (!accepts([&] { text = read_catalog(bytes, "theirs.jsonl"); })) {
    return;
  }
  must(shared_from_header(header_line(text.shared), "again") == text.shared,
       "a first line is read as it was written");
  std::string again = header_line(text.shared) + "\n";
  for (const CatalogEntry& entry : text.entries) {
    const std::string line = line_of(entry, text.shared);
    must(is_one_plain_line(line) && is_plain_json(line), "an entry is one line of JSON");
    must(entry_from_line(line, "again", 1, text.shared) == entry,
         "an entry is read as it was written");
    again += line + "\n";
  }
  must(best_of_cells(*input_from_text(again)) == best_of_cells(*input_from_text(bytes)),
       "the best of each cell is what it was");
});

}  // namespace
}  // namespace changeover::fuzz::catalog_fuzz
