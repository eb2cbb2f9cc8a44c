// Cells: tables of them, and what is known of one.
#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "answer/catalog/entry_words.hpp"
#include "answer/design/recipe_tree.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/io/formats.hpp"
#include "construct/known_documents.hpp"
#include "io/write/json_writer.hpp"
#include "request/parameters.hpp"
#include "serve/api/cells.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/request/selection.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

Response table(Explorer& explorer, const Request& request) {
  const auto table = explorer.tables.of(table_range_of(request), explorer.generation());
  Cells cells;
  for (const Kind kind : cli::kinds_of(kind_of(request))) {
    const Cells more = table->cells(kind);
    cells.insert(cells.end(), more.begin(), more.end());
  }
  return json_response(table_json(cells, CellKeys::with_label) + "\n");
}

void write_best(JsonWriter& json, const KnownBounds& known) {
  json.key("best");
  if (!known.best) {
    json.null();
    return;
  }
  const Offer& offer = *known.best;
  const std::string label = label_of(offer);
  json.begin_object().key("b").value(offer.b).key("label").value_or_null(label);
  json.key("status").value(known.status());
  json.key("construction").value(offer.recipe.construction);
  json.key("recipe").raw(recipe_to_json(offer.recipe)).end_object();
}

}  // namespace

cli::TableRange table_range_of(const Request& request, const cli::TableRange& usual) {
  constexpr std::uint64_t most_cells = 20'000;
  const cli::Range k = range_of(request, "k", usual.k);
  const cli::Range v =
      range_of(request, "v", {usual.v.from > 0 ? usual.v.from : k.from, usual.v.to});
  const std::uint64_t columns = k.to - k.from;
  if (columns >= most_cells || (v.to - v.from) / (most_cells / (columns + 1)) > 0) {
    throw Refusal{413, fmt::format("the table would have more than {} cells; ask for fewer at once",
                                   most_cells)};
  }
  return {.k = k, .v = v, .change = number_of(request, "change").value_or(usual.change)};
}

bool is_quick_table(const Request& request) {
  constexpr std::uint64_t quick_cells = 150;
  constexpr std::uint64_t quick_v = 60;
  const cli::TableRange range = table_range_of(request);
  return range.v.to <= quick_v &&
         (range.k.to - range.k.from + 1) * (range.v.to - range.v.from + 1) <= quick_cells;
}

std::string cell_json(const Catalog& catalog, const Parameters& p, CellWords words) {
  const KnownBounds known = known_bounds(p);
  JsonWriter json;
  begin_known(json, known);
  json.key("status").value(known.status());
  write_reported(json, known);
  json.objects("bounds", known.bounds, [&](const Bound& bound) {
    json.key("name").value(bound.name).key("blocks").value(bound.blocks);
    json.key("reason").value(bound.reason);
  });
  write_best(json, known);
  const std::vector<CatalogEntry> entries = catalog.cell(p);
  json.list("designs", entries, [&](const CatalogEntry& entry) {
    words == CellWords::all || known.bounds.empty()
        ? cli::write_entry(json, entry)
        : cli::write_entry_beside(json, entry, known.bounds.front());
  });
  constexpr std::size_t most_offers = 20;
  const std::vector<Offer> offers =
      known.impossible ? std::vector<Offer>() : Registry::standard().offers(p);
  json.objects("offers", offers | std::views::take(most_offers), [&](const Offer& offer) {
    json.key("construction").value(offer.recipe.construction).key("b").value(offer.b);
    if (words == CellWords::all) {
      json.key("recipe").raw(recipe_to_json(offer.recipe));
    }
  });
  json.objects("history", catalog.history(p), [&](const Improvement& step) {
    const auto entry = std::ranges::find(entries, step.label, &CatalogEntry::label);
    json.key("date").value(step.date).key("b").value(step.b).key("label").value(step.label);
    json.key("credit").value(entry == entries.end() ? "" : entry->credit.who);
    json.key("how").value(step.how);
  });
  write_classified(json, known);
  return json.key("impossible").value(known.impossible).end_object().take();
}

void add_cells(Router& router, Explorer& explorer) {
  const auto quick_or_slow = [](auto is_quick) {
    return
        [is_quick](const Request& request) { return is_quick(request) ? Lane::quick : Lane::slow; };
  };
  Route tables =
      question(explorer, "api/table", {"v", "k", "change", "kind"}, Again::while_unchanged,
               [&explorer](const Request& request) { return table(explorer, request); });
  tables.lane = quick_or_slow(is_quick_table);
  router.add(std::move(tables));

  const auto of_cell = [&](const std::string& path, std::vector<std::string> parameters,
                           std::function<Response(const Request&)> answer) {
    Route route =
        question(explorer, path, std::move(parameters), Again::while_unchanged, std::move(answer));
    route.lane = quick_or_slow(is_quick);
    router.add(std::move(route));
  };
  const std::vector<std::string> cell{"v", "k", "change", "kind", "strength"};
  of_cell("api/cell", cell, [&explorer](const Request& request) {
    return json_response(cell_json(explorer.catalog, cell_of(request)) + "\n");
  });
  of_cell("api/bounds", cell, [](const Request& request) {
    return json_response(bounds_json(known_bounds(cell_of(request))) + "\n");
  });
  std::vector<std::string> or_label = cell;
  or_label.emplace_back("label");
  of_cell("api/explain", or_label, [&explorer](const Request& request) {
    return json_response(cli::explanation_json(selected_recipe(explorer, request)) + "\n");
  });
}

}  // namespace changeover::serve
