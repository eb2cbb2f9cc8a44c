// changeover catalog history CELL: how the best of a cell became better.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/catalog/entry.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct HistoryRequest {
  std::string cell;
  CatalogRequest catalog;
  OutputRequest output;
};

Answer run(const HistoryRequest& request) {
  const Catalog& catalog = request.catalog.open();
  auto p = parse_cell_label(request.cell);
  if (!p) {
    // A label stands for the cell of its design.
    const auto entry = catalog.find(request.cell);
    if (!entry) {
      throw UsageError{fmt::format(
          "'{}' is not the label of a cell; write it as 20.5.2.linear or 6.4.1.linear.t3{}",
          request.cell, left_out())};
    }
    p = entry->parameters;
  }
  const std::vector<Improvement> steps = catalog.history(*p);
  std::string text = name(*p) + "\n";
  JsonWriter json;
  json.objects(steps, [&](const Improvement& step) {
    text += fmt::format("  {}  {:>6}  {}  {}\n", step.date.empty() ? "-         " : step.date,
                        step.b, step.label, step.how);
    json.key("date").value(step.date).key("b").value(step.b);
    json.key("label").value(step.label).key("how").value(step.how);
  });
  if (steps.empty()) {
    text += "  nothing is known in the catalog\n";
  }
  return text_answer(request.output.json() ? json.take() + "\n" : text, request.output);
}

}  // namespace

void add_catalog_history(Program& program) {
  auto [verb, request] = program.add<HistoryRequest>(
      "catalog-history", "show how the best design of a cell improved", run);
  verb.positional("CELL", request.cell, "v.k.m.kind, as 20.5.2.linear; or a design of it");
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover catalog history 20.5.2.linear"});
}

}  // namespace changeover::cli
