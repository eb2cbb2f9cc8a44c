// A stranger's catalog, from any bytes: what is taken is what it says, is found afterwards, and is
// written and read as it was.
#include <chrono>

#include "changeover/catalog/catalog.hpp"
#include "changeover/curator/curator.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::import_fuzz {
namespace {

void take_in(const std::vector<CatalogEntry>& entries) {
  static const Scratch scratch;
  scratch.empty();
  Catalog catalog({.shipped = {}, .user = scratch.file("mine.db")});
  catalog.add(entries);
  std::string kept;
  for (const CatalogEntry& entry : entries) {
    must(fault_of_entry(entry).empty(), "what was taken is what it says");
    must(catalog.find(entry.label()) == entry, "what was taken is found");
  }
  StringSink sink;
  const std::uint64_t count = write_entries(catalog, {.best_only = false}, sink);
  must(count == entries.size(), "all that was taken is written");
  must(read_foreign(*input_from_text(sink.take()), catalog).known == count,
       "what was written is known");
}

const Target target("import", [](const std::string& bytes) {
  const Catalog empty({.shipped = {}, .user = {}});
  for (const bool skip : {false, true}) {
    accepts([&] {
      const Foreign foreign = read_foreign(*input_from_text(bytes), empty,
                                           {.line = 100'000,
                                            .entries = 20,
                                            .v = 200,
                                            .b = 5000,
                                            .time_each = std::chrono::milliseconds(300),
                                            .memory_each = std::uint64_t{16} << 20U,
                                            .skip_bad = skip});
      for (const std::string& line : foreign.left_out) {
        must(is_one_plain_line(line), "what was left out is said in one line");
      }
      if (!foreign.entries.empty()) {
        take_in(foreign.entries);
      }
    });
  }
});

}  // namespace
}  // namespace changeover::fuzz::import_fuzz
