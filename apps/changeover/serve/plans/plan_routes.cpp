// Run sheets for experimenters, searched for at once or followed, and runs that are kept.
#include <fmt/format.h>

#include "changeover/run/control.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/request/query.hpp"
#include "serve/api/routes.hpp"
#include "serve/plans/plan_answers.hpp"
#include "serve/plans/plan_jobs.hpp"
#include "serve/plans/run_document.hpp"
#include "serve/plans/run_store.hpp"

namespace changeover::serve {
namespace {

Response plan(const Explorer& explorer, const Request& sent) {
  const OpenedRequest opened = sent_job(sent.body);
  const CheckedJobRequest asked = from_body([&] { return checked_job(opened, Door::document); });
  const SearchTimes& times = job_table().times;
  const double seconds = search_seconds(opened.request, times.server, times.most_of_server);
  RunControl control(*RunScope::current(), std::chrono::duration<double>(seconds),
                     opened.request.seed);
  const PlanAnswer answer = answer_to(asked, control);
  stop_if_asked();  // the client may have gone
  return json_response(plan_json(asked, answer, explorer.limits.plan_bytes));
}

Response start(Explorer& explorer, const Request& sent) {
  const OpenedRequest opened = sent_job(sent.body);
  const CheckedJobRequest asked = from_body([&] { return checked_job(opened, Door::document); });
  const SearchTimes& times = job_table().times;
  const double seconds = search_seconds(opened.request, times.followed, times.most_followed);
  return json_response(fmt::format("{{\"id\":{}}}\n", explorer.plans->start(asked, seconds)));
}

Response file(Explorer& explorer, const Request& request) {
  const std::string format =
      word_of(request, "format", {"csv", "xlsx", "html", "markdown", "json", "table"});
  std::string text = explorer.plans->file(needed_number(request, "id"), format);
  const std::string type = format == "csv" ? "text/csv; charset=utf-8"
                           : format == "xlsx"
                               ? "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"
                           : format == "html"     ? "text/html; charset=utf-8"
                           : format == "markdown" ? "text/markdown; charset=utf-8"
                           : format == "json"     ? "application/json; charset=utf-8"
                                                  : "text/plain; charset=utf-8";
  Response response = text_response(std::move(text), type);
  const std::string end = format == "markdown" ? "md" : format == "table" ? "txt" : format;
  response.headers.emplace_back("Content-Disposition",
                                fmt::format("attachment; filename=\"run_sheet.{}\"", end));
  return response;
}

std::string revisions_of(const KeptRun& run) {
  JsonWriter json;
  json.begin_object().key("id").value(run.id).key("revision").value(run.revision);
  json.key("sheet_revision").value(run.sheet_revision);
  return json.end_object().take() + "\n";
}

Response keep_run(Explorer& explorer, const Request& sent) {
  JsonBody body(sent.body);
  KeptRun run{.id = short_text(body, "id"), .title = short_text(body, "title")};
  run.sheet_revision = body.number("sheet_revision").value_or(0);
  run.tests = body.needed_number("tests");
  read_sheet(body, run);
  body.finish();
  for (const RunResult& each : run.results) {
    require_test(each.test, run.tests);
  }
  return json_response(revisions_of(explorer.runs->keep(std::move(run))));
}

Response add_result(Explorer& explorer, const Request& sent) {
  JsonBody body(sent.body);
  RunResult result = result_in(body);
  const std::uint64_t sheet = body.needed_number("sheet_revision");
  body.finish();
  return json_response(revisions_of(
      explorer.runs->add_result(sent.parameter("id").value_or(""), std::move(result), sheet)));
}

}  // namespace

void add_plans(Router& router, Explorer& explorer) {
  router.add(posted(explorer, "api/plan", {}, Body::json,
                    [&explorer](const Request& request) { return plan(explorer, request); }));
  router.add(posted(explorer, "api/plan/read", {}, Body::json, [](const Request& request) {
    return json_response(read_job_json(request.body));
  }));
  router.add(changing(explorer, "api/plan/start", {}, Body::json, Lane::slow,
                      [&explorer](const Request& request) { return start(explorer, request); }));
  router.add(changing(explorer, "api/plan/stop", {"id"}, Body::none, Lane::slow,
                      [&explorer](const Request& request) {
                        explorer.plans->stop(needed_number(request, "id"));
                        return json_response("{}\n");
                      }));
  router.add(question(explorer, "api/plan/job", {"id"}, Again::made_anew,
                      [&explorer](const Request& request) {
                        return explorer.plans->answer(needed_number(request, "id"));
                      }));
  router.add(question(explorer, "api/plan/file", {"id", "format"}, Again::made_anew,
                      [&explorer](const Request& request) { return file(explorer, request); }));

  router.add(
      question(explorer, "api/run", {"id"}, Again::made_anew, [&explorer](const Request& request) {
        const auto id = request.parameter("id");
        return json_response(id ? explorer.runs->json(*id) : explorer.runs->list_json());
      }));
  router.add(changing(explorer, "api/run", {}, Body::json, Lane::slow,
                      [&explorer](const Request& request) { return keep_run(explorer, request); }));
  router.add(
      changing(explorer, "api/run/result", {"id"}, Body::json, Lane::slow,
               [&explorer](const Request& request) { return add_result(explorer, request); }));
  router.add(changing(explorer, "api/run/remove", {"id"}, Body::none, Lane::slow,
                      [&explorer](const Request& request) {
                        explorer.runs->remove(request.parameter("id").value_or(""));
                        return json_response("{}\n");
                      }));
}

}  // namespace changeover::serve
