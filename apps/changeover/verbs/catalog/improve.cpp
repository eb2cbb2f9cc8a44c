// changeover catalog improve, submit: searches where the catalog is weakest, and the results as a
// file for others.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/curator/curator.hpp"
#include "cli/status_line.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/catalog_request.hpp"
#include "request/run_request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ImproveRequest {
  FilterRequest filter;
  std::string who, each;
  CatalogRequest catalog;
  RunRequest run;
  OutputRequest output;
};

struct SubmitRequest {
  CatalogRequest catalog;
  OutputRequest output;
};

Answer run_improve(const ImproveRequest& request) {
  CatalogSearch search;
  if (!request.each.empty()) {
    search.each = parse_duration(request.each, "--each");
  }
  search.introduction.credit.who = request.who;
  search.introduction.credit.date = today();
  const CatalogFilter filter = request.filter.filter();
  Catalog& catalog = request.catalog.open_to_change(request.output);
  const auto running = std::make_shared<Running>(request.run, request.output);
  const std::vector<CatalogFind> finds =
      improve_catalog(catalog, filter, running->control(), search);
  running->finish();
  std::string text;
  JsonWriter json;
  json.objects(finds, [&](const CatalogFind& find) {
    text += fmt::format("better: {}  {} -> {}  {}; {}\n", cell_label(find.parameters), find.before,
                        find.b, find.label, find.how);
    json.key("cell").value(cell_label(find.parameters)).key("before").value(find.before);
    json.key("b").value(find.b).key("label").value(find.label).key("how").value(find.how);
  });
  text += fmt::format("{} better, all in the catalog\n", count_of(finds.size(), "design"));
  const int code = finds.empty() ? exit_code::limit_reached : exit_code::found;
  Answer answer =
      text_answer(request.output.json() ? json.take() + "\n" : text, request.output, code);
  if (!finds.empty()) {
    answer.done_before = catalog_was_changed;
  }
  return final_answer(running, std::move(answer));
}

Answer run_submit(const SubmitRequest& request) {
  const Catalog& catalog = request.catalog.open();
  StringSink lines;
  const Submission submission = write_submission(catalog, lines);
  for (const std::string& line : submission.left_out) {
    status_line().say(printable("changeover: left out, not as it says: " + line));
  }
  for (const std::string& label : submission.labels) {
    status_line().say("changeover: submitted: " + label);
  }
  if (submission.labels.empty()) {
    return no_design(request.output, exit_code::missing_resource,
                     "Nothing of yours is better than what comes with the program.");
  }
  return text_answer(lines.text(), request.output);
}

}  // namespace

void add_catalog_improve(Program& program) {
  auto [verb, request] = program.add<ImproveRequest>(
      "catalog-improve", "search where the catalog is weakest", run_improve);
  request.filter.add_to(verb);
  verb.option("--each", request.each, "DURATION",
              "for a cell at first, then twice as long (default a fiftieth of the time)");
  verb.option("--who", request.who, "NAME", "who is credited with what is found");
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"text", "json"});
  request.run.add_to(verb, "60s", request.output);
  verb.examples({"changeover catalog improve --time 10m --threads 2 --k 5..8 --v 20..40",
                 "each find is verified and in the catalog at once"});
  verb.outcomes({{exit_code::found, "something was found"},
                 {exit_code::limit_reached, "nothing in this time"}});
}

void add_catalog_submit(Program& program) {
  auto [verb, request] = program.add<SubmitRequest>(
      "catalog-submit", "write your improvements to a file for the maintainers", run_submit);
  request.catalog.add_to(verb);
  request.output.add_to(verb, {"jsonl"});
  verb.examples({"changeover catalog submit -o for-the-maintainers.jsonl",
                 "each is built and verified again; the lines carry their credit, and catalog "
                 "import reads them"});
}

}  // namespace changeover::cli
