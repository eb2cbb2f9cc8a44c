// Entries and files at random: read as they were written; damaged, entries that are well made or
// one line.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "../entries.hpp"
#include "changeover/catalog/entry.hpp"
#include "damage.hpp"

namespace changeover::test::entry_property_test {
namespace {

std::string some_words() {
  return some_text({"by hand", "\"", "\\", "/", "«δ»", "漢", "{", "},", ":", "'", "é"}, 4);
}

Credit some_credit() {
  return {.who = some_words(),
          .date = *rc::gen::element<std::string>("", "2024-02-29", "2026-11-22"),
          .program = some_words(),
          .command = some_words()};
}

CatalogText some_file(std::uint32_t seed) {
  std::mt19937 random(seed);
  CatalogText text;
  text.shared = *rc::gen::element(Credit{}, some_credit());
  for (std::uint64_t count = some_number(4); count > 0; --count) {
    CatalogEntry& entry = text.entries.emplace_back(random_entry(random));
    entry.reason = some_words();
    entry.note = some_words();
    entry.retracted = some_words();
    entry.cites.resize(some_number(3));
    std::ranges::generate(entry.cites, some_words);
    entry.credit = *rc::gen::element(text.shared, some_credit());
    entry.recipe.provenance = some_words();
    entry.recipe.arguments[some_words()] = -1;
    if (some_number(2) == 0) {
      entry.recipe.inputs.push_back(random_entry(random).recipe);
    }
  }
  return text;
}

std::string written(const CatalogText& text) {
  std::string lines = header_line(text.shared) + "\n";
  for (const CatalogEntry& entry : text.entries) {
    lines += line_of(entry, text.shared) + "\n";
  }
  return lines;
}

RC_GTEST_PROP(CatalogFileProperty, IsReadAsItWasWritten, (std::uint32_t seed)) {
  const CatalogText text = some_file(seed);
  const CatalogText again = read_catalog(written(text), "f");
  RC_ASSERT(again.shared == text.shared);
  RC_ASSERT(again.entries == text.entries);
}

RC_GTEST_PROP(CatalogFileProperty, DamagedItIsRefusedOrHoldsEntries,
              (std::uint32_t seed, const std::vector<Damage>& damages)) {
  const std::string good = written(some_file(seed));
  for (const Damage& damage : damages) {
    const std::string bad = damage.of(good);
    CatalogText text;
    if (!accepted("f:", [&] { text = read_catalog(bad, "f"); })) {
      continue;
    }
    for (const CatalogEntry& entry : text.entries) {
      check(entry.parameters);
      RC_ASSERT(entry.b >= std::max<std::uint64_t>(entry.lower_bound, 1));
      const auto label = parse_design_label(entry.label());
      RC_ASSERT(label.has_value());
      RC_ASSERT(bad.find('"' + entry.label() + '"') != std::string::npos);
      RC_ASSERT(label->parameters == entry.parameters);
      RC_ASSERT(label->b == entry.b);
    }
    const CatalogText again = read_catalog(written(text), "f");
    RC_ASSERT(again.shared == text.shared);
    RC_ASSERT(again.entries == text.entries);
  }
}

// One design, one label: what is a label is written as it was read.
RC_GTEST_PROP(LabelProperty, DamagedItIsNoneOrTheLabelOfSomethingElse,
              (std::uint32_t seed, const std::vector<Damage>& damages)) {
  std::mt19937 random(seed);
  const CatalogEntry entry = random_entry(random);
  RC_ASSERT(parse_cell_label(cell_label(entry.parameters)) == entry.parameters);
  const auto look_at = [](const std::string& text) {
    if (const auto label = parse_design_label(text)) {
      RC_ASSERT(cell_label(label->parameters) + "." + std::to_string(label->b) + "." +
                    label->digits ==
                text);
      check(label->parameters);
    }
    if (const auto parameters = parse_cell_label(text)) {
      RC_ASSERT(cell_label(*parameters) == text);
    }
  };
  const std::string cell = cell_label(entry.parameters);
  for (const Damage& damage : damages) {
    look_at(damage.of(entry.label()));
    look_at(damage.of(cell));
    std::string more = some_number(1) == 0 ? cell : entry.label();
    more.insert(some_number(more.size()), *rc::gen::element<std::string>("0", "+", ".", "t", " "));
    look_at(more);
  }
}

}  // namespace
}  // namespace changeover::test::entry_property_test
