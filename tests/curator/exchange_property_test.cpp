// A stranger's catalog at random: taken as it was written; damaged, what is taken of it is what it
// says, and nothing passes for a design that was in the file before with other blocks.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/verify/verdict.hpp"
#include "damage.hpp"

namespace changeover::test::exchange_property_test {
namespace {

// Small designs, by recipes of all sorts and by their blocks.
const std::vector<CatalogEntry>& designs() {
  static const std::vector<CatalogEntry> all = [] {
    std::vector<CatalogEntry> entries;
    const Registry& registry = Registry::standard();
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t v = 5; v < 11; ++v) {
        for (std::uint64_t change = 1; change < 3; ++change) {
          for (const Offer& offer :
               registry.offers({.v = v, .k = 4, .change = change, .kind = kind})) {
            entries.push_back(*newcomer_of(registry.build_design(offer.recipe), {}).entry);
            entries.push_back(entries.back());
            entries.back().recipe = literal_recipe(registry.build_design(offer.recipe), "by hand");
          }
        }
      }
    }
    return entries;
  }();
  return all;
}

using Entries = std::map<std::string, CatalogEntry>;

Entries some_entries() {
  Entries entries;
  for (std::uint64_t count = 1 + some_number(3); count > 0; --count) {
    const CatalogEntry& entry = *rc::gen::elementOf(designs());
    entries[entry.label()] = entry;
  }
  return entries;
}

std::string written(const Entries& entries) {
  std::string text = header_line({}) + "\n";
  for (const auto& [label, entry] : entries) {
    text += line_of(entry, {}) + "\n";
  }
  return text;
}

Foreign read(const std::string& text, bool skip_bad) {
  static const Catalog nothing({});
  return read_foreign(
      *input_from_text(text, "f"), nothing,
      {.v = 100, .b = 1000, .time_each = std::chrono::seconds(1), .skip_bad = skip_bad});
}

RC_GTEST_PROP(ExchangeProperty, FilesAreTakenAsTheyWereWritten, ()) {
  const Entries entries = some_entries();
  Entries taken;
  for (const CatalogEntry& entry : read(written(entries), false).entries) {
    taken[entry.label()] = entry;
  }
  RC_ASSERT((taken == entries));
}

RC_GTEST_PROP(ExchangeProperty, OfDamagedFilesOnlyDesignsAreTaken, (const Damage& damage)) {
  const Entries entries = some_entries();
  const std::string bad = damage.of(written(entries));
  Foreign foreign;
  const bool whole = accepted("f:", [&] { foreign = read(bad, false); });
  if (!whole && !accepted("f:", [&] { foreign = read(bad, true); })) {
    return;
  }
  RC_ASSERT(whole == foreign.left_out.empty());
  for (const std::string& line : foreign.left_out) {
    RC_ASSERT(line.starts_with("f:"));
    RC_ASSERT(is_printable(line));
  }
  for (const CatalogEntry& entry : foreign.entries) {
    RC_ASSERT(fault_of_entry(entry).empty());
    const Design design = Registry::standard().build_design(entry.recipe);
    RC_ASSERT(design.parameters() == entry.parameters);
    RC_ASSERT(design.block_count() == entry.b);
    RC_ASSERT(verify(design).valid());
    if (const auto before = entries.find(entry.label()); before != entries.end()) {
      RC_ASSERT(design.blocks() ==
                Registry::standard().build_design(before->second.recipe).blocks());
    }
  }
}

}  // namespace
}  // namespace changeover::test::exchange_property_test
