#include "serve/api/atlas.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/run/control.hpp"
#include "construct/known_documents.hpp"
#include "io/write/json_writer.hpp"
#include "run/threads.hpp"
#include "serve/api/about.hpp"
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

// The order of the group of a cell's best design, in decimal.
std::optional<std::string> group_order(const KnownCell& cell) {
  // Beyond, a design is too long to be looked through for each of many cells.
  constexpr std::uint64_t most_numbers = 2'000'000;
  if (!cell.best || cell.best->b > most_numbers / cell.parameters.k) {
    return std::nullopt;
  }
  return automorphisms(Registry::standard().build_design(cell.best->recipe)).order;
}

AtlasQuestion atlas_question_of(const Request& request) {
  const std::uint32_t strength = strength_of(request);
  const Kind kind = needed_kind(request);
  constexpr std::uint64_t usual_change = 2;
  const std::uint64_t change = number_of(request, "change").value_or(usual_change);
  cli::TableRange range = table_range_of(request, atlas_range(change, strength));
  range.kind = kind;
  return {.range = range, .kind = kind, .strength = strength};
}

// The line of stored_atlases() that is the answer; empty if none is.
std::string_view stored_answer(const AtlasQuestion& asked) {
  JsonWriter json;
  begin_atlas(json, asked.cells(), asked.strength);
  const std::string beginning = json.take() + ",";
  std::string_view line;
  for (std::string_view rest = stored_atlases(); !rest.empty(); rest.remove_prefix(line.size())) {
    line = rest.substr(0, rest.find('\n') + 1);
    if (line.starts_with(beginning)) {
      return line;
    }
  }
  return {};
}

template <typename Json>
Response columns(Explorer& explorer, const AtlasQuestion& asked, Json&& document) {
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

CellRange AtlasQuestion::cells() const {
  return {.v_from = range.v.from,
          .v_to = range.v.to,
          .k_from = range.k.from,
          .k_to = range.k.to,
          .change = range.change,
          .kind = kind};
}

cli::TableRange atlas_range(std::uint64_t change, std::uint32_t strength) {
  constexpr std::uint64_t ks_of_strength = 11;
  constexpr std::uint64_t largest_v_of_strength = 40;
  if (strength == 2) {
    const CellRange stored = stored_cells(change, Kind::circular);
    return {.k = {stored.k_from, stored.k_to}, .v = {stored.v_from, stored.v_to}, .change = change};
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

std::string groups_json(const AtlasQuestion& asked, const Cells& cells) {
  std::vector<std::optional<std::string>> orders(cells.size());
  RunControl all_cores(*RunScope::current(), std::max(1U, std::thread::hardware_concurrency()));
  in_parallel(all_cores, cells.size(), [&](std::size_t i) {
    stop_if_asked();
    orders[i] = group_order(*cells[i]);
  });
  stop_if_asked();
  JsonWriter json;
  begin_atlas(json, asked.cells(), asked.strength);
  json.list("order", orders, [&](const auto& order) { json.value(order); });
  return json.end_object().take();
}

void add_atlas(Router& router, Explorer& explorer) {
  const auto add = [&](const std::string& path,
                       Response (*answer)(Explorer&, const AtlasQuestion&)) {
    Route route = question(explorer, path, {"v", "k", "change", "kind", "strength"},
                           Again::while_unchanged, [&explorer, answer](const Request& request) {
                             return answer(explorer, atlas_question_of(request));
                           });
    route.lane = always(Lane::slow);
    router.add(std::move(route));
  };
  add("api/atlas", [](Explorer& asked_of, const AtlasQuestion& asked) {
    if (asked_of.generation().empty()) {
      if (const std::string_view stored = stored_answer(asked); !stored.empty()) {
        return json_response(std::string(stored));
      }
    }
    return columns(asked_of, asked, [](const AtlasQuestion& of, const Cells& cells) {
      return atlas_json(of.cells(), cells, of.strength);
    });
  });
  add("api/groups", [](Explorer& asked_of, const AtlasQuestion& asked) {
    return columns(asked_of, asked, groups_json);
  });
}

}  // namespace changeover::serve
