#include "answer/catalog/completeness.hpp"

#include <algorithm>

#include "io/write/json_writer.hpp"

namespace changeover::cli {

Completeness completeness(const Catalog& catalog, const CatalogFilter& filter) {
  Completeness tallies;
  catalog.each(filter, [&](const CatalogEntry& entry) {
    const Parameters& p = entry.parameters;
    Tally& tally = tallies[{p.strength, p.change, p.kind, p.k}];
    ++tally.cells;
    tally.minimum += entry.status() == "minimum" ? 1U : 0U;
    tally.v_from = std::min(tally.v_from, p.v);
    tally.v_to = std::max(tally.v_to, p.v);
    tally.ratios += static_cast<double>(entry.b) / static_cast<double>(entry.lower_bound);
    return true;
  });
  return tallies;
}

std::string completeness_json(const Completeness& found) {
  JsonWriter json;
  json.begin_array();
  for (const auto& [key, tally] : found) {
    const auto& [strength, change, kind, k] = key;
    json.begin_object().key("strength").value(std::uint64_t{strength}).key("change").value(change);
    json.key("kind").value(to_string(kind)).key("k").value(k).key("v_from").value(tally.v_from);
    json.key("v_to").value(tally.v_to).key("cells").value(tally.cells);
    json.key("minimum").value(tally.minimum).key("mean_ratio").value(tally.mean_ratio());
    json.end_object();
  }
  return json.end_array().take();
}

}  // namespace changeover::cli
