// changeover catalog diff OLD [NEW]: cells in which two catalogs differ.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/curator/curator.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "request/output.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DiffRequest {
  std::string before, after;
  CatalogRequest catalog;
  OutputRequest output;
};

Answer run(const DiffRequest& request) {
  check_inputs(request.output, {{"OLD", request.before}, {"NEW", request.after}});
  const auto read = [](const std::string& path) { return best_of_cells(*open_input(path)); };
  const BestOfCells before = read(request.before);
  const BestOfCells after =
      request.after.empty() ? best_of_cells(request.catalog.open()) : read(request.after);
  std::string text;
  std::map<std::string_view, std::uint64_t> counts;
  JsonWriter json;
  json.objects(compare_cells(before, after), [&](const CellChange& change) {
    const std::string cell = cell_label(change.parameters);
    const std::string_view kind = change.kind();
    ++counts[kind];
    text += change.before == 0 ? fmt::format("new     {}  {}\n", cell, change.after)
            : change.after == 0
                ? fmt::format("gone    {}  {}\n", cell, change.before)
                : fmt::format("{:<7} {}  {} -> {}\n", kind, cell, change.before, change.after);
    json.key("cell").value(cell).key("change").value(kind);
    json.key("before").value(change.before).key("after").value(change.after);
  });
  text += fmt::format("{} better, {} worse, {} new, {} gone\n", counts["better"], counts["worse"],
                      counts["new"], counts["gone"]);
  return text_answer(request.output.json() ? json.take() + "\n" : text, request.output);
}

}  // namespace

void add_catalog_diff(Program& program) {
  auto [verb, request] = program.add<DiffRequest>(
      "catalog-diff", "compare the catalog with an export, or two exports, cell by cell", run);
  verb.positional("OLD", request.before, "lines of JSON; - is standard input");
  verb.positional("NEW", request.after, "the same; the catalog if it is not named", false);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover catalog diff last-year.jsonl",
                 "changeover catalog diff old.jsonl new.jsonl --json"});
}

}  // namespace changeover::cli
