// changeover plan: the cheapest run sheet.
#include <memory>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "cli/terminal.hpp"
#include "request/request_options.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct PlanRequest {
  JobRequest job;
  RequestFileRequest file;
  RunRequest run;
  OutputRequest output;
};

// In which formats such an answer is written.
void check_format(const JobRequest& job, const OutputRequest& output) {
  const std::vector<std::pair<std::string_view, std::vector<std::string>>> formats_of{
      {"diagnose", {"table", "json", "markdown", "html", "xlsx"}},
      {"what_if", {"table", "csv", "json", "markdown"}},
      {"compact", {"table", "html"}},
      {"title", {"table", "json", "markdown", "html", "xlsx"}}};
  const RequestWords words(job_table(), job, Door::command_line);
  for (const auto& [key, formats] : formats_of) {
    const auto refusal = output.refusal(words.key(key), formats);
    if (refusal && is_given(job_table(), job, key)) {
      words.refuse(key, *refusal);
    }
  }
}

Answer show(const JobRequest& job, const OutputRequest& output) {
  OutputRequest cheap = output;
  cheap.precious = false;
  return text_answer(to_json(job), cheap);
}

Answer answer_to(const PlanRequest& request) {
  RunRequest run = request.run;
  const OpenedRequest opened = open_workbook(
      whole_request(request.job, run, job_table(), request.file, request.output, job_request));
  const JobRequest& job = opened.request;
  check_options(job, Door::command_line);
  if (request.file.show) {
    return show(job, request.output);
  }
  check_format(job, request.output);
  const CheckedJobRequest asked =
      checked_job(opened, Door::command_line, run.settings().time->count());
  // A plan may be large: it is written where it is, and never copied.
  const auto write = [&](std::shared_ptr<const PlanAnswer> found) {
    return [asked, found = std::move(found), format = request.output.format()](OutputFile& out) {
      out.write(written(asked, *found, format, terminal_width(out)));
    };
  };
  if (job.diagnose) {
    RunControl unlimited({});
    return {.output = request.output,
            .write = write(std::make_shared<PlanAnswer>(answer_to(asked, unlimited)))};
  }
  // Ctrl-C ends the program at once while it reads, and from here on asks for the best so far.
  const auto running = std::make_shared<Running>(run, request.output);
  const auto found = std::make_shared<PlanAnswer>(answer_to(asked, running->control()));
  running->finish();
  Answer answer{.output = request.output, .write = write(found)};
  if (found->shortage()) {
    answer.fault = std::make_exception_ptr(
        MissingResource("the plan may not be the best that could be found: " + *found->shortage()));
  }
  return final_answer(running, std::move(answer));
}

}  // namespace

void add_plan(Program& program) {
  auto [verb, request] = program.add<PlanRequest>(
      "plan", "find the cheapest order of tests, from your costs: a run sheet", answer_to);
  add_request_options(verb, request.job, job_table());
  request.file.add_to(verb, job_table().format);
  request.run.add_to(verb, seconds_text(job_table().times.command_line), request.output);
  request.output.add_to(verb, {"table", "csv", "json", "markdown", "html", "xlsx"});
  verb.examples(
      {"changeover plan --items 9 --at-once 3 --test-cost 1 --change-cost 5",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 -o sheet.html",
       "changeover plan parts.xlsx:Costs -k 5 --test-cost 12.50 -o run.xlsx",
       "changeover plan server.csv -k 8 --test-cost 5 --slot CPU=1,PSU=1,disk=2..4",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --budget 600 --start 1,2,3",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --done sheet.csv --done-first 7",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --done sheet.csv --diagnose",
       "changeover plan bench_parts.csv -k 5 --test-cost 12.50 --benches 2",
       "changeover plan --items 12 -k 5 --test-cost 1 --change-cost 1 --strength 3",
       "changeover plan --items 20 -k 5 --test-cost 1 --change-cost 1 --what-if"});
}

}  // namespace changeover::cli
