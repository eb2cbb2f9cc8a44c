#include "answer/dossier/dossier.hpp"

#include <fmt/format.h>

#include "answer/catalog/entry_words.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/core/version.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

// "Found by A. B. with `changeover search …`, changeover 1.0, 2026-11-21"; of a printed design the
// publication is the source, and a design that is constructed was not found: who entered it is said
// after it.
std::string found_words(const CatalogEntry& entry) {
  const Credit& credit = entry.credit;
  const bool made = credit.command.empty() && !entry.carries_blocks();
  const bool printed = entry.recipe.construction == "printed";
  std::string words;
  if (!credit.who.empty()) {
    words = (made      ? "Constructed as above; entered into the catalog by "
             : printed ? "Entered by "
                       : "Found by ") +
            credit.who;
    words += credit.command.empty() ? "" : " with `" + credit.command + "`";
  } else {
    words = credit.command.empty() ? "" : "Found with `" + credit.command + "`";
  }
  for (const std::string& part : {credit.program, credit.date}) {
    words += (words.empty() || part.empty() ? "" : ", ") + part;
  }
  return words;
}

void state_facts(Dossier& dossier, const Judgement& judgement,
                 const std::optional<CatalogEntry>& entry) {
  const Parameters& p = dossier.parameters;
  const DesignVerdict& verdict = judgement.verdict;
  const std::uint64_t gap = dossier.b - verdict.lower_bound;
  const auto add = [&](const char* name, std::string value) {
    dossier.facts.push_back({name, std::move(value)});
  };
  add("v, elements", std::to_string(p.v));
  add("k, block size", std::to_string(p.k));
  add("m, change number", std::to_string(p.change));
  add("kind", std::string(to_string(p.kind)));
  if (p.strength != 2) {
    add("t, strength", std::to_string(p.strength));
  }
  add("b, blocks", std::to_string(dossier.b));
  add("lower bound", fmt::format("{} ({})", verdict.lower_bound, for_paper(judgement.bound.name)));
  add("quality", std::string(verdict.tight        ? "tight, "
                             : verdict.economical ? "economical, "
                                                  : "") +
                     (verdict.minimum_proved
                          ? "minimum"
                          : fmt::format("{} over the lower bound", count_of(gap, "block"))));
  if (dossier.design) {
    add("excess", std::to_string(verify(*dossier.design).excess));
    add("order of its group", automorphisms(*dossier.design).order);
  }
  if (entry) {
    if (!entry->credit.date.empty()) {
      add("date", entry->credit.date);
    }
    add("catalog label", dossier.label);
  }
  add("verified", fmt::format("{}, by changeover {}", dossier.certificate, version));
}

void draw_it(Dossier& dossier) {
  constexpr std::uint64_t most_points = 60;
  constexpr std::uint64_t most_rows = 80;
  constexpr std::uint64_t most_columns = 240;
  constexpr std::uint64_t shortest_cycle = 7;  // shorter ones show no symmetry on a ring
  const Parameters& p = dossier.parameters;
  const Design& design = *dossier.design;
  DrawOptions options{.picture = PictureKind::stays};
  const auto rotation = p.kind == Kind::circular && p.v <= most_points
                            ? find_rotation(design)
                            : std::optional<FoundRotation>();
  if (rotation && rotation->base_blocks.size() <= most_circle_blocks &&
      rotation->pi.n >= shortest_cycle) {
    options.picture = PictureKind::circle;
    dossier.picture_says = "The base blocks, with the pairs that they newly cover.";
  } else if (p.v <= most_rows && dossier.b <= most_columns) {
    dossier.picture_says =
        "The stays: one row for each element, one bar from the block that introduces it to the "
        "one where it leaves.";
  } else {
    return;
  }
  dossier.picture_name = to_string(options.picture);
  dossier.picture = draw(design, options);
}

std::string options_of(const Parameters& p) {
  return fmt::format("{} {} --change {} --{}{}", p.v, p.k, p.change, to_string(p.kind),
                     p.strength == 2 ? "" : fmt::format(" --strength {}", p.strength));
}

// Closure rules offer nothing by their names where the planner alone knows what they work on; what
// `design` makes without a name is then the same.
std::string construction_of(const Recipe& recipe) {
  const auto named = best_offer({recipe.parameters}, recipe.construction);
  return named && named->recipe == recipe ? " --construction " + recipe.construction : "";
}

std::string own_bibtex(const Dossier& dossier) {
  const Parameters& p = dossier.parameters;
  return fmt::format(
      "@misc{{changeover-{},\n  author = {{{{The Changeover developers}}}},\n"
      "  title  = {{{{{} with {}}}}},\n"
      "  note   = {{Changeover {}, SHA-256 of the blocks {}}}\n}}\n",
      cell_label(p), name(p), count_of(dossier.b, "block"), version, to_hex(dossier.checksum));
}

// What is cited is quoted, and cites in its turn.
void quote_theorems(Dossier& dossier) {
  std::vector<std::string> sentences;
  for (const RecipeStep& step : dossier.steps) {
    sentences.push_back(for_paper(step.citation));
    sentences.push_back(for_paper(step.how));
  }
  for (const Bound& bound : dossier.known.bounds) {
    sentences.push_back(for_paper(bound.name));
    sentences.push_back(for_paper(bound.reason));
  }
  dossier.theorems = cited_theorems(sentences);
  for (const QuotedTheorem& theorem : dossier.theorems) {
    add_keys(theorem.statement, dossier.keys);
  }
}

}  // namespace

Dossier dossier_of(const ChosenDesign& chosen, const std::optional<CatalogEntry>& entry) {
  const Registry& registry = Registry::standard();
  const Recipe& recipe = chosen.offer.recipe;
  Dossier dossier;
  dossier.parameters = recipe.parameters;
  dossier.b = chosen.offer.b;
  dossier.quality = quality(chosen.exhibit.judgement);
  dossier.certificate = chosen.exhibit.judgement.certificate;
  dossier.statement =
      fmt::format("There is a {} with {}.", name(dossier.parameters), count_of(dossier.b, "block"));
  dossier.known = known_bounds(dossier.parameters);
  dossier.steps = recipe_steps(recipe);
  dossier.recipe = recipe_to_json(recipe);
  dossier.positions = chosen.exhibit.positions;
  dossier.base_blocks = chosen.exhibit.base_blocks;
  dossier.checksum = design_digest(*registry.build(recipe)).checksum;
  if (dossier.b <= most_listed_blocks && dossier.b * dossier.parameters.k <= most_listed_elements) {
    const auto source = registry.build(recipe);
    dossier.design = read_all(*source);
    dossier.design->set_labels(chosen.exhibit.header.labels);
    draw_it(dossier);
  }
  if (entry) {
    dossier.label = entry->label();
    dossier.credit = credit_words(entry->credit);
    dossier.found = found_words(*entry);
    dossier.keys = references_of(*entry);
    dossier.write_command =
        fmt::format("changeover catalog show {} --format text -o design.txt", dossier.label);
  } else {
    dossier.names_elements = !chosen.exhibit.header.labels.empty();
    dossier.write_command = fmt::format("changeover design {}{} --format text -o design.txt",
                                        options_of(dossier.parameters), construction_of(recipe));
  }
  dossier.draw_command =
      fmt::format("changeover draw {} --picture {} -o design.svg",
                  entry ? dossier.label : options_of(dossier.parameters), dossier.picture_name);
  for (const RecipeStep& step : dossier.steps) {
    add_keys(step.citation, dossier.keys);
    add_keys(step.how, dossier.keys);
  }
  for (const Bound& bound : dossier.known.bounds) {
    add_keys(bound.reason, dossier.keys);
  }
  if (const auto& reported = dossier.known.reported) {
    add_keys(fmt::format("[{}]", reported->cites), dossier.keys);
  }
  quote_theorems(dossier);
  for (std::size_t i = 0; i < dossier.keys.size(); ++i) {  // What is known from a reference.
    const std::string reference = bibtex_of(dossier.keys[i]);
    add_keys(reference, dossier.keys);
  }
  std::erase_if(dossier.keys, [](const std::string& key) { return bibtex_of(key).empty(); });
  dossier.bibtex = entry ? bibtex_of(*entry) : own_bibtex(dossier);
  for (const std::string& key : dossier.keys) {
    if (dossier.bibtex.find("{" + key + ",") == std::string::npos) {
      dossier.bibtex += "\n" + bibtex_of(key);
    }
  }
  if (!dossier.theorems.empty()) {
    dossier.bibtex += "\n" + own_theorems_bibtex();
  }
  const Judgement& judgement = chosen.exhibit.judgement;
  state_facts(dossier, judgement, entry);
  if (judgement.bound.name == "checked proofs" && judgement.bound.blocks == dossier.b) {
    const Parameters& p = dossier.parameters;
    dossier.proof_commands = {
        fmt::format("changeover search {} --exact --proof proofs", options_of(p)),
        "for cnf in proofs/*.cnf; do drat-trim \"$cnf\" \"${cnf%.cnf}.drat\"; done"};
  }
  return dossier;
}

std::string dossier_json(const Dossier& dossier) {
  const Parameters& p = dossier.parameters;
  JsonWriter json;
  json.begin_object().key("format").value("changeover-dossier/1").cell(p);
  json.key("strength").value(p.strength);
  json.key("b").value(dossier.b).key("statement").value(dossier.statement);
  json.key("quality").value(dossier.quality).key("verified").value(dossier.certificate);
  json.key("status").value(dossier.known.status()).key("label").value_or_null(dossier.label);
  json.key("credit").value_or_null(dossier.credit);
  json.key("hash").value(to_hex(dossier.checksum));
  json.objects("bounds", dossier.known.bounds, [&](const Bound& bound) {
    json.key("lower_bound").value(bound.blocks).key("name").value(bound.name);
    json.key("reason").value(bound.reason);
  });
  write_reported(json, dossier.known);
  json.objects("steps", dossier.steps, [&](const RecipeStep& step) {
    json.key("depth").value(std::uint64_t{step.depth});
    json.key("design").value(step.design).key("how").value(step.how);
    json.key("citation").value(step.citation);
  });
  json.key("recipe").raw(dossier.recipe).key("blocks");
  dossier.design ? json.value(dossier.design->blocks()) : json.null();
  json.key("check").begin_array().value(dossier.write_command).value("checkdesign design.txt");
  for (const std::string& command : dossier.proof_commands) {
    json.value(command);
  }
  json.end_array().key("cites").value(dossier.keys).key("bibtex").value(dossier.bibtex);
  return json.end_object().take();
}

}  // namespace changeover::cli
