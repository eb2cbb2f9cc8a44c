// The options of plans, one record each.
#include "changeover/plan/job_request.hpp"
#include "io/request/option.hpp"
#include "io/request/request_document.hpp"
#include "io/request/request_schema.hpp"
#include "io/request/search_options.hpp"

namespace changeover {
namespace {

using R = JobRequest;
using K = ValueKind;

constexpr SearchTimes times_of_plans{
    .command_line = 60, .server = 10, .most_of_server = 60, .followed = 60, .most_followed = 3'600};

constexpr std::string_view of_files =
    "it is about how a file is read; rows that are sent say what they are";

std::vector<RequestOption<R>> options() {
  return with_search_options<R>(
      {
          option("parts", "", "CSV or .xlsx: one part per line, optionally with its change cost",
                 &R::parts, {.flags = "PARTS", .shape = RowShape::parts}),
          option("model", "FILE",
                 "instead of parts: parameters with their values and rules, in the language of "
                 "PICT or ACTS",
                 &R::model, {.shape = RowShape::document}),
          option("header", "", "the first row of the parts list has the names of the columns",
                 &R::header, {.not_in_python = of_files}),
          option("no_header", "", "the first row of the parts list is a part", &R::no_header,
                 {.not_in_python = of_files}),
          option("cost_column", "NAME",
                 "name of the column of the parts list with the change costs, or - for none",
                 &R::cost_column),
          option("items", "N", "use N parts named 1 to N", &R::items,
                 {.unit = "parts", .python = "parts"}),
          option("at_once", "K", "how many parts fit at once", &R::at_once,
                 {.flags = "-k,--at-once",
                  .unit = "parts",
                  .by_default = "as many as the slots hold"}),
          option("test_cost", "X", "cost of one test", &R::test_cost,
                 {.kind = K::amount, .unit = "cost"}),
          option("change_cost", "Y", "what mounting a part costs where the list does not say",
                 &R::change_cost, {.kind = K::amount, .unit = "cost"}),
          option(
              "change_costs", "FILE",
              "a square table: cost of replacing the part of the row by the part of the column; of "
              "a model: one parameter,value,cost per line",
              &R::change_costs, {.shape = RowShape::table}),
          option("cost_unit", "", "unit of all costs; with a unit of time, the sheet shows a clock",
                 &R::cost_unit,
                 {.by_default = "as the list says",
                  .words = {"money", "seconds", "minutes", "hours"}}),
          option("strength", "T", "2: every two parts must meet; 3: every three", &R::strength,
                 {.by_default = "2"}),
          option("pairs", "FILE", "pairs that must meet", &R::pairs,
                 {.by_default = "all", .shape = RowShape::pairs}),
          option("never", "FILE",
                 "pairs that must never share a set-up, one A,B,why per line (why may be left out)",
                 &R::never, {.shape = RowShape::reasons}),
          option("slots", "FILE",
                 "how many parts a set-up has in each slot, one slot,least,most per line",
                 &R::slots, {.shape = RowShape::slots}),
          option("slot", "NAME=N,...", "the same in one line, e.g. CPU=1,disk=2..4,fan=..2",
                 &R::slot, {.not_in_python = "slots is a dict there, which is as short"}),
          option("mounted", "A,B", "parts that stay mounted in every set-up", &R::mounted),
          option("start", "A,B,...", "parts that are mounted before the first test", &R::start),
          option("first", "FILE", "set-ups to run first, in this order, the parts of one per line",
                 &R::first, {.shape = RowShape::setups}),
          option(
              "weights", "FILE", "what pairs are worth, one A,B,weight per line", &R::weights,
              {.flags = "--priority", .by_default = "each is worth 1", .shape = RowShape::weights}),
          option("budget", "Z", "test as many pairs as this pays for", &R::budget,
                 {.kind = K::amount, .unit = "cost"}),
          option("done", "FILE",
                 "tests already run (one set-up per line, or a run sheet); plans the remaining "
                 "tests",
                 &R::done, {.shape = RowShape::tests}),
          option("done_first", "N", "only the first N of them were done", &R::done_first,
                 {.unit = "tests", .by_default = "all"}),
          option("trust_failed", "",
                 "pairs that met only in tests that did not pass count as tested, and are not "
                 "needed again",
                 &R::trust_failed),
          option("without", "A,B",
                 "parts, or values of a model, that can no longer be used; tests already run with "
                 "them still count",
                 &R::without),
          option("benches", "BENCHES",
                 "how many benches work side by side, or a file that lists them, one per line",
                 &R::benches, {.shape = RowShape::benches}),
          option("objective", "",
                 "of several benches: the earliest end of the last test (makespan) or the least "
                 "cost together; of a model, on one bench or several: the least cost or the fewest "
                 "tests",
                 &R::objective,
                 {.by_default = "makespan of benches, cost of a model on one",
                  .words = {"makespan", "cost", "tests"}}),
          option("hours", "H",
                 "hours of work a day, for benches that give none; costs are then in hours",
                 &R::hours, {.kind = K::amount, .unit = "hours"}),
          option("first_day", "DATE",
                 "the day of the first tests, e.g. 2025-03-31; steps then have dates",
                 &R::first_day),
          option("weekends", "", "work on Saturdays and Sundays, too", &R::weekends),
          option("what_if", "",
                 "show which plan is cheapest at which ratio of change cost to test cost",
                 &R::what_if, {.not_in_python = "a run sheet has the method what_if()"}),
          option("compact", "", "leave out the complete set-ups; print in two columns", &R::compact,
                 {.not_in_server = "it answers with data; pages lay out themselves"}),
          option("shuffle", "SEED", "swap interchangeable parts at random, with this seed",
                 &R::shuffle),
          option("diagnose", "",
                 "find the part or pair that explains the failed tests, and the next test to run",
                 &R::diagnose, {.not_in_python = "a run sheet has the method diagnose()"}),
          option("title", "TEXT", "the heading of the run sheet", &R::title),
          option("steps", "N", "moves of each local search", &R::steps,
                 {.unit = "moves", .by_default = "chosen automatically"}),
      },
      "how long to search", times_of_plans);
}

std::vector<OptionRule> rules() {
  using Says = OptionRule::Says;
  return {
      {Says::exclude, {"items", "parts"}, {}, "give either {parts} or {items=}, not both"},
      {Says::needs,
       {},
       {"parts", "items", "model"},
       "{parts} is missing; give a list of parts, or their number by {items=}"},
      {Says::needs, {"items"}, {"at_once"}},
      {Says::exclude, {"header", "no_header"}},
      {Says::exclude, {"cost_column", "no_header"}},
      {Says::exclude, {"slots", "slot"}},
      {Says::only_with, {"objective"}, {"benches", "model"}},
      {Says::only_with, {"hours", "first_day"}, {"benches"}},
      {Says::only_with, {"weekends"}, {"first_day"}},
      {Says::never_with,
       {"parts", "items", "header", "no_header", "cost_column", "at_once", "slots", "slot",
        "weights", "shuffle"},
       {"model"}},
      {Says::never_with, {"what_if", "shuffle", "compact", "done_first"}, {"benches"}},
      {Says::never_with, {"weights", "shuffle"}, {"change_costs"}},
      {Says::only_with, {"done_first", "diagnose", "trust_failed"}, {"done"}, {}, {}, "parts"},
      {Says::never_with,
       {"what_if", "budget", "title", "steps", "compact", "shuffle", "first", "weights",
        "trust_failed"},
       {"diagnose"}},
      {Says::never_with, {"compact", "shuffle"}, {"what_if"}},
      {Says::never_with, {"title", "budget", "weights"}, {"what_if"}},
      {Says::never_with, {"weights"}, {"shuffle"}},
      {Says::needs,
       {"weights"},
       {"budget"},
       "{} with {benches} says which pairs a budget pays for; give {budget=} too",
       {"benches"},
       "parts"},
      {Says::never_with,
       {"pairs", "weights", "shuffle", "what_if", "diagnose"},
       {"strength=3"},
       "{} needs {strength=2}; leave out {} or {strength=3}"},
      {Says::only_with,
       {"objective=makespan"},
       {"benches"},
       "{} is for several benches; choose another"},
      {Says::only_with, {"objective=tests"}, {"model"}, "{} is for a model; choose another"},
      {Says::needs,
       {"model"},
       {"test_cost", "objective=tests"},
       "give {test_cost=}, what it costs to run one test; or {objective=tests}, which needs no "
       "costs"},
      {Says::needs,
       {"model"},
       {"change_cost", "change_costs", "objective=tests"},
       "give {change_cost=}, what it costs to set a value, or {change_costs=} for each; or "
       "{objective=tests}, which needs no costs"},
      {Says::needs, {}, {"test_cost", "model"}, "give {test_cost=}, what it costs to run one test"},
      {Says::never_with,
       {"slots", "slot"},
       {"items"},
       "{slots} and {slot} need a parts list with a column slot; {items} says only how many parts"},
      {Says::never_with,
       {"header", "no_header"},
       {"items"},
       "{header} and {no_header} need a parts list; {items} says only how many parts"},
      {Says::never_with,
       {"cost_column"},
       {"items"},
       "{} needs a parts list; {items} says only how many parts"},
      {Says::needs,
       {"items"},
       {"change_cost", "change_costs"},
       "give {change_cost=}, what it costs to mount a part"},
  };
}

}  // namespace

const RequestTable<JobRequest>& job_table() {
  static const RequestTable<JobRequest> table{.format = "changeover-job/1",
                                              .options = options(),
                                              .rules = rules(),
                                              .times = times_of_plans};
  return table;
}

std::string to_json(const JobRequest& request) { return request_as_json(job_table(), request); }

namespace {

JobRequest read_job_request(RequestDocument document) {
  if (const JsonNode* const parts = document.find("parts");
      parts != nullptr && parts->is_number()) {
    document.rename("parts", "items");
    JobRequest request = read_request(job_table(), document);
    request.items_are_parts = true;
    return request;
  }
  return read_request(job_table(), document);
}

}  // namespace

JobRequest job_request(std::string json, std::string name, Door door) {
  return read_job_request(
      RequestDocument(job_table().format, std::move(json), std::move(name), door));
}

JobRequest job_request_sent(std::string json, std::string name) {
  RequestDocument document(job_table().format, std::move(json), std::move(name));
  document.for_server();
  return read_job_request(std::move(document));
}

std::string job_request_schema() {
  return request_schema(job_table().format, "What is asked of a plan of tests",
                        records_of(job_table()), job_table().rules);
}

void complete(JobRequest& request, JobRequest other) {
  complete<JobRequest>(job_table(), request, std::move(other));
}

}  // namespace changeover
