// Run sheets for experimenters.
#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "io/write/json_writer.hpp"
#include "serve/api/request/request_body.hpp"
#include "serve/api/routes.hpp"

namespace changeover::serve {
namespace {

OpenedRequest request_of(const Request& sent) {
  JobRequest request = job_request(sent.body);
  require_of_server(request, job_table());
  OpenedRequest opened = from_body([&] { return open_workbook(std::move(request)); });
  // What the question of a workbook says for the machine on which it was made.
  request = std::move(opened.request);
  request.threads.reset();
  request.seed.reset();
  request.compact = false;
  const std::string usual = "1";
  request.test_cost = request.test_cost.empty() ? usual : request.test_cost;
  request.change_cost = request.change_cost.empty() ? usual : request.change_cost;
  opened.request = std::move(request);
  return opened;
}

std::vector<std::string> names_of(const Job& job, const Block& parts) {
  std::vector<std::string> names;
  for (const Element part : parts) {
    names.push_back(job.names[part]);
  }
  return names;
}

void write_tests(JsonWriter& json, const Job& job, const std::vector<DoneTest>& done,
                 const RunSheet& sheet) {
  std::uint64_t number = 0;
  json.key("tests").begin_array();
  for (const DoneTest& test : done) {
    json.begin_object().key("number").value(++number);
    json.key("parts").value(names_of(job, test.setup));
    json.key("out").begin_array().end_array().key("in").begin_array().end_array();
    json.key("cost").value(0U).key("changes").value(0U).key("done").value(true).end_object();
  }
  for (const RunStep& step : sheet.steps) {
    json.begin_object().key("number").value(++number);
    json.key("parts").value(names_of(job, step.setup));
    json.key("out").value(names_of(job, step.take_out));
    json.key("in").value(names_of(job, step.put_in));
    json.key("cost").raw(to_string(step.cost)).key("changes").value(step.put_in.size());
    json.key("done").value(false).end_object();
  }
  json.end_array();
}

void write_alternatives(JsonWriter& json, const Job& job, const RunPlan& plan) {
  json.key("alternatives").begin_array();
  for (const Candidate& candidate : plan.candidates) {
    json.begin_object().key("name").value(candidate.name).key("how").value(candidate.how);
    json.key("change").value(run_sheet(job, candidate.setups).constant_change());
    json.key("tests").value(candidate.tests()).key("changes").value(candidate.changes);
    json.key("cost").raw(to_string(candidate.cost));
    json.key("bound").raw(to_string(plan.bound.cost)).end_object();
  }
  json.end_array();
}

// The keys that the explorer's pages read, from before there was a document of a plan.
void write_plan(JsonWriter& json, const ParsedJob& asked, const PlanAnswer& answer) {
  const Job& job = *asked.job;
  const RunPlan& found = *answer.plan;
  const RunSheet& sheet = found.sheet;
  write_tests(json, job, asked.done, sheet);
  json.key("cost").raw(to_string(sheet.cost)).key("changes").value(sheet.changes);
  json.key("bound").raw(to_string(found.bound.cost)).key("reason").value(found.bound.reason);
  json.key("cheapest").value(found.proved_cheapest());
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  write_alternatives(json, job, found);
  // The sheet was counted by code that shares nothing with what made it.
  json.key("verified").value(sheet.does_the_job());
  SheetDocument document{.job = &job, .plan = &found};
  json.key("csv").value(written(document, "csv"));
}

Response plan(const Explorer& explorer, const Request& sent) {
  const OpenedRequest opened = request_of(sent);
  const JobRequest& request = opened.request;
  const ParsedJob asked = from_body([&] { return checked_job(opened, Door::document); });
  constexpr double usual_seconds = 10;
  const double most_seconds = explorer.limits.seconds.count();
  const double seconds = request.seconds.value_or(usual_seconds);
  if (seconds <= 0 || seconds > most_seconds) {
    throw Refusal{422, fmt::format("seconds: write more than 0 and at most {}", most_seconds)};
  }
  RunControl control(*RunScope::current(), std::chrono::duration<double>(seconds));
  const PlanAnswer answer = answer_to(request, asked, control);
  stop_if_asked();  // the client may have gone
  JsonWriter json;
  json.begin_object();
  if (answer.plan && !answer.what_if) {
    write_plan(json, asked, answer);
  }
  json.key(answer.diagnosis ? "diagnosis"
           : answer.what_if ? "what_if"
           : answer.benches ? "benches"
                            : "plan");
  std::string document = written(request, asked, answer, "json");
  document.pop_back();  // its end of line
  return json_response(json.raw(document).end_object().take() + "\n");
}

}  // namespace

void add_plans(Router& router, Explorer& explorer) {
  router.add(posted(explorer, "api/plan", {}, Body::json,
                    [&explorer](const Request& request) { return plan(explorer, request); }));
}

}  // namespace changeover::serve
