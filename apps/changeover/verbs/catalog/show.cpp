// changeover catalog show LABEL | V K: what is known of a design or of a cell.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "answer/design/chosen_design.hpp"
#include "answer/design/recipe_tree.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ShowRequest {
  std::string what;
  std::string k;
  ParameterRequest asked;  // without V and K: `what` may be a label
  CatalogRequest catalog;
  OutputRequest output;
};

std::string text_of(const CatalogEntry& entry, bool is_shipped) {
  std::string text = fmt::format("{}\n  {}: {}, {}\n", entry.label(), name(entry.parameters),
                                 count_of(entry.b, "block"), entry.status());
  if (!entry.retracted.empty()) {
    text += fmt::format("  retracted: {}\n", entry.retracted);
  }
  text += fmt::format("  b >= {}: {}\n", entry.lower_bound, entry.reason);
  text += fmt::format("  credit: {}{}\n", credit_words(entry.credit),
                      is_shipped ? "" : "; in your own catalog");
  if (!entry.note.empty()) {
    text += fmt::format("  note: {}\n", entry.note);
  }
  const std::string cites = joined(references_of(entry));
  if (!cites.empty()) {
    text += fmt::format("  from: {}\n", cites);
  }
  const std::string reporters = joined(reporters_of(entry.parameters, entry.b));
  if (!reporters.empty()) {
    text += fmt::format("  as few blocks are reported in: {}\n", reporters);
  }
  return text + fmt::format("  SHA-256 of its blocks: {}\n", to_hex(entry.checksum));
}

Answer show_blocks(const CatalogEntry& entry, const OutputRequest& output) {
  ChosenDesign chosen = built(entry);
  return show_design(chosen.source, std::move(chosen.exhibit), output);
}

Answer run(const ShowRequest& request) {
  const Catalog& catalog = request.catalog.open();
  const auto named = cells_or_entry(catalog, request.asked, request.what, request.k);
  if (!named) {
    if (!request.output.json()) {
      throw MissingResource(has_no_design(request.what) + left_out());
    }
    return no_design(request.output, exit_code::missing_resource, has_no_design(request.what));
  }
  const std::vector<Parameters>& cells = named->cells;
  std::vector<CatalogEntry> entries;
  if (named->entry) {
    entries.push_back(*named->entry);
  }
  for (const Parameters& p : cells) {
    for (CatalogEntry& entry : catalog.cell(p)) {
      entries.push_back(std::move(entry));
    }
  }
  if (entries.empty()) {
    std::string words;
    for (const Parameters& p : cells) {
      words += fmt::format("the catalog has no {}{}\n", name(p),
                           impossibility(p) ? ", and none exists: " + *impossibility(p)
                                            : "; changeover bounds says what is known without it");
    }
    words.pop_back();
    return no_design(request.output, exit_code::missing_resource, words,
                     request.output.json() ? "[]" : "");
  }
  const std::string format = request.output.format();
  if (format == "json") {
    JsonWriter json;
    json.list(entries, [&](const CatalogEntry& entry) { write_entry(json, entry); });
    return text_answer(json.take() + "\n", request.output);
  }
  if (format != "summary") {
    // For a cell, the best design that is not retracted.
    const CatalogEntry* best = nullptr;
    for (const CatalogEntry& entry : entries) {
      if (entries.size() == 1 ||
          (entry.retracted.empty() && (best == nullptr || entry.b < best->b))) {
        best = &entry;
      }
    }
    return show_blocks(best == nullptr ? entries.front() : *best, request.output);
  }
  std::string text = joined(entries, "", [&](const CatalogEntry& entry) {
    return text_of(entry, catalog.is_shipped(entry.label()));
  });
  if (cells.size() <= 1) {
    text += (entries.size() == 1 ? "how it is made\n" : "how the first of them is made\n") +
            tree_text(entries.front().recipe);
    if (entries.front().recipe.construction == "literal") {
      text += fmt::format("  changeover catalog show {} --format text prints the blocks\n",
                          entries.front().label());
    }
  }
  return text_answer(text, request.output);
}

}  // namespace

void add_catalog_show(Program& program) {
  auto [verb, request] = program.add<ShowRequest>(
      "catalog-show", "show what is known of a design, or of all designs of a cell", run);
  request.asked.add_beside_label_to(verb, request.what, request.k);
  request.catalog.add_to(verb);
  std::vector<std::string> formats = {"summary"};
  formats.insert(formats.end(), design_formats().begin(), design_formats().end());
  request.output.add_to(verb, formats);
  verb.examples({"changeover catalog show 20 5", "changeover catalog show 26.4.2.circular",
                 "changeover catalog show 26.4.2.circular.65 --format text"});
}

}  // namespace changeover::cli
