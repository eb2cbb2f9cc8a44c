// How much the catalog knows: cells filled, minima proved, by strength, change number, kind and
// block size.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "changeover/catalog/catalog.hpp"

namespace changeover::cli {

struct Tally {
  std::uint64_t cells = 0;
  std::uint64_t minimum = 0;
  std::uint64_t v_from = ~std::uint64_t{0};
  std::uint64_t v_to = 0;
  double ratios = 0;  ///< sum of b / lower bound

  [[nodiscard]] double mean_ratio() const { return ratios / static_cast<double>(cells); }
};

/// By strength, change number, kind, k.
using Completeness = std::map<std::tuple<std::uint32_t, std::uint64_t, Kind, std::uint64_t>, Tally>;

[[nodiscard]] Completeness completeness(const Catalog& catalog, const CatalogFilter& filter);

/// The document of `catalog completeness --json`.
[[nodiscard]] std::string completeness_json(const Completeness& found);

}  // namespace changeover::cli
