// The options of plans, one record each.
#include "changeover/plan/job_request.hpp"
#include "io/request/request_document.hpp"
#include "io/request/request_schema.hpp"
#include "io/request/search_options.hpp"

namespace changeover {
namespace {

using R = JobRequest;
using K = ValueKind;

constexpr std::string_view of_files =
    "it is about how a file is read; rows that are sent say what they are";

std::vector<RequestOption<R>> options() {
  return with_search_options<R>(
      {
          {{.key = "parts",
            .flags = "PARTS",
            .kind = K::list,
            .help = "CSV or .xlsx: one part per line, with its change cost or not",
            .shape = RowShape::parts},
           &R::parts},
          {{.key = "model",
            .flags = "--model",
            .kind = K::list,
            .value = "FILE",
            .help = "instead of parts: parameters with their values and rules, in the language of "
                    "PICT or ACTS",
            .shape = RowShape::document},
           &R::model},
          {{.key = "header",
            .flags = "--header",
            .help = "the first row of the parts list heads its columns",
            .not_in_python = of_files},
           &R::header},
          {{.key = "no_header",
            .flags = "--no-header",
            .help = "the first row of the parts list is a part",
            .not_in_python = of_files},
           &R::no_header},
          {{.key = "cost_column",
            .flags = "--cost-column",
            .kind = K::text,
            .value = "NAME",
            .help = "the column of the parts list that has the change costs, by its head; -: none"},
           &R::cost_column},
          {{.key = "items",
            .flags = "--items",
            .kind = K::number,
            .value = "N",
            .help = "use N parts named 1 to N",
            .python = "parts"},
           &R::items},
          {{.key = "at_once",
            .flags = "-k,--at-once",
            .kind = K::number,
            .value = "K",
            .help = "how many parts fit at once; if not given, as many as the slots hold"},
           &R::at_once},
          {{.key = "test_cost",
            .flags = "--test-cost",
            .kind = K::amount,
            .value = "X",
            .help = "cost of one test"},
           &R::test_cost},
          {{.key = "change_cost",
            .flags = "--change-cost",
            .kind = K::amount,
            .value = "Y",
            .help = "what mounting a part costs where the list does not say"},
           &R::change_cost},
          {{.key = "change_costs",
            .flags = "--change-costs",
            .kind = K::list,
            .value = "FILE",
            .help =
                "a square table: what putting in the part of the column costs where that of the "
                "row was taken out; of a model: parameter,value,cost a line",
            .shape = RowShape::table},
           &R::change_costs},
          {{.key = "cost_unit",
            .flags = "--cost-unit",
            .kind = K::word,
            .help =
                "what all costs are: with a time, a clock runs along (default: as the list says)",
            .words = {"money", "seconds", "minutes", "hours"}},
           &R::cost_unit},
          {{.key = "strength",
            .flags = "--strength",
            .kind = K::number,
            .value = "T",
            .help = "2: every two parts must meet (the default); 3: every three"},
           &R::strength},
          {{.key = "pairs",
            .flags = "--pairs",
            .kind = K::list,
            .value = "FILE",
            .help = "pairs that must meet (default: all)",
            .shape = RowShape::pairs},
           &R::pairs},
          {{.key = "never",
            .flags = "--never",
            .kind = K::list,
            .value = "FILE",
            .help = "pairs that must not be in one set-up, and why if you like: A,B,why a line",
            .shape = RowShape::reasons},
           &R::never},
          {{.key = "slots",
            .flags = "--slots",
            .kind = K::list,
            .value = "FILE",
            .help = "how many parts of each slot a set-up has: slot,least,most a line",
            .shape = RowShape::slots},
           &R::slots},
          {{.key = "slot",
            .flags = "--slot",
            .kind = K::text,
            .value = "NAME=N,…",
            .help = "the same in one line, as in CPU=1,disk=2..4,fan=..2",
            .not_in_python = "slots is a dict there, which is as short"},
           &R::slot},
          {{.key = "mounted",
            .flags = "--mounted",
            .kind = K::names,
            .value = "A,B",
            .help = "parts that stay mounted in every set-up"},
           &R::mounted},
          {{.key = "start",
            .flags = "--start",
            .kind = K::names,
            .value = "A,B,…",
            .help = "parts that are mounted before the first test"},
           &R::start},
          {{.key = "first",
            .flags = "--first",
            .kind = K::list,
            .value = "FILE",
            .help = "the set-ups that must be run first, in this order: the parts of one a line",
            .shape = RowShape::setups},
           &R::first},
          {{.key = "weights",
            .flags = "--priority",
            .kind = K::list,
            .value = "FILE",
            .help = "what pairs are worth, A,B,weight a line; others are worth 1",
            .shape = RowShape::weights},
           &R::weights},
          {{.key = "budget",
            .flags = "--budget",
            .kind = K::amount,
            .value = "Z",
            .help = "test as many pairs as this pays for"},
           &R::budget},
          {{.key = "done",
            .flags = "--done",
            .kind = K::list,
            .value = "FILE",
            .help = "tests already run (one set-up per line, or a run sheet); plans the remaining "
                    "tests",
            .shape = RowShape::tests},
           &R::done},
          {{.key = "done_first",
            .flags = "--done-first",
            .kind = K::number,
            .value = "N",
            .help = "only the first N of them were done"},
           &R::done_first},
          {{.key = "trust_failed",
            .flags = "--trust-failed",
            .help = "pairs that met only in tests that did not pass count as tested, and are not "
                    "needed again"},
           &R::trust_failed},
          {{.key = "without",
            .flags = "--without",
            .kind = K::names,
            .value = "A,B",
            .help =
                "parts that broke: they are left out from now on, and what was done stays done"},
           &R::without},
          {{.key = "benches",
            .flags = "--benches",
            .kind = K::list,
            .value = "BENCHES",
            .help = "on so many benches side by side, or on those of a list, a file with one bench "
                    "per line",
            .shape = RowShape::benches},
           &R::benches},
          {{.key = "objective",
            .flags = "--objective",
            .kind = K::word,
            .help = "of several benches: the earliest end of the last test (makespan, the default) "
                    "or the least cost together; of a model: the least cost (default) or the "
                    "fewest tests",
            .words = {"makespan", "cost", "tests"}},
           &R::objective},
          {{.key = "hours",
            .flags = "--hours",
            .kind = K::amount,
            .value = "H",
            .help =
                "hours of work a day on each bench that says nothing else, with costs in hours"},
           &R::hours},
          {{.key = "first_day",
            .flags = "--first-day",
            .kind = K::text,
            .value = "DATE",
            .help = "the day of the first tests, as 2025-03-31: steps then have dates"},
           &R::first_day},
          {{.key = "weekends",
            .flags = "--weekends",
            .help = "Saturdays and Sundays are worked on, too"},
           &R::weekends},
          {{.key = "what_if",
            .flags = "--what-if",
            .help = "which plan is cheapest at which ratio of change to test cost",
            .not_in_python = "a run sheet has the method what_if()"},
           &R::what_if},
          {{.key = "compact",
            .flags = "--compact",
            .help = "without the whole set-ups, in two columns on paper",
            .not_in_server = "it answers with data; pages lay out themselves"},
           &R::compact},
          {{.key = "shuffle",
            .flags = "--shuffle",
            .kind = K::number,
            .value = "SEED",
            .help = "exchange parts at random that nothing tells apart"},
           &R::shuffle},
          {{.key = "diagnose",
            .flags = "--diagnose",
            .help =
                "find the part or pair that explains the failed tests, and the next test to run",
            .not_in_python = "a run sheet has the method diagnose()"},
           &R::diagnose},
          {{.key = "title",
            .flags = "--title",
            .kind = K::text,
            .value = "TEXT",
            .help = "the heading of the run sheet"},
           &R::title},
          {{.key = "steps",
            .flags = "--steps",
            .kind = K::number,
            .value = "N",
            .help = "moves of each local search (default: as suits)"},
           &R::steps},
      },
      "search so long");
}

std::vector<OptionRule> rules() {
  using Says = OptionRule::Says;
  return {
      {Says::needs, {"items"}, {"at_once"}},
      {Says::exclude, {"header", "no_header"}},
      {Says::exclude, {"cost_column", "no_header"}},
      {Says::exclude, {"slots", "slot"}},
      {Says::only_with, {"objective"}, {"benches", "model"}},
      {Says::only_with, {"hours", "first_day"}, {"benches"}},
      {Says::only_with, {"weekends"}, {"first_day"}},
      {Says::never_with,
       {"parts", "items", "header", "no_header", "cost_column", "at_once", "slots", "slot",
        "benches", "without", "weights", "shuffle"},
       {"model"}},
      {Says::never_with, {"what_if", "shuffle", "compact", "done_first"}, {"benches"}},
      {Says::never_with, {"weights", "shuffle"}, {"change_costs"}},
      {Says::only_with, {"done_first", "diagnose", "trust_failed"}, {"done"}, "parts"},
      {Says::never_with,
       {"what_if", "budget", "title", "steps", "compact", "shuffle", "first", "weights",
        "trust_failed"},
       {"diagnose"}},
      {Says::never_with, {"compact", "shuffle"}, {"what_if"}},
      {Says::never_with, {"title", "budget", "weights"}, {"what_if"}},
      {Says::never_with, {"weights"}, {"shuffle"}},
  };
}

}  // namespace

const RequestTable<JobRequest>& job_table() {
  static const RequestTable<JobRequest> table{
      .format = "changeover-job/1", .options = options(), .rules = rules()};
  return table;
}

std::string to_json(const JobRequest& request) { return request_as_json(job_table(), request); }

JobRequest job_request(std::string json, std::string name) {
  RequestDocument document(job_table().format, std::move(json), std::move(name));
  if (const JsonNode* const parts = document.find("parts");
      parts != nullptr && parts->is_number()) {
    document.rename("parts", "items");
    JobRequest request = read_request(job_table(), document);
    request.items_are_parts = true;
    return request;
  }
  return read_request(job_table(), document);
}

std::string job_request_schema() {
  return request_schema(job_table().format, "What is asked of a plan of tests",
                        records_of(job_table()), job_table().rules);
}

void complete(JobRequest& request, JobRequest other) {
  complete<JobRequest>(job_table(), request, std::move(other));
}

}  // namespace changeover
