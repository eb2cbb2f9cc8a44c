#include "construct/known_documents.hpp"

#include <fmt/format.h>

#include <map>

#include "core/words.hpp"
#include "io/write/json_writer.hpp"

namespace changeover {

std::string KnownBounds::status() const {
  if (impossible) {
    return "impossible";
  }
  if (!best) {
    return "open";
  }
  return best->b == bounds.front().blocks ? "minimum" : "best-known";
}

KnownBounds known_bounds(const Parameters& p) {
  KnownBounds answer{.parameters = p,
                     .impossible = impossibility(p),
                     .bounds = {},
                     .best = {},
                     .reported = {},
                     .all = {}};
  if (!answer.impossible) {
    answer.bounds = lower_bounds(p);
    answer.best = best_known(Registry::standard(), p);
    answer.all = answer.best ? classified(p, answer.best->b) : std::nullopt;
    answer.reported = reported_below(p, answer.best ? std::optional(answer.best->b) : std::nullopt);
  }
  return answer;
}

std::string reported_words(const Reported& reported) {
  return fmt::format("{} reported [{}], blocks not held here", reported.blocks, reported.cites);
}

void write_reported(JsonWriter& json, const KnownBounds& known) {
  json.key("reported");
  if (!known.reported) {
    json.null();
    return;
  }
  json.begin_object().key("blocks").value(known.reported->blocks);
  json.key("cites").value(known.reported->cites).end_object();
}

std::string classified_words(const Classified& all) {
  return fmt::format("{} in {}{}: counted by classify",
                     count_of(all.standard_forms, "standard form"),
                     count_of(all.classes, "class", "classes"),
                     all.tight > 0 ? fmt::format(", {} tight", all.tight) : "");
}

// "1:11 3:1" becomes a list.
void write_classified(JsonWriter& json, const KnownBounds& known) {
  json.key("classified");
  if (!known.all) {
    json.null();
    return;
  }
  const Classified& all = *known.all;
  json.begin_object().key("b").value(all.b).key("standard_forms").value(all.standard_forms);
  json.key("classes").value(all.classes).key("tight").value(all.tight);
  json.key("groups").begin_array();
  for (std::string_view rest = all.groups; !rest.empty();) {
    const std::string_view each = rest.substr(0, rest.find(' '));
    const std::size_t colon = each.find(':');
    json.begin_object().key("order").raw(std::string(each.substr(0, colon)));
    json.key("classes").raw(std::string(each.substr(colon + 1))).end_object();
    rest.remove_prefix(std::min(rest.size(), each.size() + 1));
  }
  json.end_array().end_object();
}

void begin_known(JsonWriter& json, const KnownBounds& known) {
  json.begin_object().cell(known.parameters).key("strength").value(known.parameters.strength);
  json.key("lower_bound");
  known.impossible ? json.null() : json.value(known.bounds.front().blocks);
  json.key("reason").value(known.impossible ? *known.impossible : known.bounds.front().reason);
}

const KnownBounds& best_of(const std::vector<KnownBounds>& kinds) {
  const KnownBounds* best = &kinds.front();
  for (const KnownBounds& kind : kinds) {
    if (kind.best && (!best->best || kind.best->b < best->best->b)) {
      best = &kind;
    }
  }
  return *best;
}

std::string bounds_json(const KnownBounds& answer) {
  JsonWriter json;
  begin_known(json, answer);
  json.key("best_known");
  answer.best ? json.value(answer.best->b) : json.null();
  json.key("construction");
  answer.best ? json.value(answer.best->recipe.construction) : json.null();
  json.key("status").value(answer.status());
  write_reported(json, answer);
  write_classified(json, answer);
  json.objects("bounds", answer.bounds, [&](const Bound& bound) {
    json.key("lower_bound").value(bound.blocks).key("name").value(bound.name);
    json.key("reason").value(bound.reason);
  });
  json.end_object();
  return json.take();
}

std::string table_json(const Cells& cells, CellKeys keys) {
  JsonWriter json;
  json.objects(cells, [&](const KnownCell* cell) {
    json.cell(cell->parameters).key("b");
    cell->best ? json.value(cell->best->b) : json.null();
    json.key("lower_bound");
    cell->impossible ? json.null() : json.value(cell->bound.blocks);
    json.key("status").value(cell->status()).key("construction");
    cell->best ? json.value(cell->best->recipe.construction) : json.null();
    if (keys == CellKeys::with_label) {
      json.key("label").value_or_null(cell->best ? label_of(*cell->best) : "");
    }
    if (keys == CellKeys::with_reason) {
      json.key("reason").value(cell->impossible ? *cell->impossible : cell->bound.reason);
    }
  });
  return json.take();
}

CellRange stored_cells(std::uint64_t change, Kind kind) {
  return {.v_from = 4, .v_to = 160, .k_from = 3, .k_to = 40, .change = change, .kind = kind};
}

void begin_atlas(JsonWriter& json, const CellRange& range, std::uint32_t strength) {
  json.begin_object().key("change").value(range.change);
  json.key("kind").value(to_string(range.kind.value()));
  json.key("strength").value(std::uint64_t{strength});
  json.key("k_from").value(range.k_from).key("k_to").value(range.k_to);
  json.key("v_from").value(range.v_from).key("v_to").value(range.v_to);
}

std::string atlas_json(const CellRange& range, const Cells& cells, std::uint32_t strength) {
  std::map<std::string, std::uint64_t> numbers;
  for (const KnownCell* const cell : cells) {
    if (cell->best) {
      numbers.emplace(cell->best->recipe.construction, 0);
    }
  }
  JsonWriter json;
  begin_atlas(json, range, strength);
  std::uint64_t next = 0;
  json.list("constructions", numbers, [&](auto& each) {
    each.second = next++;
    json.value(each.first);
  });
  json.list("b", cells,
            [&](const KnownCell* cell) { cell->best ? json.value(cell->best->b) : json.null(); });
  json.list("lower_bound", cells, [&](const KnownCell* cell) {
    cell->impossible ? json.null() : json.value(cell->bound.blocks);
  });
  json.list("construction", cells, [&](const KnownCell* cell) {
    cell->best ? json.value(numbers.at(cell->best->recipe.construction)) : json.null();
  });
  json.list("label", cells, [&](const KnownCell* cell) {
    const std::string label = cell->best ? label_of(*cell->best) : "";
    json.value_or_null(label.substr(label.rfind('.') + 1));
  });
  return json.end_object().take();
}

std::string label_of(const Offer& offer) {
  const Recipe& recipe = offer.recipe;
  if (recipe.construction == "found" && recipe.inputs.empty()) {
    return recipe.provenance;
  }
  // A label names blocks: other designs with as many blocks have others. The same recipe makes the
  // same blocks.
  const auto known = standard_catalog().fewest(recipe.parameters);
  if (!known || known->b != offer.b) {
    return "";
  }
  for (const CatalogEntry& entry : standard_catalog().cell(recipe.parameters)) {
    if (entry.b == offer.b && entry.retracted.empty() && entry.recipe == recipe) {
      return entry.label();
    }
  }
  return "";
}

namespace {

void add_node(const RecipeNode& node, const Recipe& recipe, JsonWriter& json,
              const WriteVerdict& verdict) {
  json.begin_object().key("construction").value(node.construction->name()).cell(node.parameters);
  json.key("explanation").value(node.explanation).key("citation").value(node.citation);
  json.key("b").value(node.b.value_or(0));
  if (verdict) {
    json.key("verdict");
    verdict(recipe, json);
  }
  json.key("inputs").begin_array();
  for (std::size_t i = 0; i < node.inputs.size(); ++i) {
    add_node(node.inputs[i], recipe.inputs[i], json, verdict);
  }
  json.end_array().end_object();
}

}  // namespace

void write_tree(const Recipe& recipe, JsonWriter& json, const WriteVerdict& verdict) {
  add_node(explained(Registry::standard(), recipe), recipe, json, verdict);
}

std::string constructions_json() {
  JsonWriter json;
  json.objects(Registry::standard().constructions(), [&](const Construction* each) {
    json.key("name").value(each->name()).key("summary").value(each->summary());
    json.key("preconditions").value(each->preconditions());
    json.key("guarantee").value(each->guarantee());
    json.key("citation").value(each->citation().to_string());
  });
  return json.take();
}

}  // namespace changeover
