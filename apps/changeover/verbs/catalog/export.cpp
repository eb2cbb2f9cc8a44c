// changeover catalog export, import: entries as lines of JSON, out and in.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/curator/curator.hpp"
#include "changeover/run/control.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "request/output.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ExportRequest {
  FilterRequest filter;
  CatalogRequest catalog;
  OutputRequest output;
};

struct ImportRequest {
  std::string path;
  bool skip_bad = false;
  CatalogRequest catalog;
  RunRequest run;
  OutputRequest output;
};

Answer run_export(const ExportRequest& request) {
  const Catalog& catalog = request.catalog.open();
  const CatalogFilter filter = request.filter.filter();
  Answer answer;
  answer.output = request.output;
  answer.write = [&catalog, filter](OutputFile& file) { write_entries(catalog, filter, file); };
  return answer;
}

Answer run_import(const ImportRequest& request) {
  check_inputs(request.output, {{"the catalog", request.path}});
  Catalog& catalog = request.catalog.open_to_change(request.output);
  const auto input = open_input(request.path);
  const auto running = std::make_shared<Running>(request.run, request.output);
  Imported imported;
  try {
    imported = import_foreign(*input, catalog, {.skip_bad = request.skip_bad});
  } catch (const Stopped&) {
    running->finish();
    return final_answer(running, text_answer("stopped: nothing was added\n", request.output,
                                             exit_code::limit_reached));
  }
  running->finish();
  std::string text =
      fmt::format("added: {}, {} of them better than what was known of their cells\n",
                  count_of(imported.added, "design"), imported.improved);
  text += fmt::format("there already: {}\n", imported.known);
  if (imported.not_added > 0) {
    text += fmt::format("stopped: {} not added; import the file again to add the rest\n",
                        count_of(imported.not_added, "design"));
  }
  for (const std::string& line : imported.left_out) {
    text += "left out: " + printable(line) + "\n";
  }
  if (request.output.json()) {
    JsonWriter json;
    json.begin_object().key("added").value(imported.added);
    json.key("improved").value(imported.improved).key("known").value(imported.known);
    json.key("not_added").value(imported.not_added);
    json.key("left_out").value(imported.left_out).end_object();
    text = json.take() + "\n";
  }
  const int code = imported.not_added > 0       ? exit_code::limit_reached
                   : !imported.left_out.empty() ? exit_code::refuted
                                                : exit_code::done;
  Answer answer = text_answer(text, request.output, code);
  if (imported.added > 0) {
    answer.done_before = catalog_was_changed;
  }
  return final_answer(running, std::move(answer));
}

}  // namespace

void add_catalog_export(Program& program) {
  auto [verb, request] = program.add<ExportRequest>(
      "catalog-export", "write designs of the catalog as lines of JSON", run_export);
  request.filter.add_to(verb, FilterRequest::Unless::best_is_asked_for);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"jsonl"});
  verb.examples({"changeover catalog export --users -o mine.jsonl",
                 "changeover catalog export --k 4 --circular --best | wc -l"});
}

void add_catalog_import(Program& program) {
  auto [verb, request] = program.add<ImportRequest>(
      "catalog-import", "read designs that catalog export wrote, and verify each", run_import);
  verb.positional("FILE", request.path, "lines of JSON; - is standard input");
  verb.flag("--skip-bad", request.skip_bad,
            "leave out what is not as it says, and name it; without it nothing is added then");
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  request.run.add_limits_to(verb, "", request.output, false);
  verb.examples({"changeover catalog import theirs.jsonl",
                 "changeover catalog import theirs.jsonl --skip-bad"});
  verb.outcomes({{exit_code::done, "all of them are in the catalog"},
                 {exit_code::refuted, "some were left out (--skip-bad)"},
                 {exit_code::limit_reached, "stopped; what was added stays"}});
}

}  // namespace changeover::cli
