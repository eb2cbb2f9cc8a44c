// changeover catalog list: entries that a filter lets through.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "core/words.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ListRequest {
  FilterRequest filter;
  CatalogRequest catalog;
  OutputRequest output;
};

Answer run(const ListRequest& request) {
  const Catalog& catalog = request.catalog.open();
  std::string text;
  std::uint64_t count = 0;
  JsonWriter json;
  json.begin_array();
  const std::string format = request.output.format();
  if (format == "csv") {
    text = "label,v,k,change,kind,strength,b,lower_bound,status,construction,date\n";
  }
  catalog.each(request.filter.filter(), [&](const CatalogEntry& entry) {
    ++count;
    const Parameters& p = entry.parameters;
    if (format == "json") {
      write_entry(json, entry);
    } else if (format == "csv") {
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", entry.label(), p.v, p.k, p.change,
                          to_string(p.kind), p.strength, entry.b, entry.lower_bound, entry.status(),
                          entry.recipe.construction, entry.credit.date);
    } else {
      text += entry_row(entry) + "\n";
    }
    return true;
  });
  if (format == "json") {
    json.end_array();
    text = json.take() + "\n";
  } else if (format == "text") {
    text += count_of(count, "design") + "\n";
  }
  return text_answer(text, request.output);
}

}  // namespace

void add_catalog_list(Program& program) {
  auto [verb, request] =
      program.add<ListRequest>("catalog-list", "list the designs of the catalog, filtered", run);
  request.filter.add_to(verb);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "csv", "json"});
  verb.examples({"changeover catalog list --k 4 --v 5..40 --status minimum",
                 "changeover catalog list --change 1 --linear --gap 5 --k 5..12",
                 "changeover catalog list --users --all"});
}

}  // namespace changeover::cli
