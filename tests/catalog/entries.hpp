// Entries for tests of the catalog. Their blocks need not cover anything: the catalog does not ask.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"

namespace changeover::test {

inline CatalogEntry entry_of(const Design& design) {
  DesignSource source(design);
  const DesignDigest digest = design_digest(source);
  CatalogEntry entry;
  entry.parameters = design.parameters();
  entry.b = digest.b;
  entry.lower_bound = 1;
  entry.reason = "trivial";
  entry.checksum = digest.checksum;
  entry.recipe.construction = "literal";
  entry.recipe.parameters = entry.parameters;
  entry.recipe.blocks = design.blocks();
  return entry;
}

/// b blocks at random.
inline CatalogEntry random_entry(const Parameters& p, std::uint64_t b, std::mt19937& random) {
  std::vector<Block> blocks;
  for (std::uint64_t i = 0; i < b; ++i) {
    Block all(p.v);
    std::iota(all.begin(), all.end(), Element{0});
    std::shuffle(all.begin(), all.end(), random);
    all.resize(p.k);
    blocks.push_back(all);
  }
  return entry_of(Design(p, blocks));
}

inline CatalogEntry random_entry(std::mt19937& random) {
  Parameters p;
  p.k = 2 + random() % 3;
  p.v = p.k + 1 + random() % 3;
  p.change = 1 + random() % 2;
  p.kind = random() % 2 == 0 ? Kind::linear : Kind::circular;
  p.strength = p.k == 4 && random() % 4 == 0 ? 3 : 2;
  CatalogEntry entry = random_entry(p, 1 + random() % 4, random);
  entry.lower_bound = 1 + random() % entry.b;
  constexpr const char* days[] = {"", "2025-01-31", "2026-02-28", "2026-11-22"};
  entry.credit.date = days[random() % 4];
  entry.credit.who = random() % 2 == 0 ? "" : "A \"friend\"";
  if (random() % 3 == 0) {
    entry.recipe.construction = "developed";  // It is never built here.
  }
  return entry;
}

inline std::vector<std::string> labels_of(const Catalog& catalog, const CatalogFilter& filter) {
  std::vector<std::string> labels;
  catalog.each(filter, [&](const CatalogEntry& entry) {
    labels.push_back(entry.label());
    return true;
  });
  return labels;
}

/// What BadInput or MissingResource an action throws says; empty if none.
template <typename Action>
std::string fault_of(Action&& action) {
  try {
    action();
  } catch (const InternalError&) {
    throw;
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

}  // namespace changeover::test
