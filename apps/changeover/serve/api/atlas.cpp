#include "serve/api/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/run/control.hpp"
#include "construct/known_documents.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/cells.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

KnownCell known_cell(const Parameters& p) {
  KnownCell cell;
  cell.parameters = p;
  if (p.v < p.k) {
    cell.impossible = "a block has at most v elements";
  } else if (p.change > p.k) {
    cell.impossible = "a block has at least m elements";
  } else {
    KnownBounds known = known_bounds(p);
    cell.impossible = std::move(known.impossible);
    if (!known.bounds.empty()) {
      cell.bound = std::move(known.bounds.front());
    }
    cell.best = std::move(known.best);
  }
  return cell;
}

void begin_atlas(JsonWriter& json, const AtlasQuestion& asked) {
  const cli::TableRange& range = asked.range;
  json.begin_object().key("change").value(range.change).key("kind").value(to_string(asked.kind));
  json.key("strength").value(std::uint64_t{asked.strength});
  json.key("k_from").value(range.k.from).key("k_to").value(range.k.to);
  json.key("v_from").value(range.v.from).key("v_to").value(range.v.to);
}

template <typename Write>
void write_column(JsonWriter& json, const char* name, const Cells& cells, Write&& write) {
  json.key(name).begin_array();
  for (const KnownCell* const cell : cells) {
    write(*cell);
  }
  json.end_array();
}

AtlasQuestion atlas_question_of(const Request& request) {
  const std::uint64_t strength = number_of(request, "strength").value_or(2);
  if (strength < 2 || strength > max_strength) {
    throw Refusal{400, fmt::format("strength={}: give 2 to {}", strength, max_strength)};
  }
  const auto kind = kind_of(request);
  if (!kind) {
    throw Refusal{400, "kind is missing; write kind=circular or kind=linear"};
  }
  constexpr std::uint64_t usual_change = 2;
  const std::uint64_t change = number_of(request, "change").value_or(usual_change);
  const auto t = static_cast<std::uint32_t>(strength);
  cli::TableRange range = table_range_of(request, atlas_range(change, t));
  range.kind = kind;
  return {.range = range, .kind = *kind, .strength = t};
}

template <typename Json>
Response atlas_answer(Explorer& explorer, const Request& request, Json&& document) {
  const AtlasQuestion asked = atlas_question_of(request);
  if (asked.strength == 2) {
    const auto table = explorer.tables.of(asked.range, explorer.generation());
    return json_response(document(asked, table->cells(asked.kind)) + "\n");
  }
  cli::check_table(asked.range);
  const std::deque<KnownCell> held = cells_of_strength(asked);
  Cells cells;
  for (const KnownCell& cell : held) {
    cells.push_back(&cell);
  }
  return json_response(document(asked, cells) + "\n");
}

}  // namespace

cli::TableRange atlas_range(std::uint64_t change, std::uint32_t strength) {
  constexpr cli::Range stored_k{3, 40};
  constexpr cli::Range stored_v{4, 160};
  constexpr std::uint64_t ks_of_strength = 11;
  constexpr std::uint64_t largest_v_of_strength = 40;
  if (strength == 2) {
    return {.k = stored_k, .v = stored_v, .change = change};
  }
  return {.k = {strength + 1U, strength + ks_of_strength},
          .v = {strength + 2U, largest_v_of_strength},
          .change = change};
}

std::deque<KnownCell> cells_of_strength(const AtlasQuestion& asked) {
  std::deque<KnownCell> cells;
  const cli::TableRange& range = asked.range;
  for (std::uint64_t k = range.k.from; k <= range.k.to; ++k) {
    for (std::uint64_t v = range.v.from; v <= range.v.to; ++v) {
      stop_if_asked();
      cells.push_back(known_cell({.v = v,
                                  .k = k,
                                  .change = range.change,
                                  .kind = asked.kind,
                                  .strength = asked.strength}));
    }
  }
  return cells;
}

std::string atlas_json(const AtlasQuestion& asked, const Cells& cells) {
  std::map<std::string, std::uint64_t> numbers;
  for (const KnownCell* const cell : cells) {
    if (cell->best) {
      numbers.emplace(cell->best->recipe.construction, 0);
    }
  }
  JsonWriter json;
  begin_atlas(json, asked);
  json.key("constructions").begin_array();
  for (auto& [name, number] : numbers) {
    number = static_cast<std::uint64_t>(
        std::distance(numbers.begin(), numbers.find(name)));  // in the order of their names
    json.value(name);
  }
  json.end_array();
  write_column(json, "b", cells,
               [&](const KnownCell& cell) { cell.best ? json.value(cell.best->b) : json.null(); });
  write_column(json, "lower_bound", cells, [&](const KnownCell& cell) {
    cell.impossible ? json.null() : json.value(cell.bound.blocks);
  });
  write_column(json, "construction", cells, [&](const KnownCell& cell) {
    cell.best ? json.value(numbers.at(cell.best->recipe.construction)) : json.null();
  });
  write_column(json, "label", cells, [&](const KnownCell& cell) {
    const std::string label = cell.best ? label_of(*cell.best) : "";
    json.value_or_null(label.substr(label.rfind('.') + 1));
  });
  return json.end_object().take();
}

std::string groups_json(const AtlasQuestion& asked, const Cells& cells) {
  // Beyond, a design is too long to be looked through for each of many cells.
  constexpr std::uint64_t most_numbers = 2'000'000;
  JsonWriter json;
  begin_atlas(json, asked);
  write_column(json, "order", cells, [&](const KnownCell& cell) {
    stop_if_asked();
    if (!cell.best || cell.best->b > most_numbers / cell.parameters.k) {
      json.null();
      return;
    }
    const Design design = Registry::standard().build_design(cell.best->recipe);
    json.value(automorphisms(design).order);
  });
  return json.end_object().take();
}

void add_atlas(Router& router, Explorer& explorer) {
  const auto add = [&](const std::string& path,
                       std::string (*document)(const AtlasQuestion&, const Cells&)) {
    Route route = question(explorer, path, {"v", "k", "change", "kind", "strength"},
                           Again::while_unchanged, [&explorer, document](const Request& request) {
                             return atlas_answer(explorer, request, document);
                           });
    route.lane = always(Lane::slow);
    router.add(std::move(route));
  };
  add("api/atlas", atlas_json);
  add("api/groups", groups_json);
}

}  // namespace changeover::serve
