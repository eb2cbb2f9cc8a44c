// changeover catalog completeness: how much is known, by change number, kind and block size.
#include <fmt/format.h>

#include <map>
#include <tuple>

#include "answer/answer.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct CompletenessRequest {
  FilterRequest filter;
  CatalogRequest catalog;
  OutputRequest output;
};

struct Tally {
  std::uint64_t cells = 0;
  std::uint64_t minimum = 0;
  std::uint64_t v_from = ~std::uint64_t{0};
  std::uint64_t v_to = 0;
  double ratios = 0;
};

Answer run(const CompletenessRequest& request) {
  std::map<std::tuple<std::uint32_t, std::uint64_t, Kind, std::uint64_t>, Tally> tallies;
  request.catalog.open().each(request.filter.filter(), [&](const CatalogEntry& entry) {
    const Parameters& p = entry.parameters;
    Tally& tally = tallies[{p.strength, p.change, p.kind, p.k}];
    ++tally.cells;
    tally.minimum += entry.status() == "minimum" ? 1U : 0U;
    tally.v_from = std::min(tally.v_from, p.v);
    tally.v_to = std::max(tally.v_to, p.v);
    tally.ratios += static_cast<double>(entry.b) / static_cast<double>(entry.lower_bound);
    return true;
  });
  std::string text;
  JsonWriter json;
  json.begin_array();
  for (const auto& [key, tally] : tallies) {
    const auto& [strength, change, kind, k] = key;
    const double mean = tally.ratios / static_cast<double>(tally.cells);
    text += fmt::format(
        "t = {}, m = {}, {:<8}  k = {:<3} v = {:>3}..{:<4} {:>5} cells, {:>5} proved minimum "
        "({:>3.0f} %), mean of b / bound {:.4f}\n",
        strength, change, to_string(kind), k, tally.v_from, tally.v_to, tally.cells, tally.minimum,
        100.0 * static_cast<double>(tally.minimum) / static_cast<double>(tally.cells), mean);
    json.begin_object().key("strength").value(std::uint64_t{strength}).key("change").value(change);
    json.key("kind").value(to_string(kind)).key("k").value(k).key("v_from").value(tally.v_from);
    json.key("v_to").value(tally.v_to).key("cells").value(tally.cells);
    json.key("minimum").value(tally.minimum).key("mean_ratio").value(mean).end_object();
  }
  json.end_array();
  return text_answer(request.output.json() ? json.take() + "\n" : text, request.output);
}

}  // namespace

void add_catalog_completeness(Program& program) {
  auto [verb, request] = program.add(
      "catalog-completeness", "how many cells are filled and proved minimum, by block size", run);
  request.filter.add_to(verb);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover catalog completeness --change 1 --linear --v ..60"});
}

}  // namespace changeover::cli
